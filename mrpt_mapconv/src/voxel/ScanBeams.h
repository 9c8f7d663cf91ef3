#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <octomap/octomap_types.h>

#include <cstddef>
#include <vector>

#include "OctomapKeys.h"

namespace mrpt_mapconv::voxel
{
/** The beams of a scan in the map's frame, as far as they stay in an octree's range. */
struct ScanBeams
{
  /** A beam up to maxRange. */
  struct Beam
  {
    octomap::point3d end;
    VoxelKey key;  //!< of the end
  };

  /** \param maxRange longest part of a beam [m]; −1: all of it
   * \exception std::runtime_error for a sensor pose that is not finite or outside the range */
  ScanBeams(const OctomapKeys& keys, const observation::SensorPoints& scan, double maxRange);

  /** The columns of the sensor and of all ends. */
  grid::GridFrame frame() const;

  OctomapKeys keys;
  octomap::point3d origin;
  VoxelKey originKey;
  std::vector<Beam> hits;    //!< that end where something returned
  std::vector<Beam> misses;  //!< that were cut at maxRange, or had no return
  std::size_t outside = 0;   //!< beams left out, since they end outside the range
};

}  // namespace mrpt_mapconv::voxel
