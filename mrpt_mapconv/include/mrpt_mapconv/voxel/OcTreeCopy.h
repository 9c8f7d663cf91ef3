#pragma once

#include <memory>

namespace octomap
{
class AbstractOcTree;
class OcTree;
}  // namespace octomap

namespace mrpt_mapconv::voxel
{
/** A plain occupancy tree with the same leaves and log-odds as a tree of any occupancy type.
 * \exception std::invalid_argument for a tree that holds no occupancy */
std::unique_ptr<octomap::OcTree> toOcTree(const octomap::AbstractOcTree& tree);

}  // namespace mrpt_mapconv::voxel
