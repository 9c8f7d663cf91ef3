#include "PlaneGrowth.h"

#include <algorithm>
#include <limits>

#include "../grid/Parallel.h"
#include "PlaneWidth.h"
#include "SmallFlood.h"

namespace mrpt_mapconv::terrain
{
namespace
{
// as many seeds as are looked at together, at first and at most
constexpr std::size_t kFewSeeds = 8, kManySeeds = 8192;
/** Fewer are not worth a second thread. */
constexpr std::size_t kWorthThreads = 512;

/** Goes through seeds in the order of their keys. */
class SeedOrder
{
 public:
  explicit SeedOrder(const std::vector<TileCells>& seeds)
      : m_end(seeds.end()), m_band(seeds.begin())
  {
    startBand(seeds.begin());
  }

  /** The next seeds that have no plane. */
  void take(std::size_t most, std::vector<CellRef>& out)
  {
    out.clear();
    while (m_band != m_end && out.size() < most)
    {
      takeRow(most, out);
      if (m_part != m_bandEnd) continue;
      m_part = m_band;
      if (++m_iy == kTileSide) startBand(m_bandEnd);
    }
  }

 private:
  using Parts = std::vector<TileCells>::const_iterator;

  /** Tiles side by side. */
  void startBand(Parts begin)
  {
    m_band = m_part = m_bandEnd = begin;
    m_iy = 0;
    m_ix = 0;
    while (m_bandEnd != m_end && m_bandEnd->tile->ty == m_band->tile->ty) ++m_bandEnd;
  }

  void takeRow(std::size_t most, std::vector<CellRef>& out)
  {
    for (; m_part != m_bandEnd; ++m_part, m_ix = 0)
    {
      Tile& tile = *m_part->tile;
      const auto y = static_cast<std::size_t>(m_iy);
      RowBits left = m_part->bits[y] & tile.known[y] & ~tile.assigned[y] & ~RowBits{0} << m_ix;
      for (; left; left &= left - 1)
      {
        m_ix = __builtin_ctz(left);
        if (out.size() == most) return;
        out.push_back({&tile, m_ix, m_iy});
      }
    }
  }

  Parts m_end, m_band, m_bandEnd, m_part;
  std::int32_t m_ix = 0, m_iy = 0;
};
}  // namespace

bool PlaneGrowth::flood(const CellRef& seed, const Plane& plane, double tolerance)
{
  const auto open = [&](const Tile& tile, std::int32_t iy)
  {
    const auto y = static_cast<std::size_t>(iy);
    return nearPlane(plane, tolerance, tile, iy, tile.known[y] & ~tile.assigned[y]);
  };
  return m_flood.from(seed, open) >= m_search.minCells;
}

/** Whether heights crowd about the plane, as those of a plane do; spread evenly over the band that
 * is allowed, as mixed ones are, they would have an rms of 1/√3 of its half width. */
bool PlaneGrowth::isFlat(const PlaneMoments& moments) const
{
  constexpr double kCrowded = 0.45;
  return moments.rms() <= kCrowded * m_now.tolerance;
}

/** Whether what was reached is wide enough. */
bool PlaneGrowth::isWide(const PlaneMoments& moments) const
{
  if (m_search.minWidth <= 1) return true;
  if (moments.narrowness() < kNearlyFilled * m_search.minWidth) return false;
  const auto row = [this](const Tile& tile, std::int32_t iy) { return m_flood.row(tile, iy); };
  return std::any_of(m_flood.parts().begin(), m_flood.parts().end(),
                     [&](const Flood::Part& part)
                     { return hasFilledSquare(*part.tile, m_search.minWidth, row); });
}

/** Grows a plane by flood fill, refits it once and grows it once more. What is too narrow for a
 * plane, or not flat enough for the first try, is no seed any more. */
bool PlaneGrowth::growFrom(const CellRef& seed, PlaneSet& planes)
{
  if (!m_seedPlane->isPromising(seed)) return false;
  const auto found = m_seedPlane->find(seed);
  if (!found || !flood(seed, *found, m_now.tolerance)) return false;
  PlaneMoments moments = m_flood.moments(seed);
  if (!moments.spans()) return false;
  const Plane fitted = moments.fit();
  const bool isStrict = m_now.tolerance < m_search.tolerance;
  if (!isAllowed(fitted, m_search)) return false;
  if (isStrict && !(isFlat(moments) && isWide(moments)))
  {
    reject();
    return false;
  }
  if (!flood(seed, fitted, m_search.tolerance)) return false;
  moments = m_flood.moments(seed);
  if (!moments.spans() || !isAllowed(moments.fit(), m_search)) return false;
  if (!isWide(moments))
  {
    reject();
    return false;
  }
  m_flood.addPlane(moments, planes);
  return true;
}

/** Seeds that were reached are none any more. */
void PlaneGrowth::reject()
{
  for (const Flood::Part& part : m_flood.parts())
  {
    TileBits& rejected = m_rejected[part.tile];
    for (std::size_t y = 0; y < kTileSide; ++y) rejected[y] |= part.reached[y];
  }
}

bool PlaneGrowth::isRejected(const CellRef& seed) const
{
  if (m_rejected.empty()) return false;
  const auto found = m_rejected.find(seed.tile);
  return found != m_rejected.end() &&
         (found->second[static_cast<std::size_t>(seed.iy)] >> seed.ix & 1u);
}

/** Finds out which seeds would find no plane, as things are. */
void PlaneGrowth::lookAhead(const std::vector<CellRef>& seeds, int threads)
{
  m_grown.clear();
  m_hopeless.assign(seeds.size(), 0);
  grid::inParallel(seeds.size(), seeds.size() < kWorthThreads ? 1 : threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     SeedPlane seedPlane(*m_seedPlane);
                     SmallFlood small(m_now);
                     for (std::size_t i = begin; i < end; ++i)
                     {
                       m_hopeless[i] = true;
                       if (isRejected(seeds[i]) || !seedPlane.isPromising(seeds[i])) continue;
                       const auto plane = seedPlane.find(seeds[i]);
                       m_hopeless[i] = !plane || !small.mayBePlane(seeds[i], *plane);
                     }
                   });
}

