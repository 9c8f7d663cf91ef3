#include "SeedPlane.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "../grid/Wide.h"

namespace mrpt_mapconv::terrain
{
namespace
{
/** Steele, Lea and Flood 2014. */
std::uint64_t mixed(std::uint64_t v)
{
  v = (v ^ v >> 30) * 0xBF58476D1CE4E5B9u;
  v = (v ^ v >> 27) * 0x94D049BB133111EBu;
  return v ^ v >> 31;
}

/** As often cells are drawn anew for those that are not free: amid a floor few are. */
constexpr int kMostDraws = 8;

/** Hypotheses are worked on so many at once; what is beyond the last is not used. */
constexpr std::size_t kLanes = 8;
std::size_t padded(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

/** Slopes of the planes through the origin and pairs of cells; not finite if on one line. */
MRPT_MAPCONV_WIDE
void slopesOf(const float* __restrict x, const float* __restrict y, const float* __restrict z,
              std::size_t pairs, float* __restrict gx, float* __restrict gy)
{
  for (std::size_t i = 0; i < pairs; ++i)
  {
    const float ax = x[2 * i], ay = y[2 * i], az = z[2 * i];
    const float bx = x[2 * i + 1], by = y[2 * i + 1], bz = z[2 * i + 1];
    const float det = ax * by - bx * ay;
    gx[i] = (az * by - bz * ay) / det;
    gy[i] = (ax * bz - bx * az) / det;
  }
}

/** Adds max(0, tolerance − |dz − (gx·dx + gy·dy)|) of all cells to the scores. */
MRPT_MAPCONV_WIDE
void addScores(const float* __restrict gx, const float* __restrict gy, float* __restrict score,
               std::size_t hypotheses, const float* __restrict dx, const float* __restrict dy,
               const float* __restrict dz, std::size_t cells, float tolerance)
{
  for (std::size_t first = 0; first < hypotheses; first += kLanes)
  {
    float sum[kLanes];
    for (std::size_t j = 0; j < kLanes; ++j) sum[j] = score[first + j];
    for (std::size_t i = 0; i < cells; ++i)
      for (std::size_t j = 0; j < kLanes; ++j)
      {
        const float off = dz[i] - (gx[first + j] * dx[i] + gy[first + j] * dy[i]);
        const float left = tolerance - (off < 0 ? -off : off);
        sum[j] += left > 0 ? left : 0;
      }
    for (std::size_t j = 0; j < kLanes; ++j) score[first + j] = sum[j];
  }
}

/** How many are better than each: those of a higher score, and equal ones before it. */
MRPT_MAPCONV_WIDE
void countBetter(const float* __restrict score, std::size_t count, std::int32_t* __restrict better)
{
  for (std::size_t i = 0; i < padded(count); ++i) better[i] = 0;
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i < padded(count); ++i)
      better[i] += score[j] > score[i] || (score[j] == score[i] && j < i) ? 1 : 0;
}
}  // namespace

SeedPlane::SeedPlane(const PlaneSearch& search)
    : m_search(search),
      m_besideReach(search.mostSlope + search.tolerance),
      m_diagonalReach(search.mostSlope * std::sqrt(2.0) + search.tolerance)
{
  auto places = std::make_shared<std::vector<Place>>();
  const std::int32_t r = search.window;
  for (std::int32_t dy = -r; dy <= r; ++dy)
    for (std::int32_t dx = -r; dx <= r; ++dx)
      places->push_back({static_cast<float>(dx), static_cast<float>(dy),
                         static_cast<std::int16_t>(dx + dy * kTileSide),
                         static_cast<std::int8_t>(dx), static_cast<std::int8_t>(dy)});
  m_places = std::move(places);
}

std::uint64_t SeedPlane::random() { return mixed(m_random += 0x9E3779B97F4A7C15u); }

bool SeedPlane::isWithinTile(const CellRef& seed) const
{
  const std::int32_t r = m_search.window;
  return std::min(seed.ix, seed.iy) >= r && std::max(seed.ix, seed.iy) < kTileSide - r;
}

bool SeedPlane::isPromising(const CellRef& seed) const
{
  const std::int32_t needed = m_search.minWidth >= 3 ? 6 : m_search.minWidth;
  const std::int32_t z = seed.tile->height[seed.index()];
  std::int32_t near = 0;
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx)
    {
      const CellRef cell = cellAt(*seed.tile, seed.ix + dx, seed.iy + dy);
      if (!cell || (dx == 0 && dy == 0)) continue;
      const std::size_t at = cell.index(), y = static_cast<std::size_t>(cell.iy);
      const bool isFree = (cell.tile->known[y] & ~cell.tile->assigned[y]) >> cell.ix & 1u;
      const double off = std::abs(cell.tile->height[at] - z);
      near += isFree && off <= (dx == 0 || dy == 0 ? m_besideReach : m_diagonalReach) ? 1 : 0;
    }
  return near >= needed;
}

