#include <mrpt_mapconv/cloud/CloudFields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "LasFile.h"
#include "LasHeader.h"
#include "LasRecords.h"
#include "OutputFile.h"

namespace mrpt_mapconv::cloud
{
namespace
{
/** How one coordinate becomes whole numbers of 32 bits. */
struct Axis
{
  const std::vector<double>& values;
  FileValue file;
  double scale = 1e-3, offset = 0, min = 0, max = 0;

  Axis(const PointCloud& cloud, Field field, const std::vector<double>& v)
      : values(v), file(cloud, field), offset(std::floor(file.of(0)))
  {
    constexpr double kMost = 2147483647.0;
    const auto range = rangeOf(cloud, field).value_or(Range{offset, offset});
    min = range.min;
    max = range.max;
    while (std::max(offset - min, max - offset) / scale > kMost) scale *= 10;
  }
  std::int32_t whole(std::size_t i) const
  {
    return static_cast<std::int32_t>(std::lround((file.of(values[i]) - offset) / scale));
  }
};

bool anyAbove(const std::vector<std::uint8_t>& values, unsigned limit)
{
  return std::any_of(values.begin(), values.end(), [&](std::uint8_t v) { return v > limit; });
}

/** 6 if 0 cannot hold the cloud. */
int pointFormatFor(const PointCloud& cloud)
{
  constexpr unsigned kMostReturns = 7;
  const bool isWide = !cloud.time.empty() || anyAbove(cloud.classification, kOldClassBits) ||
                      anyAbove(cloud.returnNumber, kMostReturns) ||
                      anyAbove(cloud.numberOfReturns, kMostReturns);
  return isWide ? 6 : 0;
}

bool intensitiesFit(const PointCloud& cloud)
{
  constexpr float kMost = 65535;
  return std::all_of(cloud.intensity.begin(), cloud.intensity.end(),
                     [](float v)
                     { return std::isnan(v) || (v >= 0 && v <= kMost && v == std::floor(v)); });
}

/** 0 where nobody knows, for which whole numbers have no sign. */
std::uint16_t wholeIntensity(float value)
{
  return std::isnan(value) ? std::uint16_t(0) : static_cast<std::uint16_t>(value);
}

template <class Number>
void put(std::string& bytes, std::size_t at, Number number)
{
  std::memcpy(&bytes.at(at), &number, sizeof number);
}

unsigned valueOr(unsigned other, const std::vector<std::uint8_t>& values, std::size_t i)
{
  return values.empty() ? other : values[i];
}

/** More than 15 returns are 15, as the format wants it. */
unsigned returnsOr1(const std::vector<std::uint8_t>& values, std::size_t i)
{
  return std::min(valueOr(1, values, i), 15U);
}

/** Points by their return, from the first on; others are not counted. */
std::array<std::uint64_t, 15> pointsByReturn(const PointCloud& cloud)
{
  std::array<std::uint64_t, 15> counts{};
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (const unsigned number = returnsOr1(cloud.returnNumber, i); number >= 1)
      ++counts.at(number - 1);
  return counts;
}

/** Numbers of points; those of 32 bits are 0 for formats that older versions do not have. */
void putCounts(const PointCloud& cloud, bool isOld, std::string& bytes)
{
  constexpr std::size_t kOldReturns = 5;
  const std::uint64_t points = cloud.size();
  const auto byReturn = pointsByReturn(cloud);
  put(bytes, las_at::kCount, points);
  for (std::size_t i = 0; i < byReturn.size(); ++i)
    put(bytes, las_at::kReturns + i * sizeof(std::uint64_t), byReturn.at(i));
  if (!isOld || points > std::numeric_limits<std::uint32_t>::max()) return;
  put(bytes, las_at::kOldCount, static_cast<std::uint32_t>(points));
  for (std::size_t i = 0; i < kOldReturns; ++i)
    put(bytes, las_at::kOldReturns + i * sizeof(std::uint32_t),
        static_cast<std::uint32_t>(byReturn.at(i)));
}

void putAxes(const std::array<Axis, 3>& axes, std::string& bytes)
{
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    put(bytes, las_at::kScale + i * sizeof(double), axes.at(i).scale);
    put(bytes, las_at::kOffset + i * sizeof(double), axes.at(i).offset);
    put(bytes, las_at::kLimits + 2 * i * sizeof(double), axes.at(i).max);
    put(bytes, las_at::kLimits + (2 * i + 1) * sizeof(double), axes.at(i).min);
  }
}

std::uint16_t encodingOf(const PointCloud& cloud, const std::string& projection)
{
  const unsigned wkt = holdsWkt(projection) ? kLasWkt : 0;
  const unsigned time = cloud.timeEpoch == TimeEpoch::AdjustedGps ? kLasAdjustedTime : 0;
  return static_cast<std::uint16_t>(wkt | time);
}

/** The header of LAS 1.4 and the record that follows it, if there is one. */
std::string headerOf(const PointCloud& cloud, int format, const std::array<Axis, 3>& axes)
{
  const LasPointLayout& layout = lasPointLayout(format);
  const std::string record = projectionRecord(cloud.coordinateSystem);
  std::string bytes(kLasHeader14, '\0');
  bytes.replace(0, 4, "LASF");
  put(bytes, las_at::kEncoding, encodingOf(cloud, record));
  put(bytes, las_at::kMajor, std::uint8_t(1));
  put(bytes, las_at::kMinor, std::uint8_t(4));
  bytes.replace(las_at::kSystem, 5, "OTHER");
  bytes.replace(las_at::kSoftware, 12, "mrpt_mapconv");
  put(bytes, las_at::kHeaderSize, static_cast<std::uint16_t>(kLasHeader14));
  put(bytes, las_at::kPointsAt, static_cast<std::uint32_t>(kLasHeader14 + record.size()));
  put(bytes, las_at::kRecords, std::uint32_t(record.empty() ? 0 : 1));
  put(bytes, las_at::kPointFormat, static_cast<std::uint8_t>(format));
  put(bytes, las_at::kPointSize, static_cast<std::uint16_t>(layout.size));
  putCounts(cloud, layout.isOld, bytes);
  putAxes(axes, bytes);
  return bytes + record;
}

/** The bytes of a point of format 0 or 6. */
std::string pointOf(const PointCloud& cloud, std::size_t i, const LasPointLayout& layout,
                    const std::array<Axis, 3>& axes, bool hasIntensity)
{
  std::string bytes(layout.size, '\0');
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    put(bytes, axis * sizeof(std::int32_t), axes.at(axis).whole(i));
  if (hasIntensity) put(bytes, LasPointLayout::kIntensity, wholeIntensity(cloud.intensity[i]));
  const unsigned returns = returnsOr1(cloud.numberOfReturns, i) << (layout.isOld ? 3U : 4U) |
                           returnsOr1(cloud.returnNumber, i);
  put(bytes, LasPointLayout::kReturns, static_cast<std::uint8_t>(returns));
  const unsigned flags = valueOr(0, cloud.withheld, i) != 0 ? layout.withheldBit() : 0U;
  put(bytes, LasPointLayout::kFlags, static_cast<std::uint8_t>(flags));
  const unsigned itsClass = valueOr(0, cloud.classification, i);
  bytes[layout.classAt()] =
      static_cast<char>(static_cast<unsigned char>(bytes[layout.classAt()]) | itsClass);
  if (!cloud.time.empty()) put(bytes, layout.timeAt, cloud.time[i]);
  return bytes;
}
}  // namespace

void writeLas(const std::string& path, const PointCloud& cloud)
{
  const std::array<Axis, 3> axes = {Axis(cloud, Field::X, cloud.x), Axis(cloud, Field::Y, cloud.y),
                                    Axis(cloud, Field::Z, cloud.z)};
  const int format = pointFormatFor(cloud);
  const bool hasIntensity = !cloud.intensity.empty() && intensitiesFit(cloud);
  OutputFile file(path);
  file.bytes() = headerOf(cloud, format, axes);
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    file.bytes() += pointOf(cloud, i, lasPointLayout(format), axes, hasIntensity);
    file.writeBlock();
  }
  file.close();
}

}  // namespace mrpt_mapconv::cloud
