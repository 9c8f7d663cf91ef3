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
  std::vector<char> wanted;         //!< cells that are found anew; empty: all
  std::int32_t wantedX0 = 0, wantedY0 = 0, wantedXEnd = 0, wantedYEnd = 0;  //!< they lie in here

  void want(std::int32_t x, std::int32_t y)
  {
    const bool first = wantedX0 == wantedXEnd;
    wantedX0 = first ? x : std::min(wantedX0, x);
    wantedY0 = first ? y : std::min(wantedY0, y);
    wantedXEnd = first ? x + 1 : std::max(wantedXEnd, x + 1);
    wantedYEnd = first ? y + 1 : std::max(wantedYEnd, y + 1);
    wanted[window.index(x, y)] = 1;
  }
};

SupportRules::SupportRules(const ConversionParams& params, double resolution)
    : step(params.maxStepVoxels(resolution)), hiddenSlack(std::max(step, 1))
{
  constexpr double kSlack = 1e-6;  // of a cell
  const auto cells = [&](double metres) { return metres / resolution + kSlack; };
  const auto squareOf = [&](double metres)
  { return static_cast<std::int32_t>(std::min(cells(metres) * cells(metres), 1e9)); };
  maxHiddenSq = squareOf(params.maxHiddenGap);
  maxGapSq = std::max(squareOf(params.maxGap), maxHiddenSq);
  reach = static_cast<std::int32_t>(std::sqrt(static_cast<double>(maxGapSq)) + 1e-9);
}

SupportPass::SupportPass(const ConversionParams& params, const HiddenTops& hidden, Layers& layers)
    : m_hidden(hidden), m_layers(layers), m_rules(params, layers.frame().resolution)
{
}

