#include <cpl_string.h>
#include <gdal_priv.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <cmath>
#include <limits>
#include <memory>

#include "GdalErrors.h"
#include "GeoTiffReference.h"

namespace mrpt_mapconv::grid
{
namespace
{
constexpr float kNoData = std::numeric_limits<float>::quiet_NaN();

struct CloseDataset
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

void checkBands(const std::string& path, const std::vector<StyledLayer>& bands)
{
  if (bands.empty()) throw std::invalid_argument("GeoTIFF '" + path + "': no layers given");
  for (const StyledLayer& band : bands)
  {
    if (band.layer->frame().empty())
      throw std::invalid_argument("GeoTIFF '" + path + "': layer '" + band.name + "' is empty");
    if (band.layer->frame() != bands.front().layer->frame())
      throw std::invalid_argument("GeoTIFF '" + path + "': layer '" + band.name +
                                  "' is on another frame than '" + bands.front().name + "'");
  }
}

Dataset createDataset(const std::string& path, const GridFrame& frame, std::size_t bands)
{
  GDALAllRegister();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (!driver) return {};
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "3");
  options.SetNameValue("ZLEVEL", "4");
  options.SetNameValue("INTERLEAVE", "BAND");
  options.SetNameValue("BLOCKYSIZE", "32");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  return Dataset(driver->Create(path.c_str(), frame.width, frame.height, static_cast<int>(bands),
                                GDT_Float32, options.List()));
}

bool writeHeader(GDALDataset& dataset, const GridFrame& frame, const Metadata& metadata,
                 const GeoReference& reference)
{
  if (!writePlace(dataset, frame, reference)) return false;
  for (const auto& [name, value] : metadata)
    if (dataset.SetMetadataItem(name.c_str(), value.c_str()) != CE_None) return false;
  return true;
}

Dataset openDataset(const std::string& path, const GdalErrors& errors)
{
  GDALAllRegister();
  Dataset dataset(static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr,
                 nullptr, nullptr)));
  if (!dataset) errors.raise("read", path);
  return dataset;
}

bool writeBand(GDALRasterBand& target, const StyledLayer& band, double heightOrigin)
{
  target.SetDescription(band.name.c_str());
  if (target.SetNoDataValue(kNoData) != CE_None) return false;
  if (heightOrigin != 0 && band.kind == LayerKind::Height &&
      target.SetOffset(heightOrigin) != CE_None)
    return false;
  const GridFrame& frame = band.layer->frame();
  std::vector<float> row(static_cast<std::size_t>(frame.width));  // GDAL asks for mutable memory
  for (int line = 0; line < frame.height; ++line)
  {
    std::copy_n(band.layer->row(frame.height - 1 - line), frame.width, row.begin());
    if (target.RasterIO(GF_Write, 0, line, frame.width, 1, row.data(), frame.width, 1, GDT_Float32,
                        0, 0, nullptr) != CE_None)
      return false;
  }
  return true;
}

GDALRasterBand& findBand(GDALDataset& dataset, const std::string& path, const std::string& name)
{
  std::string names;
  for (int i = 1; i <= dataset.GetRasterCount(); ++i)
  {
    GDALRasterBand* band = dataset.GetRasterBand(i);
    if (band->GetDescription() == name) return *band;
    names += (names.empty() ? "'" : ", '") + std::string(band->GetDescription()) + "'";
  }
  throw std::runtime_error("cannot read '" + path + "': it has no band '" + name + "', only " +
                           (names.empty() ? "none" : names));
}

/** Turns a file's own no-data value into NaN. */
void clearNoData(Layer<float>& layer, GDALRasterBand& band)
{
  int has = 0;
  const auto noData = static_cast<float>(band.GetNoDataValue(&has));
  if (has) std::replace(layer.cells().begin(), layer.cells().end(), noData, kNoData);
}
}  // namespace

void writeGeoTiff(const std::string& path, const std::vector<StyledLayer>& bands,
                  const Metadata& metadata, const GeoReference& reference)
{
  checkBands(path, bands);
  const GridFrame& frame = bands.front().layer->frame();

  files::writeFile(path, {});  // gives the system's own reason where GDAL only says that it failed
  const GdalErrors errors;
  Dataset dataset = createDataset(path, frame, bands.size());
  bool written = dataset && writeHeader(*dataset, frame, metadata, reference);
  for (std::size_t i = 0; written && i < bands.size(); ++i)
    written =
        writeBand(*dataset->GetRasterBand(static_cast<int>(i) + 1), bands[i], reference.origin.z);
  if (dataset) dataset->FlushCache();
  dataset.reset();
  if (!written || errors.any()) files::throwUnwritten(path, errors.first());
}

GeoReference readGeoReference(const std::string& path)
{
  const GdalErrors errors;
  return readReference(*openDataset(path, errors), path);
}

Layer<float> readGeoTiffBand(const std::string& path, const std::string& bandName)
{
  const GdalErrors errors;
  const Dataset dataset = openDataset(path, errors);
  GDALRasterBand& band = findBand(*dataset, path, bandName);
  Layer<float> layer(readFrame(*dataset, path), kNoData);
  const GridFrame& frame = layer.frame();
  for (int line = 0; line < frame.height; ++line)
    if (band.RasterIO(GF_Read, 0, line, frame.width, 1, layer.row(frame.height - 1 - line),
                      frame.width, 1, GDT_Float32, 0, 0, nullptr) != CE_None)
      errors.raise("read", path);
  clearNoData(layer, band);
  return layer;
}

Metadata readGeoTiffMetadata(const std::string& path)
{
  const GdalErrors errors;
  const Dataset dataset = openDataset(path, errors);
  Metadata metadata;
  for (CSLConstList item = dataset->GetMetadata(); item && *item; ++item)
  {
    const std::string text = *item;  // NAME=VALUE
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos)
      metadata.emplace(text.substr(0, equals), text.substr(equals + 1));
  }
  return metadata;
}

}  // namespace mrpt_mapconv::grid
