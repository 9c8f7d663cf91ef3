#include <mrpt/io/CMemoryStream.h>
#include <mrpt/io/zip.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/FileIo.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <cmath>
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

/** Gives the map the frame's size; false if MRPT's rounding makes it another frame. */
bool setFrame(COccupancyGridMap2D& map, const GridFrame& frame)
{
  const auto resolution = static_cast<float>(frame.resolution);
  const auto xMin = static_cast<float>(frame.xMin()), xMax = static_cast<float>(frame.xMax());
  const auto yMin = static_cast<float>(frame.yMin()), yMax = static_cast<float>(frame.yMax());
  if (!(resolution > 0) || !(xMin < xMax) || !(yMin < yMax)) return false;
  map.setSize(xMin, xMax, yMin, yMax, resolution);
  const auto key = [&](float metres)
  { return std::llround(static_cast<double>(metres) / static_cast<double>(resolution)); };
  return map.getSizeX() == static_cast<unsigned>(frame.width) &&
         map.getSizeY() == static_cast<unsigned>(frame.height) && key(map.getXMin()) == frame.x0 &&
         key(map.getYMin()) == frame.y0;
}

std::vector<std::uint8_t> serialized(const COccupancyGridMap2D& map)
{
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << map;
  const auto* data = static_cast<const std::uint8_t*>(stream.getRawBufferData());
  return {data, data + stream.getTotalBytesCount()};
}
}  // namespace

void copyToGridMap(const Layer<float>& occupancy, COccupancyGridMap2D& map)
{
  const GridFrame& frame = occupancy.frame();
  if (frame.empty()) throw std::invalid_argument("grid map: the layer has no cells");
  if (!setFrame(map, frame))
    throw std::runtime_error("grid map: MRPT's float limits cannot hold " +
                             std::to_string(frame.width) + " x " + std::to_string(frame.height) +
                             " cells of " + std::to_string(frame.resolution) + " m from (" +
                             std::to_string(frame.xMin()) + ", " + std::to_string(frame.yMin()) +
                             "); move the map nearer to the origin");
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
  {
    const float* from = occupancy.row(iy);
    std::transform(from, from + frame.width, map.getRow(iy), rawGridCell);
  }
  FilledFlag::set(map);
}

void writeGridMap(const std::string& path, const Layer<float>& occupancy)
{
  COccupancyGridMap2D map;
  copyToGridMap(occupancy, map);
  // Compressed in memory and written by ourselves: MRPT's file streams hide errors of closing.
  std::vector<std::uint8_t> bytes;
  constexpr int kUsualCompression = 6;
  if (!mrpt::io::zip::compress_gz_data_block(serialized(map), bytes, kUsualCompression))
    throw std::runtime_error("cannot write '" + path + "': compression failed");
  writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace mrpt_mapconv::grid
