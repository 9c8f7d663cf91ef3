#include <mrpt_mapconv/files/ObjectWriter.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace mrpt_mapconv::grid
{
namespace
{
using mrpt::maps::COccupancyGridMap2D;

/** Reaches the flag behind isEmpty(), which MRPT sets only when it inserts or loads by itself; a
 * map that calls itself empty is skipped by some of MRPT's programs. */
struct FilledFlag : COccupancyGridMap2D
{
  static void set(COccupancyGridMap2D& map) { map.*(&FilledFlag::m_is_empty) = false; }
};

/** Reaches the limits, which setSize() puts on multiples of the resolution. */
struct Limits : COccupancyGridMap2D
{
  static void set(COccupancyGridMap2D& map, const GridFrame& frame)
  {
    map.*(&Limits::m_xMin) = static_cast<float>(frame.xMin());
    map.*(&Limits::m_xMax) = static_cast<float>(frame.xMax());
    map.*(&Limits::m_yMin) = static_cast<float>(frame.yMin());
    map.*(&Limits::m_yMax) = static_cast<float>(frame.yMax());
  }
};

GridFrame unshifted(GridFrame frame)
{
  frame.shift = 0;
  return frame;
}

/** Each cell as 2 x 2 of half its size, which begin on multiples of that. */
Layer<float> halved(const Layer<float>& layer)
{
  const GridFrame& from = layer.frame();
  const GridFrame to{from.resolution / 2, 2 * from.x0 - 1, 2 * from.y0 - 1, 2 * from.width,
                     2 * from.height};
  Layer<float> out(to, kUnknown);
  for (std::int32_t y = 0; y < to.height; ++y)
    for (std::int32_t x = 0; x < to.width; ++x) out.at(x, y) = layer.at(x / 2, y / 2);
  return out;
}

}  // namespace

void checkGridMapFrame(const GridFrame& shifted)
{
  const GridFrame frame = unshifted(shifted);
  const auto resolution = static_cast<float>(frame.resolution);
  const auto size = [&](double min, double max)  // as MRPT counts cells
  {
    return std::llround((static_cast<double>(static_cast<float>(max)) -
                         static_cast<double>(static_cast<float>(min))) /
                        static_cast<double>(resolution));
  };
  const auto key = [&](double metres)
  {
    return std::llround(static_cast<double>(static_cast<float>(metres)) /
                        static_cast<double>(resolution));
  };
  if (resolution > 0 && std::isfinite(resolution) &&
      size(frame.xMin(), frame.xMax()) == frame.width &&
      size(frame.yMin(), frame.yMax()) == frame.height && key(frame.xMin()) == frame.x0 &&
      key(frame.yMin()) == frame.y0)
    return;
  std::ostringstream message;
  message << "grid map: MRPT's float limits cannot hold " << frame.width << " x " << frame.height
          << " cells of " << frame.resolution << " m from (" << frame.xMin() << ", " << frame.yMin()
          << "); move the map nearer to the origin";
  throw std::runtime_error(message.str());
}

void copyToGridMap(const Layer<float>& occupancy, COccupancyGridMap2D& map)
{
  if (occupancy.frame().empty()) throw std::invalid_argument("grid map: the layer has no cells");
  const GridFrame frame = unshifted(occupancy.frame());
  checkGridMapFrame(frame);
  map.setSize(static_cast<float>(frame.xMin()), static_cast<float>(frame.xMax()),
              static_cast<float>(frame.yMin()), static_cast<float>(frame.yMax()),
              static_cast<float>(frame.resolution));
  if (map.getSizeX() != static_cast<unsigned>(frame.width) ||
      map.getSizeY() != static_cast<unsigned>(frame.height))
    throw std::runtime_error("grid map: MRPT lays out " + std::to_string(map.getSizeX()) + " x " +
                             std::to_string(map.getSizeY()) + " cells instead of " +
                             std::to_string(frame.width) + " x " + std::to_string(frame.height));
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
  {
    const float* from = occupancy.row(iy);
    std::transform(from, from + frame.width, map.getRow(iy), rawGridCell);
  }
  if (occupancy.frame() != frame) Limits::set(map, occupancy.frame());
  FilledFlag::set(map);
}

void writeGridMap(const std::string& path, const Layer<float>& occupancy)
{
  COccupancyGridMap2D map;
  copyToGridMap(occupancy.frame().shift == 0 ? occupancy : halved(occupancy), map);
  files::writeObject(path, map);
}

}  // namespace mrpt_mapconv::grid
