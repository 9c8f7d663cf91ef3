#include <mrpt_mapconv/params/Text.h>

#include <utility>

#include "CloudBuilder.h"
#include "LasFile.h"
#include "LasHeader.h"
#include "LasRecords.h"
#include "Numbers.h"

namespace mrpt_mapconv::cloud
{
namespace
{
FieldSet fieldsOf(const LasPointLayout& layout)
{
  FieldSet fields;
  fields.set();
  fields.set(indexOf(Field::Time), layout.timeAt > 0);
  return fields;
}

unsigned byteAt(const char* point, std::size_t at) { return static_cast<unsigned char>(point[at]); }

double coordinate(const LasHeader& header, const char* point, std::size_t axis)
{
  const auto whole =
      numberAt<std::int32_t>(point + LasPointLayout::kX + axis * sizeof(std::int32_t));
  return whole * header.scale[axis] + header.offset[axis];
}

Row rowOf(const LasHeader& header, const LasPointLayout& layout, const char* point)
{
  const unsigned returns = byteAt(point, LasPointLayout::kReturns);
  const unsigned returnBits = layout.isOld ? 3 : 4, mask = (1U << returnBits) - 1;
  const unsigned itsClass = byteAt(point, layout.classAt());
  const bool withheld = (byteAt(point, LasPointLayout::kFlags) & layout.withheldBit()) != 0;
  return {coordinate(header, point, 0),
          coordinate(header, point, 1),
          coordinate(header, point, 2),
          layout.timeAt > 0 ? numberAt<double>(point + layout.timeAt) : 0,
          static_cast<double>(numberAt<std::uint16_t>(point + LasPointLayout::kIntensity)),
          static_cast<double>(returns & mask),
          static_cast<double>((returns >> returnBits) & mask),
          static_cast<double>(layout.isOld ? itsClass & kOldClassBits : itsClass),
          withheld ? 1.0 : 0.0};
}
}  // namespace

PointCloud readLas(BlockInput& input, const CloudReading& reading)
{
  const LasHeader header = readLasHeader(input);
  LasProjection projection;
  readRecords(input, header, projection);

  const LasPointLayout& layout = lasPointLayout(header.pointFormat);
  CloudBuilder builder(input.name(), fieldsOf(layout));
  builder.reserve(header.points, input.fileSize(), header.pointSize);
  for (std::uint64_t i = 0; i < header.points; ++i)
  {
    const char* point = input.take(header.pointSize);
    if (!point) input.failTruncated(header.points, i);
    builder.add(rowOf(header, layout, point));
  }
  readLateRecords(input, header, projection);

  PointCloud cloud = std::move(builder).finished(reading, projection.units(header.wkt));
  cloud.format = "LAS 1." + std::to_string(header.minor) + ", point format " +
                 std::to_string(header.pointFormat);
  if (!cloud.time.empty())
    cloud.timeEpoch = header.adjustedTime ? TimeEpoch::AdjustedGps : TimeEpoch::GpsWeek;
  cloud.coordinateSystem = projection.text(header.wkt);
  return cloud;
}

}  // namespace mrpt_mapconv::cloud
