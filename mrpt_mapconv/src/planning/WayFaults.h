#pragma once

#include <mrpt_mapconv/path/PieceCheck.h>

#include <cstddef>
#include <string>
#include <vector>

#include "ClimbCheck.h"

namespace mrpt_mapconv::planning
{
/** Why a robot cannot go from one point of a lifted path to the next. */
struct WayFault
{
  enum class Kind
  {
    FloorStep,
    HeightStep,
    InTheWay
  };
  Kind kind;
  std::size_t index;  //!< of the second of the two points
  std::string words;  //!< with place and heights
};

/** Looks between the points of a lifted path, all of which can be reached. */
class WayFaults
{
 public:
  /** \param layers, conversion, params, voxels as for liftPath(); they must outlive this */
  WayFaults(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
            const path::LiftParams& params, const voxel::VoxelSource* voxels);

  /** All faults; of an aerial robot's path the first one only, as its heights depend on the way. */
  std::vector<WayFault> of(const path::LiftedPath& path) const;

 private:
  bool m_aerial;
  path::PieceCheck m_pieces;
  ClimbCheck m_climbs;
};

}  // namespace mrpt_mapconv::planning
