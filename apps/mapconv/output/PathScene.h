#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <string>

#include "input/MapFolder.h"

namespace mapconv
{
/** Writes a `.3Dscene` of MRPT's own objects: the path with its start (white) and goal, among the
 * occupied voxels no more than a metre above it (what is higher would hide it), or above the floor
 * if the folder has no voxel map.
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writePathScene(const std::string& file, const MapFolder& map,
                    const mrpt_mapconv::path::LiftedPath& path);

}  // namespace mapconv
