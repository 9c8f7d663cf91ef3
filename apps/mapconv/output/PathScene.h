#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <string>

namespace octomap
{
class AbstractOcTree;
}

namespace mapconv
{
/** Writes a `.3Dscene` of MRPT's own objects: the path with its start (white) and goal, among the
 * occupied voxels no more than a metre above it (what is higher would hide it), or above the floor,
 * with a legend of the colours of a ground robot's, if there is no voxel map.
 * \param occupancy of the path's robot
 * \param octree of which the layers were made; may be null
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writePathScene(const std::string& file, const mrpt_mapconv::freespace::Layers& layers,
                    const mrpt_mapconv::grid::StyledLayer& occupancy,
                    const octomap::AbstractOcTree* octree,
                    const mrpt_mapconv::path::LiftedPath& path);

}  // namespace mapconv