/** A seed's plane depends on its window. Planes elsewhere can only have taken cells from it. */
bool PlaneGrowth::isStillHopeless(const CellRef& seed, std::size_t index) const
{
  if (!m_hopeless[index]) return false;
  const std::int32_t x = seed.keyX(), y = seed.keyY(), r = m_search.window;
  return std::none_of(
      m_grown.begin(), m_grown.end(),
      [&](const KeyBox& box)
      { return box.xMin <= x + r && box.xMax >= x - r && box.yMin <= y + r && box.yMax >= y - r; });
}

PlaneGrowth::KeyBox PlaneGrowth::reachedBox() const
{
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
  KeyBox box{kMost, kMost, -kMost, -kMost};
  for (const Flood::Part& part : m_flood.parts())
  {
    RowBits columns = 0, rows = 0;
    forEachBit(part.evaluated,
               [&](std::int32_t iy)
               {
                 const RowBits row = part.reached[static_cast<std::size_t>(iy)];
                 columns |= row;
                 rows |= row ? RowBits{1} << iy : 0;
               });
    if (!columns) continue;
    box.xMin = std::min(box.xMin, part.tile->keyX(lowestOf(columns)));
    box.xMax = std::max(box.xMax, part.tile->keyX(highestOf(columns)));
    box.yMin = std::min(box.yMin, part.tile->keyY(lowestOf(rows)));
    box.yMax = std::max(box.yMax, part.tile->keyY(highestOf(rows)));
  }
  return box;
}

void PlaneGrowth::grow(const std::vector<TileCells>& seeds, PlaneSet& planes, int threads)
{
  if (seeds.empty()) return;
  growWith(m_search.tolerance / 2, seeds, planes, threads);
  growWith(m_search.tolerance, seeds, planes, threads);
}

void PlaneGrowth::growWith(double tolerance, const std::vector<TileCells>& seeds, PlaneSet& planes,
                           int threads)
{
  m_now = m_search;
  m_now.tolerance = tolerance;
  m_seedPlane.emplace(m_now);
  SeedOrder order(seeds);
  m_rejected.clear();
  std::vector<CellRef> next;
  std::size_t many = kFewSeeds;
  for (order.take(many, next); !next.empty(); order.take(many, next))
  {
    lookAhead(next, threads);
    many = std::min(kManySeeds, 2 * many);
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      const CellRef& seed = next[i];
      if (seed.tile->plane[seed.index()] != kNoPlane || isRejected(seed) ||
          isStillHopeless(seed, i))
        continue;
      if (!growFrom(seed, planes)) continue;
      m_grown.push_back(reachedBox());
      many = kFewSeeds;
    }
  }
}

}  // namespace mrpt_mapconv::terrain
