#include "SupportPass.h"

#include <mrpt_mapconv/freespace/Evidence.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "../grid/Parallel.h"
#include "FloorTile.h"

namespace mrpt_mapconv::freespace
{
using evidence::isOpen;
using evidence::kSeen;
using evidence::kWall;

namespace
{
constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::min();

/** The last seen cell on each of many parallel lines; none where a wall came after it. */
class LastSeen
{
 public:
  explicit LastSeen(std::int32_t lines) : m_row(static_cast<std::size_t>(lines), kNever) {}
  std::int32_t& operator[](std::int32_t line) { return m_row[static_cast<std::size_t>(line)]; }

 private:
  std::vector<std::int32_t> m_row;
};
}  // namespace

struct SupportPass::Offers
{
  explicit Offers(const Window& cells)
      : window(cells),
        gapSq(static_cast<std::size_t>(cells.width) * static_cast<std::size_t>(cells.height),
              std::numeric_limits<std::int32_t>::max())
  {
  }

  Window window;                    //!< cells that may be written
  std::vector<std::int32_t> gapSq;  //!< of the line that a cell has its support from [cells²]
};

SupportRules::SupportRules(const ConversionParams& params, double resolution)
    : step(params.maxStepVoxels(resolution)),
      standing(params.looksForSteps() ? step : 1),
      clearance(params.minRunVoxels(resolution)),
      hiddenSlack(std::max(step, 1))
{
  constexpr double kSlack = 1e-6;  // of a cell
  const auto cells = [&](double metres) { return metres / resolution + kSlack; };
  const auto squareOf = [&](double metres)
  { return static_cast<std::int32_t>(std::min(cells(metres) * cells(metres), 1e9)); };
  maxGapSq = squareOf(params.maxGap);
  maxHiddenSq = std::min(squareOf(params.maxHiddenGap), maxGapSq);
  reach = static_cast<std::int32_t>(std::sqrt(static_cast<double>(maxGapSq)) + 1e-9);
}

SupportPass::SupportPass(const ConversionParams& params, const OpenColumns& open, Layers& layers)
    : m_open(open), m_layers(layers), m_rules(params, layers.frame().resolution)
{
}

void SupportPass::findAll(int threads)
{
  // Each band of rows also has to sweep those within reach around it, so there are few; but what a
  // band keeps beside the layers should not grow with the map.
  constexpr std::int32_t kMostRows = 1024;
  const grid::GridFrame& frame = m_layers.frame();
  const std::int32_t cores = std::max(
      1, threads > 0 ? threads : static_cast<std::int32_t>(std::thread::hardware_concurrency()));
  const std::int32_t shared = std::clamp(frame.height / (4 * m_rules.reach + 1), 1, cores);
  const std::int32_t bands = std::max(shared, (frame.height + kMostRows - 1) / kMostRows);
  grid::inParallel(static_cast<std::size_t>(bands), shared,
                   [&](std::size_t begin, std::size_t end)
                   {
                     const auto rowOf = [&](std::size_t band)
                     {
                       return static_cast<std::int32_t>(band *
                                                        static_cast<std::size_t>(frame.height) /
                                                        static_cast<std::size_t>(bands));
                     };
                     for (std::size_t band = begin; band < end; ++band)
                     {
                       const std::int32_t y = rowOf(band), yEnd = rowOf(band + 1);
                       Offers offers({0, y, frame.width, yEnd - y});
                       const std::int32_t from = std::max(0, y - m_rules.reach),
                                          to = std::min(frame.height, yEnd + m_rules.reach);
                       sweep({0, from, frame.width, to - from}, offers);
                     }
                   });
  // Only now: a sweep reads the evidence of rows that belong to another one.
  float* known = m_layers.evidence.cells().data();
  const float* support = m_layers.support.cells().data();
  const std::size_t cells = m_layers.evidence.cells().size();
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    const bool inferred = (known[cell] == evidence::kOpen) & (support[cell] == support[cell]);
    known[cell] = inferred ? evidence::kInferred : known[cell];
  }
}

/** Goes through the cells row by row. Each seen cell ends a segment on every axis on which there
 * was a seen cell before it. */
