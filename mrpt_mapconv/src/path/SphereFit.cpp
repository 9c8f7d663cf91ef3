#include "SphereFit.h"

#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace mrpt_mapconv::path
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
}

SphereFit::SphereFit(const freespace::Layers& layers, const Disc& disc)
    : m_layers(layers),
      m_disc(disc),
      m_low(disc.side()),
      m_high(disc.side()),
      m_sum(disc.side()),
      m_half(disc.side() * disc.side())
{
}

SphereLimits SphereFit::limits()
{
  std::fill(m_low.begin(), m_low.end(), -kInfinity);
  std::fill(m_high.begin(), m_high.end(), kInfinity);
  std::fill(m_sum.begin(), m_sum.end(), 0.0);
  m_leavesFrame = false;
  m_disc.forEachRow([&](const Disc::Row& row) { addRow(row); });
  double sum = 0;
  for (const double part : m_sum) sum += part;
  return {*std::max_element(m_low.begin(), m_low.end()),
          *std::min_element(m_high.begin(), m_high.end()), !m_leavesFrame && !std::isnan(sum)};
}

void SphereFit::addRow(const Disc::Row& row)
{
  const grid::GridFrame& frame = m_layers.frame();
  const std::int32_t begin = std::max(row.kxBegin, frame.x0);
  const std::int32_t end = std::min(row.kxEnd, frame.xEnd());
  const bool rowInside = row.ky >= frame.y0 && row.ky < frame.yEnd();
  m_leavesFrame |= !rowInside || begin != row.kxBegin || end != row.kxEnd;
  if (!rowInside) return;

  const Eigen::Index count = end - begin;
  const Eigen::Map<const Eigen::ArrayXd> dxSq(row.dxSq + (begin - row.kxBegin), count);
  double* half = m_half.data() + at(row, begin);
  Eigen::Map<Eigen::ArrayXd>(half, count) = (row.restSq - dxSq).max(0.0).sqrt();

  const float* floor = m_layers.floor.row(row.ky - frame.y0) + (begin - frame.x0);
  const float* ceiling = m_layers.ceiling.row(row.ky - frame.y0) + (begin - frame.x0);
  const std::int32_t column = begin - m_disc.kxFirst();
  double* low = m_low.data() + column;
  double* high = m_high.data() + column;
  double* sum = m_sum.data() + column;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    // a comparison with NaN is false, so cells without a floor change nothing but the sum
    const double lowest = floor[i] + half[i], highest = ceiling[i] - half[i];
    low[i] = lowest > low[i] ? lowest : low[i];
    high[i] = highest < high[i] ? highest : high[i];
    sum[i] += floor[i];
  }
}

Obstacle SphereFit::obstacle(bool unknownIsPassable) const
{
  const grid::GridFrame& frame = m_layers.frame();
  Obstacle nearest;
  double nearestSq = kInfinity;
  const auto consider = [&](const Disc::Row& row, std::int32_t kx, bool wall)
  {
    if (!wall && (unknownIsPassable || nearest.kind == Infeasibility::Wall)) return;
    const Infeasibility kind = wall ? Infeasibility::Wall : Infeasibility::Unknown;
    const double distanceSq = row.dxSq[kx - row.kxBegin] - row.restSq;  // less radius²
    if (kind == nearest.kind && distanceSq >= nearestSq) return;
    nearestSq = distanceSq;
    nearest = {kind, {(kx + 0.5) * frame.resolution, (row.ky + 0.5) * frame.resolution}};
  };
  m_disc.forEachRow(
      [&](const Disc::Row& row)
      {
        const bool rowInside = row.ky >= frame.y0 && row.ky < frame.yEnd();
        const std::int32_t begin = rowInside ? std::max(row.kxBegin, frame.x0) : row.kxEnd;
        const std::int32_t end = rowInside ? std::min(row.kxEnd, frame.xEnd()) : row.kxEnd;
        for (std::int32_t kx = row.kxBegin; kx < begin; ++kx) consider(row, kx, false);
        for (std::int32_t kx = end; kx < row.kxEnd; ++kx) consider(row, kx, false);
        if (begin == end) return;
        const std::size_t first = frame.indexOfKey(begin, row.ky);
        const float* floor = m_layers.floor.cells().data() + first;
        const float* aerial = m_layers.aerial.cells().data() + first;
        for (std::int32_t i = 0; i < end - begin; ++i)
          if (std::isnan(floor[i])) consider(row, begin + i, grid::isOccupied(aerial[i]));
      });
  return nearest;
}

}  // namespace mrpt_mapconv::path
