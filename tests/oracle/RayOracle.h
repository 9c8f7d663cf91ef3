#pragma once

#include <mrpt_mapconv/voxel/RayWalk.h>

#include <array>
#include <cstdint>
#include <vector>

namespace mrpt_mapconv::oracle
{
/** All voxels with low <= key <= high on each axis. */
struct KeyBox
{
  std::array<std::int64_t, 3> low{}, high{};
};

/** The smallest box that holds a ray. */
KeyBox boxOf(const voxel::GridRay& ray);

/** voxel::walkRay(), but every voxel of a box is asked between which crossings the ray is in it.
 * Crossings are ordered by their exact time, then those upwards before those downwards (voxel k is
 * [k, k+1)), then by axis. In the order in which the ray comes to them. */
std::vector<voxel::VoxelKey> voxelsOnRay(const voxel::GridRay& ray, const KeyBox& box);

/** Whether a point of the ray lies in a voxel, [k, k+1) on each axis: geometry without any order.
 */
bool holdsPointOf(const voxel::GridRay& ray, const voxel::VoxelKey& voxel);
/** The same with the voxel's upper faces, edges and corners as part of it. */
bool touches(const voxel::GridRay& ray, const voxel::VoxelKey& voxel);

}  // namespace mrpt_mapconv::oracle