void SupportPass::sweep(const Window& window, Offers& offers) const
{
  const std::int32_t w = window.width, h = window.height;
  // of a column, and of the two diagonals, the row of the last seen cell
  LastSeen columns(w), rising(w + h), falling(w + h);
  const double inverse = 1.0 / m_layers.frame().resolution;
  const auto keyAt = [&](std::int32_t x, std::int32_t y)
  { return heightKey(m_layers.floor.at(x, y), inverse); };
  for (std::int32_t y = 0; y < h; ++y)
  {
    const float* row = m_layers.evidence.row(window.y0 + y) + window.x0;
    std::int32_t lastX = kNever;
    for (std::int32_t x = 0; x < w; ++x)
    {
      if (row[x] != kSeen && row[x] != kWall) continue;
      std::int32_t &column = columns[x], &rise = rising[x - y + h], &fall = falling[x + y];
      if (row[x] == kSeen)
      {
        const auto end = [&](std::int32_t n, std::int32_t dx, std::int32_t dy)
        {
          if (n <= 1 || n > m_rules.reach) return;
          const std::int32_t ix = window.x0 + x, iy = window.y0 + y;
          const std::int32_t fromX = ix - n * dx, fromY = iy - n * dy;
          offer({fromX, fromY, dx, dy, n, keyAt(fromX, fromY), keyAt(ix, iy)}, offers);
        };
        if (lastX != kNever) end(x - lastX, 1, 0);
        if (column != kNever) end(y - column, 0, 1);
        if (rise != kNever) end(y - rise, 1, 1);
        if (fall != kNever) end(y - fall, -1, 1);
      }
      lastX = row[x] == kSeen ? x : kNever;
      column = rise = fall = row[x] == kSeen ? y : kNever;
    }
  }
}

/** Not (e): something known is in a robot's way on cell k. */
bool SupportPass::isBlocked(const SupportLine& line, std::int32_t k, std::int32_t floor) const
{
  if (!m_rules.mayBeBlocked(line, k, floor)) return false;
  const grid::GridFrame& frame = m_layers.frame();
  const auto open = m_open.at(frame.x0 + line.x + k * line.dx, frame.y0 + line.y + k * line.dy);
  return open && m_rules.isBlocked(line, k, floor, *open);
}

/** Calls visit(k, x, y, floor) for the open cells of a line until it returns false.
 * \return whether it never did */
template <class Visit>
bool SupportPass::forEachOpen(const SupportLine& line, const Visit& visit) const
{
  const double inverse = 1.0 / m_layers.frame().resolution;
  for (std::int32_t k = 1; k < line.n; ++k)
  {
    const std::int32_t x = line.x + k * line.dx, y = line.y + k * line.dy;
    if (!isOpen(m_layers.evidence.at(x, y))) continue;
    if (!visit(k, x, y, heightKey(m_layers.floor.at(x, y), inverse))) return false;
  }
  return true;
}

/** (d): no open cell on the line shows that the ground lies lower. */
bool SupportPass::isGround(const SupportLine& line) const
{
  return forEachOpen(line, [&](std::int32_t k, std::int32_t, std::int32_t, std::int32_t floor)
                     { return !m_rules.refutes(line, k, floor); });
}

float SupportPass::heightAt(const SupportLine& line, std::int32_t k) const
{
  return static_cast<float>(line.unitsAt(k) * (m_layers.frame().resolution / kSupportUnits));
}

/** Gives a line to the open cells on it that it supports better than the lines before: the shorter
 * gap, then the lower line. */
void SupportPass::offer(const SupportLine& line, Offers& offers) const
{
  if (!m_rules.allows(line) || !isGround(line)) return;
  const std::int32_t gapSq = line.gapSq();
  forEachOpen(line,
              [&](std::int32_t k, std::int32_t x, std::int32_t y, std::int32_t floor)
              {
                if (!offers.window.contains(x, y) || !m_rules.supports(line, k, floor)) return true;
                const std::size_t cell = offers.window.index(x, y);
                if (isBlocked(line, k, floor)) return true;
                const float support = heightAt(line, k);
                float& best = m_layers.support.at(x, y);
                if (gapSq > offers.gapSq[cell] || (gapSq == offers.gapSq[cell] && support >= best))
                  return true;
                best = support;
                offers.gapSq[cell] = gapSq;
                return true;
              });
}

