#pragma once

#include <mrpt_mapconv/cloud/CloudFields.h>

#include <type_traits>

#include "Numbers.h"
#include "OutputFile.h"

namespace mrpt_mapconv::cloud
{
/** Tells a visitor of the fields that a cloud has: field, name, values. */
template <class V>
void visitPresent(const PointCloud& cloud, V&& v)
{
  const FieldSet fields = fieldsOf(cloud);
  visitFields(cloud,
              [&](Field field, const char* name, const auto& values)
              {
                if (fields[indexOf(field)]) v(field, name, values);
              });
}

/** Writes all fields of each point, coordinates as files have them, in the types of memory. */
inline void writePoints(const PointCloud& cloud, OutputFile& file)
{
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    visitPresent(cloud,
                 [&](Field field, const char*, const auto& values)
                 {
                   using Value = typename std::decay_t<decltype(values)>::value_type;
                   if constexpr (std::is_same_v<Value, double>)
                     appendNumber(file.bytes(), FileValue(cloud, field).of(values[i]));
                   else
                     appendNumber(file.bytes(), values[i]);
                 });
    file.writeBlock();
  }
}

}  // namespace mrpt_mapconv::cloud
