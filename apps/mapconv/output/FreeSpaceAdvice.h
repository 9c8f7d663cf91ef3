#pragma once

namespace mapconv
{
/** What is the matter with a voxel map without any free voxel, and what helps. */
constexpr const char* kNoFreeVoxel =
    "no voxel of the map is free, only occupied ones are known, as in maps made of point clouds or "
    "meshes; --unknown free takes the unknown voxels above a column's lowest occupied one for free";

}  // namespace mapconv
