#include <type_traits>

#include "BinaryPoints.h"
#include "PlyFile.h"

namespace mrpt_mapconv::cloud
{
void writePly(const std::string& path, const PointCloud& cloud)
{
  OutputFile file(path);
  std::string& header = file.bytes();
  header =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(cloud.size()) + "\n";
  visitPresent(cloud,
               [&](Field, const char* name, const auto& values)
               {
                 using Value = typename std::decay_t<decltype(values)>::value_type;
                 const char* type = std::is_same_v<Value, double>  ? "double"
                                    : std::is_same_v<Value, float> ? "float"
                                                                   : "uchar";
                 header += std::string("property ") + type + " " + name + "\n";
               });
  header += "end_header\n";
  writePoints(cloud, file);
  file.close();
}

}  // namespace mrpt_mapconv::cloud
