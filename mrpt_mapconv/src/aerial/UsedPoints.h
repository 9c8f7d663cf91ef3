#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/GridFrame.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace mrpt_mapconv::aerial
{
/** One value for each point of a cloud: 1 for those that take part. */
using UsedPoints = std::vector<std::uint8_t>;

/** Whether the file calls a point noise, which somebody has looked for. */
bool isNoise(const cloud::PointCloud& cloud, std::size_t point);

/** All points but those that the file withholds or calls noise and those without finite
 * coordinates. \exception std::runtime_error if none is left */
UsedPoints usablePoints(const cloud::PointCloud& cloud);

/** Of some values the smallest and the largest. */
struct Range
{
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  double length() const { return max - min; }
};
/** \param values one for each point */
Range rangeOf(const std::vector<double>& values, const UsedPoints& used);

/** Below this meanDistance() does not look closely [m]. */
constexpr double kFineDistance = 1;

/** Of used points, if they were spread evenly over where there are some [m]. */
double meanDistance(const cloud::PointCloud& cloud, const UsedPoints& used);

/** How a frame of cells is laid around points. */
struct Cells
{
  double resolution;        //!< [m]
  const char* name;         //!< of the parameter that says so, for errors
  double shift = 0;         //!< as that of a GridFrame
  std::int32_t margin = 0;  //!< more cells on all sides
};
/** A shift with which coordinates that are rounded to the resolution lie in the middle of cells. */
constexpr double kCentred = -0.5;

/** The smallest frame that holds all used points, and the margin.
 * \exception std::runtime_error if there would be more than 100 million cells, before there are */
grid::GridFrame frameAround(const cloud::PointCloud& cloud, const UsedPoints& used,
                            const Cells& cells);

/** The cell of a frame that holds a place, as an index into its layers. */
inline std::size_t cellAt(const grid::GridFrame& frame, double x, double y)
{
  const double off = frame.shift * frame.resolution;
  return frame.indexOfKey(grid::cellKey(x - off, frame.resolution),
                          grid::cellKey(y - off, frame.resolution));
}

}  // namespace mrpt_mapconv::aerial
