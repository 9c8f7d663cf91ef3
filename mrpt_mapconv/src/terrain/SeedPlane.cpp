#include "SeedPlane.h"

#include <algorithm>
#include <cmath>

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

/** The bits of a row from column `from` to `to`, which may reach into the tiles beside it. */
template <class Visit>
void forEachFree(Tile& tile, std::int32_t iy, std::int32_t from, std::int32_t to,
                 const Visit& visit)
{
  for (std::int32_t side = from >> kTileBits; side <= to >> kTileBits; ++side)
  {
    Tile* beside = tile.neighbour(side, iy >> kTileBits);
    if (!beside) continue;
    const std::int32_t first = std::max(from, side * kTileSide),
                       last = std::min(to, side * kTileSide + kTileMask);
    const auto y = static_cast<std::size_t>(iy & kTileMask);
    const RowBits within =
        ~RowBits{0} << (first & kTileMask) & ~RowBits{0} >> (kTileMask - (last & kTileMask));
    const std::int32_t* heights = beside->height.data() + y * kTileSide;
    forEachBit(beside->known[y] & ~beside->assigned[y] & within,
               [&](std::int32_t bit) { visit(side * kTileSide + bit, heights[bit]); });
  }
}

void addScores(const float* __restrict gx, const float* __restrict gy, float* __restrict score,
               std::size_t hypotheses, float dx, float dy, float dz, float tolerance)
{
  for (std::size_t j = 0; j < hypotheses; ++j)
  {
    const float left = tolerance - std::fabs(dz - (gx[j] * dx + gy[j] * dy));
    score[j] += left > 0 ? left : 0;
  }
}
}  // namespace

std::uint64_t SeedPlane::random() { return mixed(m_random += 0x9E3779B97F4A7C15u); }

void SeedPlane::collectAll(const CellRef& seed)
{
  const std::int32_t z = seed.tile->height[seed.index()], r = m_search.window;
  for (std::int32_t dy = -r; dy <= r; ++dy)
    forEachFree(*seed.tile, seed.iy + dy, seed.ix - r, seed.ix + r,
                [&](std::int32_t ix, std::int32_t height)
                {
                  const std::int32_t dx = ix - seed.ix;
                  if (dx == 0 && dy == 0) return;
                  m_dx[m_cells] = static_cast<float>(dx);
                  m_dy[m_cells] = static_cast<float>(dy);
                  m_dz[m_cells++] = static_cast<float>(std::int64_t{height} - z);
                });
}

void SeedPlane::take(const CellRef& seed, std::int32_t dx, std::int32_t dy)
{
  const CellRef cell = cellAt(*seed.tile, seed.ix + dx, seed.iy + dy);
  if (!cell || (dx == 0 && dy == 0) || !cell.tile->isKnown(cell.ix, cell.iy) ||
      cell.tile->plane[cell.index()] != kNoPlane)
    return;
  const std::int64_t z = seed.tile->height[seed.index()];
  m_dx[m_cells] = static_cast<float>(dx);
  m_dy[m_cells] = static_cast<float>(dy);
  m_dz[m_cells++] = static_cast<float>(cell.tile->height[cell.index()] - z);
}

void SeedPlane::draw(const CellRef& seed)
{
  const auto side = static_cast<std::size_t>(2 * m_search.window + 1);
  for (std::size_t i = 0; i < kMostCells; ++i)
  {
    const std::size_t cell = below(side * side);
    take(seed, static_cast<std::int32_t>(cell % side) - m_search.window,
         static_cast<std::int32_t>(cell / side) - m_search.window);
  }
}

