#include "ClimbCheck.h"

#include <mrpt_mapconv/grid/CellKey.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::planning
{
using mrpt::math::TPoint3D;

ClimbCheck::ClimbCheck(const freespace::Layers& layers,
                       const freespace::ConversionParams& conversion,
                       const path::LiftParams& params, const voxel::VoxelSource* voxels)
    : m_layers(layers), m_conversion(conversion), m_params(params), m_voxels(voxels)
{
}

std::size_t ClimbCheck::firstBlocked(const path::LiftedPath& path) const
{
  for (std::size_t i = 1; i < path.points.size(); ++i)
    if (isBlocked(path.points[i - 1].position, path.points[i].position)) return i;
  return 0;
}

bool ClimbCheck::isBlocked(const TPoint3D& from, const TPoint3D& to) const
{
  const double cell = m_layers.frame().resolution;
  const int pieces = static_cast<int>(std::ceil(std::abs(to.z - from.z) / (cell / 4)));
  if (pieces <= 4) return false;  // a cell or less: half of that is near enough to either end
  for (int k = 1; k < pieces; ++k)
  {
    const double part = static_cast<double>(k) / pieces;
    const TPoint3D at(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                      from.z + part * (to.z - from.z));
    if (std::min(distanceToFit(from, at), distanceToFit(to, at)) > cell) return true;
  }
  return false;
}

double ClimbCheck::distanceToFit(const TPoint3D& place, const TPoint3D& at) const
{
  const grid::GridFrame& frame = m_layers.frame();
  const std::size_t cell = frame.indexOfKey(grid::cellKey(place.x, frame.resolution),
                                            grid::cellKey(place.y, frame.resolution));
  // a path of one point gets the nearest height to the one that is asked for
  const double floor = static_cast<double>(m_layers.floor.cells()[cell]);
  path::LiftParams wanted = m_params;
  wanted.heightOffset = std::max(0.0, at.z - floor);
  const auto lifted =
      path::liftPath({{place.x, place.y}}, m_layers, m_conversion, wanted, m_voxels);
  // it has the place's x and y
  return std::hypot(place.x - at.x, place.y - at.y, lifted.points.at(0).position.z - at.z);
}

}  // namespace mrpt_mapconv::planning
