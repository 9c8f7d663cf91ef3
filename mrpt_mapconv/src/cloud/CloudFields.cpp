#include <mrpt_mapconv/cloud/CloudFields.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

namespace mrpt_mapconv::cloud
{
namespace
{
struct Alias
{
  std::string_view name;
  Field field;
};

constexpr Alias kAliases[] = {
    {"x", Field::X},
    {"easting", Field::X},
    {"y", Field::Y},
    {"northing", Field::Y},
    {"z", Field::Z},
    {"elevation", Field::Z},
    {"time", Field::Time},
    {"gpstime", Field::Time},
    {"timestamp", Field::Time},
    {"t", Field::Time},
    {"intensity", Field::Intensity},
    {"i", Field::Intensity},
    {"reflectance", Field::Intensity},
    {"returnnumber", Field::ReturnNumber},
    {"numberofreturns", Field::NumberOfReturns},
    {"numreturns", Field::NumberOfReturns},
    {"classification", Field::Classification},
    {"class", Field::Classification},
    {"withheld", Field::Withheld},
};

/** Small letters and digits only, up to a bracket. */
std::string plainName(std::string_view name)
{
  name = name.substr(0, name.find_first_of("[("));
  std::string plain;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) plain += c;
  plain = params::lowerCase(plain);
  constexpr std::string_view kScalar = "scalar";
  return plain.compare(0, kScalar.size(), kScalar) == 0 ? plain.substr(kScalar.size()) : plain;
}
}  // namespace

std::optional<Field> fieldNamed(std::string_view name)
{
  const std::string plain = plainName(name);
  const auto* alias = std::find_if(std::begin(kAliases), std::end(kAliases),
                                   [&](const Alias& a) { return a.name == plain; });
  if (alias == std::end(kAliases)) return {};
  return alias->field;
}

FieldSet fieldsOf(const PointCloud& cloud)
{
  FieldSet fields;
  visitFields(cloud, [&](Field field, const char*, const auto& values)
              { fields.set(indexOf(field), field <= Field::Z || !values.empty()); });
  return fields;
}

FileValue::FileValue(const PointCloud& cloud, Field field)
    : m_origin(field <= Field::Z ? cloud.origin[indexOf(field)] : 0),
      m_unit(field < Field::Z    ? cloud.unit
             : field == Field::Z ? cloud.heightUnit
                                 : 1)
{
}

double FileValue::of(double value) const
{
  if (m_unit == 1) return value + m_origin;
  constexpr double kDecimals = 1e8;  // a product and a quotient by the unit leave noise behind them
  return std::round((value + m_origin) / m_unit * kDecimals) / kDecimals;
}

std::optional<Range> rangeOf(const PointCloud& cloud, Field wanted)
{
  std::optional<Range> range;
  visitFields(cloud,
              [&](Field field, const char*, const auto& values)
              {
                if (field != wanted) return;
                for (const auto value : values)
                {
                  const auto number = static_cast<double>(value);
                  if (!std::isfinite(number)) continue;
                  if (!range) range = Range{number, number};
                  range->min = std::min(range->min, number);
                  range->max = std::max(range->max, number);
                }
              });
  if (!range) return range;
  const FileValue file(cloud, wanted);
  return Range{file.of(range->min), file.of(range->max)};
}

}  // namespace mrpt_mapconv::cloud
