#pragma once

#include <mrpt_mapconv/freespace/Layers.h>

#include <string>

namespace mrpt_mapconv::maps
{
/** Writes all layers as the bands of one GeoTIFF, see grid::writeGeoTiff(). */
void writeLayersTiff(const std::string& path, const freespace::Layers& layers);

/** Writes the picture of one layer, with the title and legend that suit it, see
 * grid::writeLayerPng().
 * \param name as in Layers::named()
 * \exception std::invalid_argument for another name */
void writeLayerPicture(const std::string& path, const freespace::Layers& layers,
                       const std::string& name);

}  // namespace mrpt_mapconv::maps
