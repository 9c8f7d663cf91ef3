#include <mrpt_mapconv/sim/SampleMaps.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "VoxelCanvas.h"

namespace mrpt_mapconv::sim
{
namespace
{
using State = VoxelCanvas::State;

/** A box in metres, measured from the building's south-west corner and the floor's upper face. */
struct Box
{
  double x0, x1, y0, y1, z0, z1;
};

constexpr double kLength = 12.0, kWidth = 8.0, kCeiling = 2.6;
constexpr double kWall = 0.15;
constexpr double kCornerX = -4.0, kCornerY = -3.0;  // the building's corner in the map's frame

constexpr Box kWestRoom = {kWall, 6.95, kWall, kWidth - kWall, 0, kCeiling};
constexpr Box kEastRoom = {7.10, kLength - kWall, kWall, kWidth - kWall, 0, kCeiling};
constexpr Box kDoor = {6.95, 7.10, 3.4, 4.4, 0, 2.05};  // what is left above is the lintel
constexpr Box kWindow = {2.5, 4.5, 0, kWall, 0.9, 2.1};
constexpr Box kLowWall = {5.2, 5.35, 5.0, kWidth - kWall, 0, 0.5};
constexpr Box kPlatform = {9.85, kLength - kWall, 5.35, kWidth - kWall, 0, 0.6};
constexpr Box kRamp = {10.35, kLength - kWall, 2.35, 5.35, 0, 0.6};
constexpr Box kTable = {2.6, 4.2, 2.6, 3.5, 0, 0.75};
constexpr Box kShelf = {1.5, 4.5, 7.45, kWidth - kWall, 0, 2.0};

class Builder
{
 public:
  explicit Builder(double resolution)
      : m_resolution(resolution),
        // one more voxel below for the floor and one above for the ceiling
        m_canvas({{cell(kCornerX), cell(kCornerY), -1},
                  {cell(kCornerX + kLength) - 1, cell(kCornerY + kWidth) - 1, cell(kCeiling)}})
  {
  }

  void shell()
  {
    m_canvas.fill(m_canvas.box(), State::Occupied);
    for (const Box& room : {kWestRoom, kEastRoom, kDoor, kWindow}) paint(room, State::Free);
  }

  void solid(const Box& box) { paint(box, State::Occupied); }

  /** Rises towards +y, from the floor to the box's height. */
  void ramp(const Box& box)
  {
    const KeyBox step = keys(box);
    const std::int32_t length = step.max[1] - step.min[1] + 1;
    const std::int32_t height = step.max[2] - step.min[2] + 1;
    for (std::int32_t i = 0; i < length; ++i)
    {
      KeyBox slice = step;
      slice.min[1] = slice.max[1] = step.min[1] + i;
      // the slope's height in the middle of the step, rounded
      slice.max[2] = step.min[2] + ((2 * i + 1) * height + length) / (2 * length) - 1;
      m_canvas.fill(slice, State::Occupied);
    }
  }

  void table(const Box& box)
  {
    constexpr double kTop = 0.05, kLeg = 0.1;
    solid({box.x0, box.x1, box.y0, box.y1, box.z1 - kTop, box.z1});
    for (const double x : {box.x0, box.x1 - kLeg})
      for (const double y : {box.y0, box.y1 - kLeg}) solid({x, x + kLeg, y, y + kLeg, 0, box.z1});
  }

  /** Boards full of books, with a hand's breadth of air above them. */
  void shelf(const Box& box)
  {
    constexpr double kBoard = 0.4, kAir = 0.1;
    solid(box);
    for (int i = 1; i * kBoard <= box.z1 + 1e-9; ++i)
      paint({box.x0, box.x1, box.y0, box.y1 - kAir, i * kBoard - kAir - 0.05, i * kBoard - 0.05},
            State::Free);
  }

  std::unique_ptr<octomap::OcTree> finish()
  {
    m_canvas.forgetUnseen();
    return m_canvas.toOctree(m_resolution);
  }

 private:
  std::int32_t cell(double metres) const
  {
    return static_cast<std::int32_t>(std::lround(metres / m_resolution));
  }
  /** The voxels of a box; at least one on each axis. */
  KeyBox keys(const Box& b) const
  {
    const KeyBox begin = {{cell(kCornerX + b.x0), cell(kCornerY + b.y0), cell(b.z0)}, {}};
    const auto last = [this](std::int32_t first, double end)
    { return std::max(first, cell(end) - 1); };
    return {begin.min,
            {last(begin.min[0], kCornerX + b.x1), last(begin.min[1], kCornerY + b.y1),
             last(begin.min[2], b.z1)}};
  }
  void paint(const Box& box, State state) { m_canvas.fill(keys(box), state); }

  double m_resolution;
  VoxelCanvas m_canvas;
};
}  // namespace

std::unique_ptr<octomap::OcTree> buildingMap(double resolution)
{
  if (!(resolution >= 0.02 && resolution <= 0.5))
    throw std::invalid_argument("buildingMap: resolution is " + std::to_string(resolution) +
                                " m, but must lie in [0.02, 0.5]");
  Builder builder(resolution);
  builder.shell();
  builder.table(kTable);
  builder.solid(kLowWall);
  builder.shelf(kShelf);
  builder.ramp(kRamp);
  builder.solid(kPlatform);
  return builder.finish();
}

}  // namespace mrpt_mapconv::sim
