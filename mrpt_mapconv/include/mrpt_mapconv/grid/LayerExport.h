#pragma once

#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <functional>
#include <string>
#include <vector>

namespace mrpt_mapconv::grid
{
/** Which files exportLayers() writes. */
struct ExportFormats
{
  std::string tiff = {};        //!< name of one GeoTIFF with all layers; empty: none
  Metadata metadata = {};       //!< of the GeoTIFF
  std::string prefix = {};      //!< what the names of the layers' own files begin with
  bool pictures = false;        //!< PREFIX<layer>.png of each layer, of what is known in any
  bool gridMaps = false;        //!< PREFIX<layer>.gridmap of each occupancy layer, for MRPT
  bool rosMaps = false;         //!< PREFIX<layer>.pgm and .yaml of each occupancy layer, for ROS
  GeoReference reference = {};  //!< of GeoTIFF and ROS maps; gridmaps stay local
};

/** Writes layers in the formats that others read: writeGeoTiff(), writeLayerPng(), writeGridMap()
 * and writeRosMap().
 *
 * \param out where the files are staged; the caller commits it
 * \param layers on one frame if they go into a GeoTIFF or pictures; none may be empty
 * \param progress told the share of the files that is done, above 0 up to 1; may be empty
 * \exception std::invalid_argument, std::runtime_error as those functions */
void exportLayers(files::OutputDir& out, const std::vector<StyledLayer>& layers,
                  const ExportFormats& formats, const std::function<void(double)>& progress = {});

}  // namespace mrpt_mapconv::grid
