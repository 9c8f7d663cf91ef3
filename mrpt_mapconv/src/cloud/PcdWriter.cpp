#include <type_traits>

#include "BinaryPoints.h"
#include "PcdFile.h"

namespace mrpt_mapconv::cloud
{
void writePcd(const std::string& path, const PointCloud& cloud)
{
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  visitPresent(cloud,
               [&](Field, const char* name, const auto& values)
               {
                 using Value = typename std::decay_t<decltype(values)>::value_type;
                 fields += std::string(" ") + name;
                 sizes += " " + std::to_string(sizeof(Value));
                 types += std::is_floating_point_v<Value> ? " F" : " U";
                 counts += " 1";
               });
  const std::string points = std::to_string(cloud.size());
  OutputFile file(path);
  file.bytes() = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "\n" +
                 sizes + "\n" + types + "\n" + counts + "\nWIDTH " + points +
                 "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA binary\n";
  writePoints(cloud, file);
  file.close();
}

}  // namespace mrpt_mapconv::cloud
