#pragma once

#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/params/Fields.h>

namespace mrpt_mapconv::voxel
{
/** How a voxel map that is made of scans begins. */
struct VoxelMapParams
{
  double resolution = 0.10;  //!< size of voxels and cells [m]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("resolution", p.resolution, "m", "size of voxels and cells");
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const { grid::requireResolution(resolution); }
};

}  // namespace mrpt_mapconv::voxel
