#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/params/Text.h>

#include <type_traits>

#include "BinaryPoints.h"
#include "TextFile.h"

namespace mrpt_mapconv::cloud
{
void writeText(const std::string& path, const PointCloud& cloud)
{
  const bool isCsv = files::endingOf(path) == ".csv";
  const char separator = isCsv ? ',' : ' ';
  OutputFile file(path);
  std::string& text = file.bytes();
  const auto endLine = [&] { text.back() = '\n'; };
  if (!isCsv) text += "# ";
  visitPresent(cloud, [&](Field, const char* name, const auto&) { (text += name) += separator; });
  endLine();
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    visitPresent(cloud,
                 [&](Field field, const char*, const auto& values)
                 {
                   using Value = typename std::decay_t<decltype(values)>::value_type;
                   if constexpr (std::is_same_v<Value, double>)
                     text += params::shortestText(FileValue(cloud, field).of(values[i]));
                   else if constexpr (std::is_same_v<Value, float>)
                     text += params::shortestText(values[i]);
                   else
                     text += std::to_string(values[i]);
                   text += separator;
                 });
    endLine();
    file.writeBlock();
  }
  file.close();
}

}  // namespace mrpt_mapconv::cloud