/** How many steps lead from a cell to the nearest seen one; 0 if a wall is before it, or there is
 * none within reach. */
std::int32_t SupportPass::stepsToSeen(std::int32_t ix, std::int32_t iy, std::int32_t dx,
                                      std::int32_t dy) const
{
  const grid::GridFrame& frame = m_layers.frame();
  for (std::int32_t k = 1; k < m_rules.reach; ++k)
  {
    const std::int32_t x = ix + k * dx, y = iy + k * dy;
    if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return 0;
    const float known = m_layers.evidence.at(x, y);
    if (known == kSeen) return k;
    if (known == kWall) return 0;
  }
  return 0;
}

/** The support of one open cell, by its own four lines; NaN: none. */
float SupportPass::supportOf(std::int32_t ix, std::int32_t iy) const
{
  const double inverse = 1.0 / m_layers.frame().resolution;
  const auto keyAt = [&](std::int32_t x, std::int32_t y)
  { return heightKey(m_layers.floor.at(x, y), inverse); };
  const std::int32_t floor = keyAt(ix, iy);
  float best = Layers::kNone;
  std::int32_t bestGapSq = std::numeric_limits<std::int32_t>::max();
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}})
  {
    const std::int32_t forth = stepsToSeen(ix, iy, dx, dy);
    const std::int32_t back = forth == 0 ? 0 : stepsToSeen(ix, iy, -dx, -dy);
    if (back == 0 || back + forth > m_rules.reach) continue;
    const std::int32_t x = ix - back * dx, y = iy - back * dy;
    const SupportLine line{
        x, y, dx, dy, back + forth, keyAt(x, y), keyAt(ix + forth * dx, iy + forth * dy)};
    if (line.gapSq() > bestGapSq || !m_rules.allows(line) || !m_rules.supports(line, back, floor) ||
        isBlocked(line, back, floor) || !isGround(line))
      continue;
    const float support = heightAt(line, back);
    if (line.gapSq() == bestGapSq && support >= best) continue;
    best = support;
    bestGapSq = line.gapSq();
  }
  return best;
}

/** Adds the open cells whose segments a changed cell lies on, or ends: along each axis as far as
 * the next seen cell or wall, or the next changed cell, which looks further itself. */
void SupportPass::addAround(std::int32_t kx, std::int32_t ky, const voxel::ColumnSet& changed,
                            voxel::ColumnSet& open) const
{
  const grid::GridFrame& frame = m_layers.frame();
  const auto evidenceAt = [&](std::int32_t x, std::int32_t y)
  { return frame.containsKey(x, y) ? m_layers.evidence.cells()[frame.indexOfKey(x, y)] : kWall; };
  if (isOpen(evidenceAt(kx, ky))) open.insert(kx, ky);
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      for (std::int32_t k = 1; k <= m_rules.reach && (dx != 0 || dy != 0); ++k)
      {
        const std::int32_t x = kx + k * dx, y = ky + k * dy;
        const float known = evidenceAt(x, y);
        if (known == kSeen || known == kWall || changed.contains(x, y)) break;
        if (isOpen(known)) open.insert(x, y);
      }
}

voxel::ColumnSet SupportPass::findAround(const voxel::ColumnSet& changed)
{
  const grid::GridFrame& frame = m_layers.frame();
  voxel::ColumnSet open, different = changed;
  changed.forEach([&](std::int32_t kx, std::int32_t ky) { addAround(kx, ky, changed, open); });
  open.forEach(
      [&](std::int32_t kx, std::int32_t ky)
      {
        const std::size_t cell = frame.indexOfKey(kx, ky);
        const float before = m_layers.support.cells()[cell];
        const float now = supportOf(kx - frame.x0, ky - frame.y0);
        m_layers.support.cells()[cell] = now;
        m_layers.evidence.cells()[cell] = std::isnan(now) ? evidence::kOpen : evidence::kInferred;
        if (now != before && !(std::isnan(now) && std::isnan(before))) different.insert(kx, ky);
      });
  return different;
}

}  // namespace mrpt_mapconv::freespace
