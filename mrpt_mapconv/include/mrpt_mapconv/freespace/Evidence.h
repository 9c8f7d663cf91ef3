#pragma once

#include <mrpt_mapconv/grid/StyledLayer.h>

namespace mrpt_mapconv::freespace
{
/** What is known of the ground in a cell, as Layers::evidence writes it. */
namespace evidence
{
constexpr float kNone = 0;  //!< nothing: no kept free range, no occupied voxel
constexpr float kSeen = 1;  //!< the voxel right under the lowest kept free range is occupied
/** It is unknown, but seen cells around say where the ground is. */
constexpr float kInferred = grid::kInferredGround;
constexpr float kOpen = 3;  //!< it is unknown: the ground lies at or under the floor
constexpr float kWall = 4;  //!< an occupied voxel, but no kept free range

/** Whether the voxel under the lowest kept free range is unknown. */
inline bool isOpen(float evidence) { return evidence == kInferred || evidence == kOpen; }

/** Why no ground robot goes where there is free space, but no support. */
constexpr const char* kOpenInWords =
    "nobody saw the ground there, and none that was seen around tells where it is";
}  // namespace evidence

}  // namespace mrpt_mapconv::freespace
