#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/RosMap.h>
#include <mrpt_mapconv/params/Text.h>

#include <cctype>
#include <stdexcept>

namespace mrpt_mapconv::grid
{
namespace
{
char pixel(float occupancy)
{
  if (isOccupied(occupancy)) return static_cast<char>(0);
  return static_cast<char>(isFree(occupancy) ? 254 : 205);
}

std::string pgm(const Layer<float>& occupancy)
{
  const GridFrame& frame = occupancy.frame();
  std::string bytes =
      "P5\n" + std::to_string(frame.width) + " " + std::to_string(frame.height) + "\n255\n";
  bytes.reserve(bytes.size() + frame.size());
  for (std::int32_t iy = frame.height - 1; iy >= 0; --iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix) bytes += pixel(occupancy.at(ix, iy));
  return bytes;
}

/** Never "-0". */
std::string exact(double value) { return params::decimalText(value + 0.0); }

/** A string as YAML takes it: as it is if it is simple, else in quotes. */
std::string yamlString(const std::string& text)
{
  const auto simple = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  const auto harmless = [&](char c) { return simple(c) || c == '.' || c == '_' || c == '-'; };
  if (!text.empty() && simple(text.front()) && std::all_of(text.begin(), text.end(), harmless))
    return text;
  std::string out = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string yaml(const std::string& imageName, const GridFrame& frame,
                 const mrpt::math::TPoint3D& origin)
{
  return "image: " + yamlString(imageName) +
         "\n"
         "mode: trinary\n"
         "resolution: " +
         exact(frame.resolution) +
         "\n"
         "origin: [" +
         exact(frame.xMin() + origin.x) + ", " + exact(frame.yMin() + origin.y) +
         ", 0]\n"
         "negate: 0\n"
         "occupied_thresh: 0.65\n"
         "free_thresh: 0.196\n";
}
}  // namespace

void writeRosMap(const std::string& pgmPath, const std::string& yamlPath,
                 const std::string& imageName, const Layer<float>& occupancy,
                 const GeoReference& reference)
{
  if (occupancy.frame().empty())
    throw std::invalid_argument("ROS map '" + yamlPath + "': the layer has no cells");
  files::writeFile(pgmPath, pgm(occupancy));
  files::writeFile(yamlPath, yaml(imageName, occupancy.frame(), reference.origin));
}

}  // namespace mrpt_mapconv::grid
