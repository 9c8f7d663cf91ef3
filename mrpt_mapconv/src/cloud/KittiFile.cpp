#include "KittiFile.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "CloudBuilder.h"
#include "Columns.h"
#include "OutputFile.h"

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr std::size_t kPoint = 4 * sizeof(float);  // [bytes]
constexpr double kFarthest = 10e3;  // [m]; no lidar sees farther, and floats have millimetres there

bool isFar(double coordinate)
{
  return std::isfinite(coordinate) && std::abs(coordinate) > kFarthest;
}
}  // namespace

PointCloud readKitti(BlockInput& input, const CloudReading& reading)
{
  Columns columns;
  for (const char* name : {"x", "y", "z", "intensity"}) columns.add(name, NumberType::Float32);
  CloudBuilder builder(input.name(), columns.fields());
  const std::uint64_t points = input.fileSize().value_or(0) / kPoint;
  builder.reserve(points, input.fileSize(), kPoint);
  while (const char* point = input.take(kPoint))
  {
    const Row row = binaryRow(columns, point);
    if (isFar(row[0]) || isFar(row[1]) || isFar(row[2]))
      input.fail("is by its name and size a scan of KITTI, but its point " +
                 std::to_string(builder.seen() + 1) + " would be more than 10 km away");
    builder.add(row);
  }
  if (input.skip(1)) input.fail("has not whole points of KITTI, which have 16 bytes each");
  PointCloud cloud = std::move(builder).finished(reading);
  cloud.format = "KITTI";
  return cloud;
}

void writeKitti(const std::string& path, const PointCloud& cloud)
{
  OutputFile file(path);
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    for (const double v :
         {cloud.x[i] + cloud.origin.x, cloud.y[i] + cloud.origin.y, cloud.z[i] + cloud.origin.z})
    {
      if (isFar(v))
        throw std::runtime_error("cannot write '" + path +
                                 "': coordinates beyond 10 km do not fit the floats of KITTI's "
                                 ".bin; .las, .ply, .pcd and .csv keep them");
      appendNumber(file.bytes(), static_cast<float>(v));
    }
    appendNumber(file.bytes(), cloud.intensity.empty() ? 0.0F : cloud.intensity[i]);
    file.writeBlock();
  }
  file.close();
}

}  // namespace mrpt_mapconv::cloud
