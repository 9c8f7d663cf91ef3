#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <vector>

namespace mrpt_mapconv::observation
{
/** What has to be taken off the poses of scans such that a map of them can have a frame near by: 0
 * unless a robot is farther than 10 km from the origin in x or y, or than half of what an octree of
 * that resolution reaches; else its first position in whole metres. Heights stay as they are.
 * \param resolution of the voxel map [m]; 0: none */
mrpt::math::TPoint3D originOf(const std::vector<PosedObservation>& scans, double resolution);

/** Takes an origin off the poses of scans [m]. */
void moveToOrigin(std::vector<PosedObservation>& scans, const mrpt::math::TPoint3D& origin);

}  // namespace mrpt_mapconv::observation
