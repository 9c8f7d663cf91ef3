#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <string>

namespace mrpt_mapconv::freespace
{
/** Writes all layers as the bands of one GeoTIFF, see grid::writeGeoTiff(); the parameters that
 * they were made with are its metadata. */
void writeLayersTiff(const std::string& path, const freespace::Layers& layers,
                     const freespace::ConversionParams& params);

/** Layers and what they were made with. */
struct LayersFile
{
  freespace::Layers layers;
  freespace::ConversionParams params;
};

/** Reads what writeLayersTiff() wrote.
 * \exception std::runtime_error naming the file and the reason: it cannot be read, a layer or a
 * parameter is missing or a parameter is not valid */
LayersFile readLayersTiff(const std::string& path);

/** Writes the picture of one layer, with the title and legend that suit it, see
 * grid::writeLayerPng().
 * \param name as in Layers::named()
 * \exception std::invalid_argument for another name */
void writeLayerPicture(const std::string& path, const freespace::Layers& layers,
                       const std::string& name);

}  // namespace mrpt_mapconv::freespace