/** Planes through the seed and two other cells; at most K. */
std::size_t SeedPlane::makeHypotheses()
{
  const auto wanted = static_cast<std::size_t>(m_search.hypotheses);
  std::array<float, kMost> ax, ay, az, bx, by, bz;
  for (std::size_t i = 0; i < wanted; ++i)
  {
    const std::uint64_t two = random();
    const auto a = static_cast<std::size_t>((two >> 32) * m_cells >> 32),
               b = static_cast<std::size_t>((two & 0xFFFFFFFFu) * m_cells >> 32);
    ax[i] = m_dx[a];
    ay[i] = m_dy[a];
    az[i] = m_dz[a];
    bx[i] = m_dx[b];
    by[i] = m_dy[b];
    bz[i] = m_dz[b];
  }
  const auto most = static_cast<float>(m_search.mostSlope * m_search.mostSlope);
  std::array<float, kMost> gx, gy;
  for (std::size_t i = 0; i < wanted; ++i)
  {
    const float det = ax[i] * by[i] - bx[i] * ay[i];  // 0: on one line, the slopes are not finite
    gx[i] = (az[i] * by[i] - bz[i] * ay[i]) / det;
    gy[i] = (ax[i] * bz[i] - bx[i] * az[i]) / det;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < wanted; ++i)
  {
    m_gx[count] = gx[i];
    m_gy[count] = gy[i];
    m_score[count] = 0;
    count += gx[i] * gx[i] + gy[i] * gy[i] <= most ? 1 : 0;
  }
  return count;
}

/** Moves the best to the front, in their order; of equally good ones the first. */
std::size_t SeedPlane::keepBest(std::size_t hypotheses, std::size_t kept)
{
  if (hypotheses <= kept) return hypotheses;
  std::array<std::int32_t, kMost> better{};
  for (std::size_t j = 0; j < hypotheses; ++j)
  {
    const float score = m_score[j];
    for (std::size_t i = 0; i < j; ++i) better[i] += score > m_score[i] ? 1 : 0;
    for (std::size_t i = j + 1; i < hypotheses; ++i) better[i] += score >= m_score[i] ? 1 : 0;
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < hypotheses; ++i)
  {
    if (better[i] >= static_cast<std::int32_t>(kept)) continue;
    m_gx[count] = m_gx[i];
    m_gy[count] = m_gy[i];
    m_score[count++] = m_score[i];
  }
  return kept;
}

std::size_t SeedPlane::winner(std::size_t hypotheses)
{
  // a random order of the cells: any start, and steps of a prime that does not divide their number
  static constexpr std::array<std::size_t, 8> kPrimes{37, 41, 43, 47, 53, 59, 61, 67};
  std::size_t at = below(m_cells), prime = below(kPrimes.size());
  while (m_cells % kPrimes[prime] == 0) prime = (prime + 1) % kPrimes.size();
  const std::size_t step = kPrimes[prime] % m_cells;
  const auto block = static_cast<std::size_t>(m_search.blockCells);
  const auto tolerance = static_cast<float>(m_search.tolerance);
  auto allowed = static_cast<std::size_t>(m_search.hypotheses);
  for (std::size_t i = 0; i < m_cells && hypotheses > 1;)
  {
    for (const std::size_t end = std::min(m_cells, i + block); i < end; ++i)
    {
      addScores(m_gx.data(), m_gy.data(), m_score.data(), hypotheses, m_dx[at], m_dy[at], m_dz[at],
                tolerance);
      at += step;
      if (at >= m_cells) at -= m_cells;
    }
    if (i % block != 0) break;  // a part of a block
    allowed = std::max<std::size_t>(1, allowed / 2);
    hypotheses = keepBest(hypotheses, allowed);
  }
  return static_cast<std::size_t>(
      std::max_element(m_score.begin(), m_score.begin() + static_cast<std::ptrdiff_t>(hypotheses)) -
      m_score.begin());
}

std::optional<Plane> SeedPlane::find(const CellRef& seed)
{
  m_random = mixed(static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed.keyX())) << 32 |
                   static_cast<std::uint32_t>(seed.keyY()));
  m_cells = 0;
  const std::size_t side = static_cast<std::size_t>(2 * m_search.window + 1);
  if (side * side <= kMostCells)
    collectAll(seed);
  else
    draw(seed);
  if (m_cells < 2) return std::nullopt;
  const std::size_t hypotheses = makeHypotheses();
  if (hypotheses == 0) return std::nullopt;
  const std::size_t best = winner(hypotheses);
  Plane plane;
  plane.originX = seed.keyX();
  plane.originY = seed.keyY();
  plane.height = seed.tile->height[seed.index()];
  plane.slopeX = static_cast<double>(m_gx[best]);
  plane.slopeY = static_cast<double>(m_gy[best]);
  return plane;
}

}  // namespace mrpt_mapconv::terrain
