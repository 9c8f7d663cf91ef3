#include "OutputManifest.h"

#include <cpl_string.h>
#include <gdal.h>
#include <mrpt/core/format.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/system/crc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include "Raster.h"
#include "support/TempDir.h"

namespace mrpt_mapconv::testing
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

std::string crcOf(const Bytes& bytes)
{
  return mrpt::format("CRC32 %08x", mrpt::system::compute_CRC32(bytes));
}

std::string sizeAndCrc(const Bytes& bytes)
{
  return std::to_string(bytes.size()) + " bytes, " + crcOf(bytes);
}

Bytes bytesOf(const std::string& file)
{
  const std::string text = readBytes(file);
  return {text.begin(), text.end()};
}

Bytes uncompressed(const std::string& file)
{
  mrpt::io::CFileGZInputStream in;
  if (!in.open(file)) throw std::runtime_error("cannot read " + file);
  Bytes bytes;
  std::array<std::uint8_t, 4096> part{};
  for (std::size_t count = 0; (count = in.Read(part.data(), part.size())) > 0;)
    bytes.insert(bytes.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
  return bytes;
}

/** As the file has them, but with one NaN for all. */
Bytes floatBytes(const std::vector<double>& cells)
{
  Bytes bytes(cells.size() * sizeof(float));
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const float cell = std::isnan(cells[i]) ? std::numeric_limits<float>::quiet_NaN()
                                            : static_cast<float>(cells[i]);
    std::memcpy(&bytes[i * sizeof(float)], &cell, sizeof(float));
  }
  return bytes;
}

std::string bandText(const Raster::Band& band)
{
  double low = INFINITY, high = -INFINITY;
  std::size_t known = 0;
  for (const double cell : band.cells)
  {
    if (std::isnan(cell)) continue;
    ++known;
    low = std::min(low, cell);
    high = std::max(high, cell);
  }
  return mrpt::format("  band %s %s, %s: %zu of %zu cells from %.9g to %.9g, ", band.name.c_str(),
                      band.type.c_str(), band.noDataIsNan ? "no data is NaN" : "all is data", known,
                      band.cells.size(), low, high) +
         crcOf(floatBytes(band.cells)) + "\n";
}

std::string metadataText(const std::string& file)
{
  GDALDatasetH data = GDALOpen(file.c_str(), GA_ReadOnly);
  if (!data) throw std::runtime_error("GDAL cannot open " + file);
  std::set<std::string> items;
  char** list = GDALGetMetadata(data, nullptr);
  for (int i = 0; i < CSLCount(list); ++i) items.insert(list[i]);
  std::string text = std::string("  projection '") + GDALGetProjectionRef(data) + "'\n";
  GDALClose(data);
  for (const auto& item : items) text += "  " + item + "\n";
  return text;
}

std::string rasterText(const std::string& file)
{
  const Raster raster = readRaster(file);
  std::string text = mrpt::format("%d x %d cells\n  transform", raster.width, raster.height);
  for (const double number : raster.transform) text += mrpt::format(" %.17g", number);
  text += "\n" + metadataText(file);
  for (const auto& band : raster.bands) text += bandText(band);
  return text;
}

/** Size of a PNG's picture, which its header gives, high byte first. */
std::string pictureText(const Bytes& bytes)
{
  constexpr std::size_t kWidth = 16, kHeight = 20;
  const auto number = [&bytes](std::size_t at)
  {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | bytes.at(at + i);
    return value;
  };
  return mrpt::format("%u x %u pixels\n", number(kWidth), number(kHeight));
}

std::string describe(const std::string& file)
{
  const auto ending = std::filesystem::path(file).extension();
  if (ending == ".tif") return rasterText(file);
  if (ending == ".gridmap") return "object of " + sizeAndCrc(uncompressed(file)) + "\n";
  if (ending == ".yaml") return "\n" + readBytes(file);
  if (ending == ".png") return pictureText(bytesOf(file));
  if (ending == ".3Dscene") return "is there\n";
  return sizeAndCrc(bytesOf(file)) + "\n";
}
}  // namespace

std::string manifestOf(const std::string& folder)
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  std::string text;
  for (const auto& name : names) text += name + ": " + describe(folder + "/" + name);
  return text;
}

}  // namespace mrpt_mapconv::testing
