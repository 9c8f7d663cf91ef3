#include "ElevationUpdate.h"

#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <array>

#include "../grid/Wide.h"
#include "../terrain/Tile.h"

namespace mrpt_mapconv::eval
{
using terrain::PointModel;

namespace
{
/** Heights [m] and their variances [m²] of a batch. */
struct Heights
{
  std::array<float, PointModel::kBatch> height, variance;
};

MRPT_MAPCONV_WIDE
void heightsOf(const PointModel::Batch& points, std::size_t count, Heights& heights)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    heights.height[i] = static_cast<float>(points.z[i]) * static_cast<float>(terrain::kHeightUnit);
    heights.variance[i] =
        static_cast<float>(terrain::kWeightUnit) / static_cast<float>(points.weight[i]);
  }
}

/** Written without branches, which would be guessed wrong: noise decides about a point. */
inline void updateCell(const UpdateRule& rule, float z, float variance, ElevationMap::Cell& cell)
{
  const bool isOfScan = (cell.scan | 1) == (rule.scan | 1);
  const bool isRecent = cell.scan == (rule.scan | 1);  // this scan has fused a point here
  const float before = isOfScan ? cell.variance : rule.limits(cell.variance);
  const bool isNew = !(before < std::numeric_limits<float>::infinity());
  const float innovation = z - cell.height;
  const bool isNear = innovation * innovation <= rule.threshold * rule.threshold * before;
  const bool isFused = isNear & !isNew;
  const bool isReplaced = isNew | (!isNear & isRecent & (innovation > 0));

  const float gain = before / (before + variance);
  const float leftOut = isRecent ? before : before + rule.noise;
  const float height = isFused ? cell.height + gain * innovation : cell.height;
  const float after = isFused ? before - gain * before : leftOut;
  cell.height = isReplaced ? z : height;
  cell.variance = isReplaced ? variance : after;
  cell.scan = rule.scan | static_cast<std::uint32_t>(isFused | isRecent);
}

/** The cells of a batch's points; of those that are not finite any one.
 * They are asked for early: most of a fine grid is not in the processor's caches. */
void findCells(const PointModel::Batch& points, std::size_t count, ElevationMap::Cell* first,
               const grid::GridFrame& frame, ElevationMap::Cell** cells)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isPoint = points.weight[i] != 0;
    cells[i] = first + (isPoint ? frame.indexOfKey(points.kx[i], points.ky[i]) : 0);
    __builtin_prefetch(cells[i], 1);
  }
}

MRPT_MAPCONV_WIDE
std::size_t update(const PointModel::Batch& points, const Heights& heights, std::size_t count,
                   const UpdateRule& rule, ElevationMap::Cell* const* cells)
{
  std::size_t finite = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (points.weight[i] == 0) continue;
    updateCell(rule, heights.height[i], heights.variance[i], *cells[i]);
    ++finite;
  }
  return finite;
}
}  // namespace

std::size_t updateCells(const PointModel::Batch& points, std::size_t count, const UpdateRule& rule,
                        grid::Layer<ElevationMap::Cell>& cells)
{
  Heights heights;
  ElevationMap::Cell* places[PointModel::kBatch];
  findCells(points, count, cells.cells().data(), cells.frame(), places);
  heightsOf(points, count, heights);
  return update(points, heights, count, rule, places);
}

}  // namespace mrpt_mapconv::eval
