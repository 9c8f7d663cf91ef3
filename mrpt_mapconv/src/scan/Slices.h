#pragma once

#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <vector>

#include "SensorPlace.h"

namespace mrpt_mapconv::scan
{
/** A cell, counted from the sensor's. */
struct CellOffset
{
  std::int32_t x = 0, y = 0;
};

/** A point of the structure slice. */
struct StructurePoint
{
  CellOffset cell;
  double x = 0, y = 0;  //!< from the sensor [m]
  double height = 0;    //!< above the robot's base [m]
};

/** The points of a scan that are at the heights and ranges that matter. */
struct Slices
{
  std::vector<CellOffset> object;         //!< cell of each point of the object slice
  std::vector<StructurePoint> structure;  //!< points of the structure slice
  std::int32_t reach = 0;                 //!< no cell of an object has a larger offset along x or y

  /** Takes them from a scan. Nothing is allocated once the vectors have grown large enough. */
  void take(const std::vector<mrpt::math::TPoint3Df>& points, const Viewpoint& view,
            const SensorPlace& place, const ProfileParams& params);
};

}  // namespace mrpt_mapconv::scan
