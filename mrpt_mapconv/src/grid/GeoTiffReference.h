#pragma once

#include <gdal_priv.h>
#include <mrpt_mapconv/grid/GeoReference.h>
#include <mrpt_mapconv/grid/GridFrame.h>

#include <string>

namespace mrpt_mapconv::grid
{
/** Writes where the layers of a GeoTIFF lie: geotransform and coordinate system for all programs,
 * and as items what those do not keep. \return false if GDAL failed */
bool writePlace(GDALDataset& dataset, const GridFrame& frame, const GeoReference& reference);

/** What writePlace() was told, or what is true of another program's file. @{
 * \param path for messages \exception std::runtime_error naming the file and what is wrong */
GeoReference readReference(GDALDataset& dataset, const std::string& path);
GridFrame readFrame(GDALDataset& dataset, const std::string& path);
/** @} */

}  // namespace mrpt_mapconv::grid
