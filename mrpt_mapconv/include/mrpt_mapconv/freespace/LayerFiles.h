#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <string>

namespace mrpt_mapconv::freespace
{
/** Writes all layers as the bands of one GeoTIFF, see grid::writeGeoTiff(); the parameters that
 * they were made with are its metadata. */
void writeLayersTiff(const std::string& path, const freespace::Layers& layers,
                     const freespace::ConversionParams& params);
/** That metadata, for grid::exportLayers(). */
grid::Metadata metadataOf(const freespace::ConversionParams& params);

/** Layers and what they were made with. */
struct LayersFile
{
  freespace::Layers layers;
  freespace::ConversionParams params;
  grid::GeoReference reference = {};  //!< where the layers' frame lies
};

/** Reads what writeLayersTiff() wrote.
 * \exception std::runtime_error naming the file and the reason: it cannot be read, a layer or a
 * parameter is missing or a parameter is not valid */
LayersFile readLayersTiff(const std::string& path);

}  // namespace mrpt_mapconv::freespace
