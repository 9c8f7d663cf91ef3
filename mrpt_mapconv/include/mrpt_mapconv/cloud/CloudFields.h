#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

namespace mrpt_mapconv::cloud
{
/** What a point of a cloud can have, in the order of PointCloud and of columns that are written. */
enum class Field : std::uint8_t
{
  X,
  Y,
  Z,
  Time,
  Intensity,
  ReturnNumber,
  NumberOfReturns,
  Classification,
  Withheld
};
constexpr std::size_t kFields = 9;

/** Which fields a file or cloud has. */
using FieldSet = std::bitset<kFields>;
constexpr std::size_t indexOf(Field field) { return static_cast<std::size_t>(field); }

/** Tells a visitor about each field: which it is, its name in files and JSON, its values. */
template <class Cloud, class V>
void visitFields(Cloud& cloud, V&& v)
{
  v(Field::X, "x", cloud.x);
  v(Field::Y, "y", cloud.y);
  v(Field::Z, "z", cloud.z);
  v(Field::Time, "time", cloud.time);
  v(Field::Intensity, "intensity", cloud.intensity);
  v(Field::ReturnNumber, "returnNumber", cloud.returnNumber);
  v(Field::NumberOfReturns, "numberOfReturns", cloud.numberOfReturns);
  v(Field::Classification, "classification", cloud.classification);
  v(Field::Withheld, "withheld", cloud.withheld);
}

/** The field that files of others call so: in any capitals, with or without underscores, a unit in
 * brackets and CloudCompare's "scalar_" ("GpsTime", "scalar_Return_Number", "X[m]"). */
std::optional<Field> fieldNamed(std::string_view name);

/** Fields of which the cloud has values; x, y and z always. */
FieldSet fieldsOf(const PointCloud& cloud);

/** A value as files have it: of coordinates with the origin, in the file's units. */
class FileValue
{
 public:
  FileValue(const PointCloud& cloud, Field field);
  double of(double value) const;

 private:
  double m_origin, m_unit;
};

/** Smallest and largest of finite values, in the file's coordinates. */
struct Range
{
  double min, max;
};
/** \return none if the cloud has no finite value of the field */
std::optional<Range> rangeOf(const PointCloud& cloud, Field field);

}  // namespace mrpt_mapconv::cloud
