#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace mrpt_mapconv::eval
{
/** A surface without noise, at the centre of a cell. */
struct SurfacePoint
{
  double height = std::numeric_limits<double>::quiet_NaN();  //!< [m]; NaN: none, or several
  double slope = 0;                                          //!< of the face there [m/m]
};

/** Numbers the planes of a surface in `plane` (−1: none), which lies on the surface's frame; see
 * terrainTruth(). */
std::vector<terrain::TerrainPlane> truePlanes(const grid::Layer<SurfacePoint>& surface,
                                              grid::Layer<std::int32_t>& plane);

}  // namespace mrpt_mapconv::eval
