#pragma once

#include <mrpt/math/TPoint3D.h>

#include <string>

namespace mrpt_mapconv::grid
{
/** Where a map lies whose frame is a local one, near its data: coordinates of national grids have
 * millions of metres, which neither a float nor a voxel's key holds. */
struct GeoReference
{
  mrpt::math::TPoint3D origin{0, 0, 0};  //!< of the local frame, in the input's coordinates [m]
  std::string coordinateSystem = {};     //!< of these: "EPSG:N" or WKT; empty: not known
  double unit = 1;                       //!< of that system's x and y, as GeoTIFFs have them [m]

  bool isLocal() const { return origin == mrpt::math::TPoint3D(0, 0, 0); }
  bool operator==(const GeoReference& o) const
  {
    return origin == o.origin && coordinateSystem == o.coordinateSystem && unit == o.unit;
  }
};

}  // namespace mrpt_mapconv::grid
