#pragma once

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/grid/GridFrame.h>
#include <mrpt_mapconv/observation/SensorPoints.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>
#include <mrpt_mapconv/terrain/TerrainOptions.h>

#include <cstddef>
#include <vector>

namespace mrpt_mapconv::terrain
{
/** The points of a scan that a map is to get. */
struct UsedPoints
{
  std::vector<mrpt::math::TPoint3Df> points;  //!< in the sensor's frame [m]
  std::size_t leftOut = 0;                    //!< of the scan: beyond the limits
  /** Where they lie in the map [m], if there are any. */
  double xMin = 0, yMin = 0, xMax = 0, yMax = 0;
};

/** Chooses the points of a scan within limits. Beams that met nothing say nothing of the ground. */
UsedPoints usedPoints(const observation::SensorPoints& scan, const PointLimits& limits);

/** The cells that those points fall into, as a frame of the map's.
 * \exception std::runtime_error naming the place if it is too far away for keys */
grid::GridFrame frameOf(const UsedPoints& points, const TerrainMap& map);

/** Those points as what a map gets; they must outlive it.
 * \param poseCovariance of the robot's z [m], roll and pitch [rad], in this order */
TerrainScan terrainScan(const observation::SensorPoints& scan, const UsedPoints& points,
                        const mrpt::math::CMatrixDouble33& poseCovariance);

/** Adds those points of a scan to a map; its planes follow at TerrainMap::update().
 * \param poseCovariance of the robot's z [m], roll and pitch [rad], in this order
 * \exception std::exception as TerrainMap::insert() */
InsertedPoints insertScan(TerrainMap& map, const observation::SensorPoints& scan,
                          const UsedPoints& points, const PointSigmas& sigmas,
                          const mrpt::math::CMatrixDouble33& poseCovariance);

}  // namespace mrpt_mapconv::terrain
