#pragma once

#include <mrpt_mapconv/grid/GeoReference.h>
#include <mrpt_mapconv/grid/StyledLayer.h>
#include <mrpt_mapconv/params/Fields.h>

#include <map>
#include <string>
#include <vector>

namespace mrpt_mapconv::grid
{
/** What a file says about its layers: names and values, as GDAL's metadata items. */
using Metadata = std::map<std::string, std::string>;

/** All fields of a struct with a list (params/Fields.h) that are set. */
template <class Params>
Metadata metadataOf(const Params& params)
{
  Metadata items;
  params::forEachText(
      params, [&items](const char* name, const std::string& text) { items.emplace(name, text); });
  return items;
}

/** Writes layers as the bands of one Float32 GeoTIFF, in their order, described by their names.
 *
 * North is up (the first raster row is the highest y), the geotransform is exactly
 * {xMin, resolution, 0, yMax, 0, −resolution} in metres, NaN means no data. Where the map's frame
 * is a local one, its origin is added to xMin and yMax and kept as metadata (`originX`, … [m]), and
 * is the offset of bands of heights in z; the coordinate system is written, if it is known. Of a
 * system in feet the geotransform is in feet, too, and bands stay in metres (`metresPerUnit`,
 * `cellSize` [m]). An error can leave an unfinished file behind; write into
 * files::OutputDir::path().
 *
 * \param bands at least one; all on the same frame, which must not be empty
 * \param metadata kept in the file, for readGeoTiffMetadata() and `gdalinfo`
 * \exception std::invalid_argument if they are not
 * \exception std::runtime_error naming the file and GDAL's reason, also if the disk is full */
void writeGeoTiff(const std::string& path, const std::vector<StyledLayer>& bands,
                  const Metadata& metadata = {}, const GeoReference& reference = {});

/** Where writeGeoTiff() was told that the map lies; of other files, that their frame is their own.
 * \exception std::runtime_error naming the file and the reason if it cannot be read */
GeoReference readGeoReference(const std::string& path);

/** Reads one band of a GeoTIFF, in the local frame of readGeoReference(), of square, north-up cells
 * whose edges or centres lie on multiples of their size, as writeGeoTiff() writes it. Cells without
 * data become NaN.
 *
 * \param bandName description of the band
 * \exception std::runtime_error naming the file and the reason: it cannot be read, has no such band
 * (those it has are named) or its geotransform does not give integer keys */
Layer<float> readGeoTiffBand(const std::string& path, const std::string& bandName);

/** Reads what writeGeoTiff() was given as metadata, among GDAL's own items.
 * \exception std::runtime_error naming the file and the reason if it cannot be read */
Metadata readGeoTiffMetadata(const std::string& path);

}  // namespace mrpt_mapconv::grid