/** Draws so many, and puts those that are known and free behind `cells` others. \return how many
 * there are then */
std::size_t SeedPlane::draw(const CellRef& seed, std::size_t count, std::size_t cells, Drawn& out)
{
  const Place* places = m_places->data();
  const std::size_t area = m_places->size();
  const bool isWithin = isWithinTile(seed);
  const auto seedAt = static_cast<std::int32_t>(seed.index());
  const std::int32_t z = seed.tile->height[seed.index()];
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < count; ++i, bits >>= 16)
  {
    if (i % 4 == 0) bits = random();
    const Place& place = places[(bits & 0xFFFFu) * area >> 16];
    const Tile* tile = seed.tile;
    auto at = static_cast<std::size_t>(seedAt + place.flat);
    if (!isWithin)
    {
      const CellRef cell = cellAt(*seed.tile, seed.ix + place.ix, seed.iy + place.iy);
      if (!cell) continue;
      tile = cell.tile;
      at = cell.index();
    }
    out.dx[cells] = place.dx;
    out.dy[cells] = place.dy;
    out.dz[cells] = static_cast<float>(tile->height[at] - z);
    const std::size_t y = at >> kTileBits;
    cells += (tile->known[y] & ~tile->assigned[y]) >> (at & kTileMask) & 1u;
  }
  return cells;
}

/** Planes through the seed and two other cells; at most K. */
std::size_t SeedPlane::makeHypotheses(const CellRef& seed)
{
  const auto wanted = 2 * static_cast<std::size_t>(m_search.hypotheses);
  std::size_t cells = 0;
  for (int time = 0; time < kMostDraws && cells < wanted; ++time)
    cells = draw(seed, wanted - cells, cells, m_drawn);
  const std::size_t pairs = cells / 2;
  slopesOf(m_drawn.dx.data(), m_drawn.dy.data(), m_drawn.dz.data(), pairs, m_gx.data(),
           m_gy.data());
  const auto most = static_cast<float>(m_search.mostSlope * m_search.mostSlope);
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs; ++i)
  {
    const float gx = m_gx[i], gy = m_gy[i];
    m_gx[count] = gx;
    m_gy[count] = gy;
    m_score[count] = 0;
    count += gx * gx + gy * gy <= most ? 1 : 0;
  }
  return count;
}

/** Moves the best to the front, in their order. */
std::size_t SeedPlane::keepBest(std::size_t hypotheses, std::size_t kept)
{
  std::array<std::int32_t, kMostHypotheses> better;
  countBetter(m_score.data(), hypotheses, better.data());
  std::size_t count = 0;
  for (std::size_t i = 0; i < hypotheses; ++i)
  {
    m_gx[count] = m_gx[i];
    m_gy[count] = m_gy[i];
    m_score[count] = m_score[i];
    count += better[i] < static_cast<std::int32_t>(kept) ? 1 : 0;
  }
  return kept;
}

/** Moves the winner to the front. */
void SeedPlane::findWinner(const CellRef& seed, std::size_t hypotheses)
{
  while (hypotheses > 1)
  {
    auto left = static_cast<std::size_t>(m_search.blockCells);
    while (left > 0)  // in parts that there is room for
    {
      const std::size_t part = std::min(left, m_drawn.dx.size());
      const std::size_t cells = draw(seed, part, 0, m_drawn);
      addScores(m_gx.data(), m_gy.data(), m_score.data(), hypotheses, m_drawn.dx.data(),
                m_drawn.dy.data(), m_drawn.dz.data(), cells,
                static_cast<float>(m_search.tolerance));
      left -= part;
    }
    hypotheses = keepBest(hypotheses, hypotheses / 2);
  }
}

std::optional<Plane> SeedPlane::find(const CellRef& seed)
{
  m_random = mixed(static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed.keyX())) << 32 |
                   static_cast<std::uint32_t>(seed.keyY()));
  const std::size_t hypotheses = makeHypotheses(seed);
  if (hypotheses == 0) return std::nullopt;
  findWinner(seed, hypotheses);
  Plane plane;
  plane.originX = seed.keyX();
  plane.originY = seed.keyY();
  plane.height = seed.tile->height[seed.index()];
  plane.slopeX = static_cast<double>(m_gx[0]);
  plane.slopeY = static_cast<double>(m_gy[0]);
  return plane;
}

}  // namespace mrpt_mapconv::terrain