void SupportPass::findAll(int threads)
{
  // Each band of rows also has to sweep those within reach around it, so there are few; but what a
  // band keeps beside the layers should not grow with the map.
  constexpr std::int32_t kMostRows = 1024;
  const grid::GridFrame& frame = m_layers.frame();
  const std::int32_t cores =
      threads > 0 ? threads : static_cast<std::int32_t>(std::thread::hardware_concurrency());
  const std::int32_t shared = std::clamp(frame.height / (4 * m_rules.reach + 1), 1, cores);
  const std::int32_t bands = std::max(shared, frame.height / kMostRows);
  grid::inParallel(static_cast<std::size_t>(bands), shared,
                   [&](std::size_t begin, std::size_t end)
                   {
                     const auto rowOf = [&](std::size_t band)
                     {
                       return static_cast<std::int32_t>(band *
                                                        static_cast<std::size_t>(frame.height) /
                                                        static_cast<std::size_t>(bands));
                     };
                     const std::int32_t yBegin = rowOf(begin), yEnd = rowOf(end);
                     Offers offers({0, yBegin, frame.width, yEnd - yBegin});
                     const std::int32_t yFrom = std::max(0, yBegin - m_rules.reach),
                                        yTo = std::min(frame.height, yEnd + m_rules.reach);
                     sweep({0, yFrom, frame.width, yTo - yFrom}, offers);
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

/** Not (e): something stands on cell k, known though it is under the floor. */
bool SupportPass::isBlocked(const SupportLine& line, std::int32_t k, std::int32_t floor) const
{
  if (m_rules.isStepAtMost(line, k, floor)) return false;
  const grid::GridFrame& frame = m_layers.frame();
  const auto top = m_hidden.at(frame.x0 + line.x + k * line.dx, frame.y0 + line.y + k * line.dy);
  return top && !m_rules.isStepAtMost(line, k, *top);
}

/** Gives a line to the open cells on it that it supports better than the lines before: the shorter
 * gap, then the lower line. */
void SupportPass::offer(const SupportLine& line, Offers& offers) const
{
  if (!m_rules.allows(line)) return;
  const grid::GridFrame& frame = m_layers.frame();
  const double inverse = 1.0 / frame.resolution;
  const auto forEachOpen = [&](const auto& visit)
  {
    for (std::int32_t k = 1; k < line.n; ++k)
    {
      const std::int32_t x = line.x + k * line.dx, y = line.y + k * line.dy;
      if (!isOpen(m_layers.evidence.at(x, y))) continue;
      if (!visit(k, x, y, heightKey(m_layers.floor.at(x, y), inverse))) return false;
    }
    return true;
  };
  if (!forEachOpen([&](std::int32_t k, std::int32_t, std::int32_t, std::int32_t floor)
                   { return !m_rules.refutes(line, k, floor); }))
    return;
  const std::int32_t gapSq = line.gapSq();
  forEachOpen(
      [&](std::int32_t k, std::int32_t x, std::int32_t y, std::int32_t floor)
      {
        if (!offers.window.contains(x, y) || !m_rules.supports(line, k, floor)) return true;
        const std::size_t cell = offers.window.index(x, y);
        if (!offers.wanted.empty() && !offers.wanted[cell]) return true;
        if (isBlocked(line, k, floor)) return true;
        const auto support =
            static_cast<float>(line.unitsAt(k) * (frame.resolution / kSupportUnits));
        float& best = m_layers.support.at(x, y);
        if (gapSq > offers.gapSq[cell] || (gapSq == offers.gapSq[cell] && support >= best))
          return true;
        best = support;
        offers.gapSq[cell] = gapSq;
        return true;
      });
}

/** Marks the open cells whose segments a cell lies on, or ends: along each axis as far as the next
 * seen cell or wall. */
void SupportPass::markAround(std::int32_t ix, std::int32_t iy, Offers& offers) const
{
  const auto mark = [&](std::int32_t x, std::int32_t y)
  {
    if (!offers.window.contains(x, y) || !isOpen(m_layers.evidence.at(x, y))) return false;
    offers.want(x, y);
    return true;
  };
  const auto isBetween = [&](std::int32_t x, std::int32_t y)
  {
    if (!offers.window.contains(x, y)) return false;
    const float evidence = m_layers.evidence.at(x, y);
    return evidence != kSeen && evidence != kWall;
  };
  mark(ix, iy);
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      for (std::int32_t k = 1; k <= m_rules.reach && (dx != 0 || dy != 0); ++k)
      {
        if (!isBetween(ix + k * dx, iy + k * dy)) break;
        mark(ix + k * dx, iy + k * dy);
      }
}

voxel::ColumnSet SupportPass::findAround(const voxel::ColumnSet& changed)
{
  voxel::ColumnSet different = changed;
  const grid::GridFrame& frame = m_layers.frame();
  const auto withinReach =
      [&](std::int32_t x0, std::int32_t y0, std::int32_t xEnd, std::int32_t yEnd)
  {
    const std::int32_t fromX = std::max(0, x0 - m_rules.reach),
                       fromY = std::max(0, y0 - m_rules.reach);
    return Window{fromX, fromY, std::min(frame.width, xEnd + m_rules.reach) - fromX,
                  std::min(frame.height, yEnd + m_rules.reach) - fromY};
  };
  const grid::GridFrame box = changed.bounds(frame.resolution);
  Offers offers(withinReach(box.x0 - frame.x0, box.y0 - frame.y0, box.xEnd() - frame.x0,
                            box.yEnd() - frame.y0));
  offers.wanted.assign(offers.gapSq.size(), 0);
  changed.forEach([&](std::int32_t kx, std::int32_t ky)
                  { markAround(kx - frame.x0, ky - frame.y0, offers); });

  struct Before
  {
    std::int32_t x, y;
    float support;
  };
  std::vector<Before> before;
  for (std::int32_t y = offers.wantedY0; y < offers.wantedYEnd; ++y)
    for (std::int32_t x = offers.wantedX0; x < offers.wantedXEnd; ++x)
    {
      if (!offers.wanted[offers.window.index(x, y)]) continue;
      float &support = m_layers.support.at(x, y), &known = m_layers.evidence.at(x, y);
      before.push_back({x, y, support});
      support = Layers::kNone;
      known = evidence::kOpen;
    }
  if (before.empty()) return different;
  sweep(withinReach(offers.wantedX0, offers.wantedY0, offers.wantedXEnd, offers.wantedYEnd),
        offers);
  for (const Before& b : before)
  {
    const float support = m_layers.support.at(b.x, b.y);
    if (!std::isnan(support)) m_layers.evidence.at(b.x, b.y) = evidence::kInferred;
    if (support != b.support && !(std::isnan(support) && std::isnan(b.support)))
      different.insert(b.x + frame.x0, b.y + frame.y0);
  }
  return different;
}

}  // namespace mrpt_mapconv::freespace
