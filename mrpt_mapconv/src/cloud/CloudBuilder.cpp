#include "CloudBuilder.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr double kFar = 10e3;  // [m]; a float has millimetres there

bool isFinite(const Row& row)
{
  return std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]);
}

/** A number in the type of a field; what is beyond a float is the largest one. */
template <class Value>
Value fitting(double value)
{
  if constexpr (std::is_same_v<Value, float>)
  {
    constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
    if (!std::isnan(value)) value = std::clamp(value, -kMost, kMost);
  }
  return static_cast<Value>(value);
}

/** x and y of the first point, rounded down, if any is far from the origin. */
mrpt::math::TPoint3D automaticOrigin(const PointCloud& cloud)
{
  const auto isFar = [](double v) { return std::abs(v) > kFar; };
  const auto anyFar = [&](const std::vector<double>& v)
  { return std::any_of(v.begin(), v.end(), isFar); };
  if (!anyFar(cloud.x) && !anyFar(cloud.y) && !anyFar(cloud.z)) return {0, 0, 0};
  return {std::floor(cloud.x[0]), std::floor(cloud.y[0]), 0};  // heights stay heights
}

void takeOff(double origin, std::vector<double>& values)
{
  for (double& value : values) value -= origin;
}

void multiply(double unit, std::vector<double>& values)
{
  if (unit == 1) return;
  for (double& value : values) value *= unit;
}

/** Turns the coordinates of the file into metres; degrees stay degrees. */
void intoMetres(PointCloud& cloud, const grid::SystemUnits& units)
{
  if (units.kind == grid::SystemKind::Geographic) return;
  cloud.unit = units.horizontal;
  cloud.heightUnit = units.ofHeights();
  multiply(cloud.unit, cloud.x);
  multiply(cloud.unit, cloud.y);
  multiply(cloud.heightUnit, cloud.z);
}
}  // namespace

CloudBuilder::CloudBuilder(std::string name, FieldSet fields, std::size_t memory)
    : m_name(std::move(name)), m_fields(fields), m_memory(memory)
{
  visitFields(m_cloud,
              [&](Field field, const char*, const auto& values)
              {
                using Value = typename std::decay_t<decltype(values)>::value_type;
                if (m_fields[indexOf(field)]) m_bytesPerPoint += sizeof(Value);
              });
  m_mostPoints = m_memory / m_bytesPerPoint;
}

void CloudBuilder::requireMemoryFor(std::size_t points, const char* orMore) const
{
  if (points <= m_mostPoints) return;
  const auto inGigabytes = [](std::size_t bytes)
  { return mrpt::format("%.1f GB", static_cast<double>(bytes) / params::kMegabyte / 1e3); };
  throw std::runtime_error(m_name + ": its " + params::counted(points, "point") + orMore +
                           " need " + inGigabytes(points * m_bytesPerPoint) + " of memory, and " +
                           inGigabytes(m_memory) +
                           " are what three quarters of this machine have: thin it or cut it into "
                           "tiles, e.g. pdal tile IN.las OUT_#.las --length 500");
}

void CloudBuilder::reserve(std::uint64_t promised, const std::optional<std::uintmax_t>& fileSize,
                           std::size_t bytesPerPoint)
{
  const auto room = static_cast<std::size_t>(
      std::min<std::uintmax_t>(promised, fileSize.value_or(0) / bytesPerPoint));
  requireMemoryFor(room, "");
  visitFields(m_cloud,
              [&](Field field, const char*, auto& values)
              {
                if (m_fields[indexOf(field)]) values.reserve(room);
              });
}

void CloudBuilder::add(const Row& row)
{
  if (!isFinite(row))
  {
    ++m_cloud.notFinite;
    return;
  }
  requireMemoryFor(m_cloud.size() + 1, " or more");
  visitFields(m_cloud,
              [&](Field field, const char* name, auto& values)
              {
                if (!m_fields[indexOf(field)]) return;
                using Value = typename std::decay_t<decltype(values)>::value_type;
                const double value = row[indexOf(field)];
                if constexpr (std::is_integral_v<Value>)
                  if (!(value >= 0 && value <= std::numeric_limits<Value>::max() &&
                        value == std::floor(value)))
                    refuse(name, value);
                values.push_back(fitting<Value>(value));
              });
}

void CloudBuilder::refuse(const char* field, double value) const
{
  throw std::runtime_error(m_name + ": point " + std::to_string(seen()) + ": " + field + " = " +
                           params::shortestText(value) +
                           " is not valid: it must be a whole number of 0 to 255");
}

PointCloud CloudBuilder::finished(const CloudReading& reading,
                                  const std::optional<grid::SystemUnits>& named) &&
{
  if (m_cloud.empty())
    throw std::runtime_error(m_name +
                             (m_cloud.notFinite == 0
                                  ? ": holds no point"
                                  : ": holds no usable point: a coordinate of each of its " +
                                        std::to_string(m_cloud.notFinite) + " is NaN or infinite"));
  m_cloud.namedUnits = named;
  if (const auto& units = reading.units ? reading.units : named) intoMetres(m_cloud, *units);
  m_cloud.origin = automaticOrigin(m_cloud);
  if (const auto& o = reading.origin)
    m_cloud.origin = {o->x * m_cloud.unit, o->y * m_cloud.unit, o->z * m_cloud.heightUnit};
  takeOff(m_cloud.origin.x, m_cloud.x);
  takeOff(m_cloud.origin.y, m_cloud.y);
  takeOff(m_cloud.origin.z, m_cloud.z);
  return std::move(m_cloud);
}

}  // namespace mrpt_mapconv::cloud
