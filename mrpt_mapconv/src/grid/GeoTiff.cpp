#include <cpl_string.h>
#include <gdal_priv.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/params/Text.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "GdalErrors.h"

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

constexpr std::array<const char*, 3> kOriginItems{"originX", "originY", "originZ"};

bool writeReference(GDALDataset& dataset, const GeoReference& reference)
{
  if (!reference.isLocal())
    for (std::size_t i = 0; i < kOriginItems.size(); ++i)
      if (dataset.SetMetadataItem(kOriginItems[i],
                                  params::shortestText(reference.origin[i]).c_str()) != CE_None)
        return false;
  if (reference.coordinateSystem.empty()) return true;
  OGRSpatialReference system;
  return system.SetFromUserInput(reference.coordinateSystem.c_str()) == OGRERR_NONE &&
         dataset.SetSpatialRef(&system) == CE_None;
}

bool writeHeader(GDALDataset& dataset, const GridFrame& frame, const Metadata& metadata,
                 const GeoReference& reference)
{
  double transform[6] = {frame.xMin() + reference.origin.x,
                         frame.resolution,
                         0,
                         frame.yMax() + reference.origin.y,
                         0,
                         -frame.resolution};
  if (dataset.SetGeoTransform(transform) != CE_None) return false;
  if (!writeReference(dataset, reference)) return false;
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

/** The integer key at `metres`, if there is one (to a ten-thousandth of a cell). */
std::optional<std::int32_t> keyAt(double metres, double resolution)
{
  const double cells = metres / resolution;
  const double key = std::round(cells);
  if (!(std::abs(key) < 1e9) || std::abs(cells - key) > 1e-4) return std::nullopt;
  return static_cast<std::int32_t>(key);
}

GeoReference referenceOf(GDALDataset& dataset, const std::string& path)
{
  GeoReference reference;
  for (std::size_t i = 0; i < kOriginItems.size(); ++i)
    if (const char* text = dataset.GetMetadataItem(kOriginItems[i]))
      if (!params::readNumber(text, reference.origin[i]))
        throw std::runtime_error("cannot read '" + path + "': its " + kOriginItems[i] + " is '" +
                                 text + "', which is no number");
  if (const auto* system = dataset.GetSpatialRef())
  {
    const char *authority = system->GetAuthorityName(nullptr),
               *code = system->GetAuthorityCode(nullptr);
    if (authority && code)
      reference.coordinateSystem = std::string(authority) + ":" + code;
    else
    {
      char* wkt = nullptr;
      if (system->exportToWkt(&wkt) == OGRERR_NONE) reference.coordinateSystem = wkt;
      CPLFree(wkt);
    }
  }
  return reference;
}

GridFrame readFrame(GDALDataset& dataset, const std::string& path)
{
  double t[6];
  if (dataset.GetGeoTransform(t) != CE_None)
    throw std::runtime_error("cannot read '" + path + "': it has no geotransform");
  const auto origin = referenceOf(dataset, path).origin;
  t[0] -= origin.x;
  t[3] -= origin.y;
  if (!(t[1] > 0) || t[2] != 0 || t[4] != 0 || std::abs(t[5] + t[1]) > 1e-9 * t[1])
    throw std::runtime_error("cannot read '" + path +
                             "': its cells must be square and north up, not rotated");
  const int height = dataset.GetRasterYSize();
  for (const double shift : {0.0, -0.5})
  {
    const auto x0 = keyAt(t[0] - shift * t[1], t[1]), yEnd = keyAt(t[3] - shift * t[1], t[1]);
    if (x0 && yEnd) return {t[1], *x0, *yEnd - height, dataset.GetRasterXSize(), height, shift};
  }
  throw std::runtime_error("cannot read '" + path + "': its corner (" + std::to_string(t[0]) +
                           ", " + std::to_string(t[3]) +
                           ") must lie on a multiple of half the cell size " +
                           std::to_string(t[1]));
}

/** Turns a file's own no-data value into NaN. */
void clearNoData(Layer<float>& layer, GDALRasterBand& band)
{
  int has = 0;
  const auto noData = static_cast<float>(band.GetNoDataValue(&has));
  if (has) std::replace(layer.cells().begin(), layer.cells().end(), noData, kNoData);
}
}  // namespace

void requireCoordinateSystem(const std::string& coordinateSystem)
{
  OGRSpatialReference system;
  const GdalErrors errors;
  if (!coordinateSystem.empty() && system.SetFromUserInput(coordinateSystem.c_str()) != OGRERR_NONE)
    throw std::runtime_error("'" + coordinateSystem +
                             "' is no coordinate system that is known; EPSG:32633, say, would be");
}

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
  return referenceOf(*openDataset(path, errors), path);
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
