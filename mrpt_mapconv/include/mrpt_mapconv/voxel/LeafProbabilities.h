#pragma once

namespace octomap
{
class AbstractOcTree;
}

namespace mrpt_mapconv::voxel
{
/** Whether a tree knows more of a voxel than that it is occupied or free: whether any leaf's
 * probability lies between the tree's clamping thresholds, which are all that OctoMap makes of a
 * `.bt` file. Only then does it depend on occupancyThres what is occupied. False for trees that
 * hold no occupancy. */
bool holdsProbabilities(const octomap::AbstractOcTree& tree);

}  // namespace mrpt_mapconv::voxel
