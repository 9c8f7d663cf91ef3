#include "GeoTiffReference.h"

#include <mrpt_mapconv/grid/CoordinateSystem.h>
#include <mrpt_mapconv/params/Text.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "SpatialReference.h"

namespace mrpt_mapconv::grid
{
namespace
{
constexpr std::array<const char*, 3> kOriginItems{"originX", "originY", "originZ"};
/** Of files whose coordinates are not in metres: their unit, and the cells' size, which a division
 * by it rounds [m]. */
constexpr const char *kUnitItem = "metresPerUnit", *kCellItem = "cellSize";

bool writeItem(GDALDataset& dataset, const char* item, double value)
{
  return dataset.SetMetadataItem(item, params::shortestText(value).c_str()) == CE_None;
}

/** The item's value, or `otherwise` in a file that lacks it. */
double readItem(GDALDataset& dataset, const std::string& path, const char* item, double otherwise)
{
  const char* text = dataset.GetMetadataItem(item);
  double value = otherwise;
  if (text && !params::readNumber(text, value))
    throw std::runtime_error("cannot read '" + path + "': its " + item + " is '" + text +
                             "', which is no number");
  return value;
}

/** The same of lengths. */
double readLength(GDALDataset& dataset, const std::string& path, const char* item, double otherwise)
{
  const double length = readItem(dataset, path, item, otherwise);
  if (!(length > 0))
    throw std::runtime_error("cannot read '" + path + "': its " + item + " is " +
                             params::shortestText(length) + ", which must be > 0");
  return length;
}

bool writeItems(GDALDataset& dataset, const GridFrame& frame, const GeoReference& reference)
{
  if (!reference.isLocal())
    for (std::size_t i = 0; i < kOriginItems.size(); ++i)
      if (!writeItem(dataset, kOriginItems.at(i), reference.origin[i])) return false;
  if (reference.unit == 1) return true;
  return writeItem(dataset, kUnitItem, reference.unit) &&
         writeItem(dataset, kCellItem, frame.resolution);
}

/** Heights of bands are in metres, so a system with other heights is written without them. */
bool writeSystem(GDALDataset& dataset, const std::string& coordinateSystem)
{
  if (coordinateSystem.empty()) return true;
  OGRSpatialReference system;
  if (!setSystem(system, coordinateSystem)) return false;
  const auto units = unitsOf(coordinateSystem);
  if (units && units->vertical.value_or(1) != 1) system.StripVertical();
  return dataset.SetSpatialRef(&system) == CE_None;
}

/** The integer key at `metres`, if there is one (to a ten-thousandth of a cell). */
std::optional<std::int32_t> keyAt(double metres, double resolution)
{
  const double cells = metres / resolution;
  const double key = std::round(cells);
  if (!(std::abs(key) < 1e9) || std::abs(cells - key) > 1e-4) return std::nullopt;
  return static_cast<std::int32_t>(key);
}
}  // namespace

bool writePlace(GDALDataset& dataset, const GridFrame& frame, const GeoReference& reference)
{
  const double unit = reference.unit, cell = frame.resolution / unit;
  double transform[6] = {(frame.xMin() + reference.origin.x) / unit, cell, 0,
                         (frame.yMax() + reference.origin.y) / unit, 0,    -cell};
  return dataset.SetGeoTransform(transform) == CE_None && writeItems(dataset, frame, reference) &&
         writeSystem(dataset, reference.coordinateSystem);
}

GeoReference readReference(GDALDataset& dataset, const std::string& path)
{
  GeoReference reference;
  for (std::size_t i = 0; i < kOriginItems.size(); ++i)
    reference.origin[i] = readItem(dataset, path, kOriginItems.at(i), 0);
  reference.unit = readLength(dataset, path, kUnitItem, 1);
  if (const auto* system = dataset.GetSpatialRef()) reference.coordinateSystem = nameOf(*system);
  return reference;
}

GridFrame readFrame(GDALDataset& dataset, const std::string& path)
{
  double t[6];
  if (dataset.GetGeoTransform(t) != CE_None)
    throw std::runtime_error("cannot read '" + path + "': it has no geotransform");
  if (!(t[1] > 0) || t[2] != 0 || t[4] != 0 || std::abs(t[5] + t[1]) > 1e-9 * t[1])
    throw std::runtime_error("cannot read '" + path +
                             "': its cells must be square and north up, not rotated");
  const GeoReference reference = readReference(dataset, path);
  const double cell = readLength(dataset, path, kCellItem, t[1] * reference.unit);
  const double left = t[0] * reference.unit - reference.origin.x,
               top = t[3] * reference.unit - reference.origin.y;
  const int height = dataset.GetRasterYSize();
  for (const double shift : {0.0, -0.5})
  {
    const auto x0 = keyAt(left - shift * cell, cell), yEnd = keyAt(top - shift * cell, cell);
    if (x0 && yEnd) return {cell, *x0, *yEnd - height, dataset.GetRasterXSize(), height, shift};
  }
  throw std::runtime_error("cannot read '" + path + "': its corner (" + std::to_string(left) +
                           ", " + std::to_string(top) +
                           ") must lie on a multiple of half the cell size " +
                           std::to_string(cell));
}

}  // namespace mrpt_mapconv::grid
