#include "SlopeFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrpt_mapconv::freespace
{
namespace
{
__extension__ using Int128 = __int128;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/** Up to this window the determinant fits into 64 bits. */
constexpr std::int32_t kNarrowWindow = 20;

/** xx·yy − xy², exact. */
template <class Integer>
double determinant(std::int64_t xx, std::int64_t yy, std::int64_t xy)
{
  return static_cast<double>(static_cast<Integer>(xx) * yy - static_cast<Integer>(xy) * xy);
}
}  // namespace

SlopeFilter::SlopeFilter(std::int32_t window) : m_window(window)
{
  const auto side = static_cast<std::size_t>(voxel::kBlockSide + 2 * window);
  for (auto* sums : {&m_columns.n, &m_columns.y, &m_columns.yy, &m_columns.z}) sums->resize(side);
  m_columns.yz.resize(side);
}

void SlopeFilter::clearColumns()
{
  for (auto* sums : {&m_columns.n, &m_columns.y, &m_columns.yy, &m_columns.z})
    std::fill(sums->begin(), sums->end(), 0);
  std::fill(m_columns.yz.begin(), m_columns.yz.end(), 0);
}

/** Adds (sign = 1) or takes away (−1) a row of floors to or from the columns' moments. */
template <std::int32_t sign>
void SlopeFilter::addRow(const std::int32_t* floors, std::int32_t y, std::int32_t count)
{
  std::int32_t* n = m_columns.n.data();
  std::int32_t* sumY = m_columns.y.data();
  std::int32_t* sumYY = m_columns.yy.data();
  std::int32_t* sumZ = m_columns.z.data();
  std::int64_t* sumYZ = m_columns.yz.data();
  const std::int32_t signedY = sign * y, signedYY = sign * y * y;
  for (std::int32_t i = 0; i < count; ++i)
  {
    // all ones where there is a floor: masks instead of branches let the compiler use vectors
    const std::int32_t has = -static_cast<std::int32_t>(floors[i] != FloorTile::kNoFloor);
    const std::int32_t z = (floors[i] - (m_zReference & has)) & has;
    n[i] += sign & has;
    sumY[i] += signedY & has;
    sumYY[i] += signedYY & has;
    sumZ[i] += sign * z;
    sumYZ[i] += signedY * z;
  }
}

/** Adds or takes away a column of the tile to or from the window's moments. */
template <std::int32_t sign>
void SlopeFilter::addColumn(Moments& m, std::int32_t x) const
{
  const auto i = static_cast<std::size_t>(x);
  const std::int64_t n = sign * m_columns.n[i], y = sign * m_columns.y[i];
  const std::int64_t z = sign * m_columns.z[i];
  m.n += n;
  m.x += n * x;
  m.xx += n * x * x;
  m.y += y;
  m.xy += y * x;
  m.yy += sign * m_columns.yy[i];
  m.z += z;
  m.xz += z * x;
  m.yz += sign * m_columns.yz[i];
}

double SlopeFilter::slopeOf(const Moments& m) const
{
  const std::int64_t xx = m.n * m.xx - m.x * m.x, yy = m.n * m.yy - m.y * m.y;
  const std::int64_t xy = m.n * m.xy - m.x * m.y;
  const double det = m_window <= kNarrowWindow ? determinant<std::int64_t>(xx, yy, xy)
                                               : determinant<Int128>(xx, yy, xy);
  if (m.n < 3 || det == 0) return kNaN;  // eq. 3 has no unique solution
  const auto xz = static_cast<double>(m.n * m.xz - m.x * m.z);
  const auto yz = static_cast<double>(m.n * m.yz - m.y * m.z);
  const auto dxx = static_cast<double>(xx), dyy = static_cast<double>(yy);
  const auto dxy = static_cast<double>(xy);
  const double a = (xz * dyy - yz * dxy) / det, b = (yz * dxx - xz * dxy) / det;
  return std::sqrt(a * a + b * b);  // eq. 4; floor and cell share one unit, so it is m/m
}

void SlopeFilter::compute(const FloorTile& tile, const BlockRect& rect,
                          std::array<double, voxel::kBlockColumns>& slope)
{
  const std::int32_t side = 2 * m_window + 1;
  const std::int32_t columns = rect.xEnd - rect.xBegin + 2 * m_window;
  const auto row = [&](std::int32_t y) { return tile.at(rect.xBegin - m_window, y); };

  clearColumns();
  m_zReference = 0;
  for (std::int32_t i = 0; i < columns && m_zReference == 0; ++i)
    if (row(rect.yBegin)[i] != FloorTile::kNoFloor) m_zReference = row(rect.yBegin)[i];

  // y counts from the tile's first row in use, x from its first column in use
  for (std::int32_t y = 0; y < side - 1; ++y)
    addRow<1>(row(rect.yBegin - m_window + y), y, columns);
  for (std::int32_t y = rect.yBegin; y < rect.yEnd; ++y)
  {
    const std::int32_t entering = y - rect.yBegin + side - 1;
    addRow<1>(row(y + m_window), entering, columns);
    if (y > rect.yBegin) addRow<-1>(row(y - m_window - 1), entering - side, columns);

    slideAlong(tile.at(0, y), rect, slope.data() + y * voxel::kBlockSide);
  }
}

/** Slopes of one row: the window slides from the row's first cell with a floor to the last. */
void SlopeFilter::slideAlong(const std::int32_t* floors, const BlockRect& rect, double* slope) const
{
  const auto hasFloor = [&](std::int32_t x) { return floors[x] != FloorTile::kNoFloor; };
  std::fill(slope + rect.xBegin, slope + rect.xEnd, kNaN);
  std::int32_t first = rect.xBegin, last = rect.xEnd - 1;
  while (first <= last && !hasFloor(first)) ++first;
  while (last > first && !hasFloor(last)) --last;

  const std::int32_t side = 2 * m_window + 1;
  Moments window;
  const std::int32_t left = first - rect.xBegin;  // the window's first column for the first cell
  if (first <= last)
    for (std::int32_t x = left; x < left + side - 1; ++x) addColumn<1>(window, x);
  for (std::int32_t x = first; x <= last; ++x)
  {
    const std::int32_t entering = x - rect.xBegin + side - 1;
    addColumn<1>(window, entering);
    if (x > first) addColumn<-1>(window, entering - side);
    if (hasFloor(x)) slope[x] = slopeOf(window);
  }
}

}  // namespace mrpt_mapconv::freespace
