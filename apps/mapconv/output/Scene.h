#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <string>

namespace mapconv
{
/** Writes a `.3Dscene`: the ground as a surface, coloured by where a ground robot may go, its
 * occupancy below, a legend and a reference grid. Made of MRPT's own objects, so SceneViewer3D
 * opens it without this library. \exception std::runtime_error naming the file and the reason if it
 * cannot be written */
void writeScene(const std::string& path, const mrpt_mapconv::freespace::Layers& layers,
                const mrpt_mapconv::freespace::ConversionParams& params);

}  // namespace mapconv
