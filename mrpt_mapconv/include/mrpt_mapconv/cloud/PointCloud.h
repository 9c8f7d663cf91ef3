#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/grid/CoordinateSystem.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mrpt_mapconv::cloud
{
/** What a cloud's times count from. */
enum class TimeEpoch : std::uint8_t
{
  Unknown,
  GpsWeek,     //!< the beginning of the week, a Sunday
  AdjustedGps  //!< 1e9 s after that of GPS time, so 2011-09-14
};

/** Points as a file has them, but in metres, with what it says of each. Attributes that the file
 * lacks are empty; the others have one value for each point. */
struct PointCloud
{
  /** Was taken off all coordinates [m]; whole metres. Coordinates of national grids (UTM) have
   * millions of metres, of which a float would keep half a metre. */
  mrpt::math::TPoint3D origin{0, 0, 0};
  std::vector<double> x, y, z;  //!< less the origin [m]

  std::vector<double> time;                  //!< [s], in the file's own epoch
  TimeEpoch timeEpoch = TimeEpoch::Unknown;  //!< as a `.las` names it
  std::vector<float> intensity;
  std::vector<std::uint8_t> returnNumber;     //!< from 1 on
  std::vector<std::uint8_t> numberOfReturns;  //!< of the pulse
  /** Classes of the ASPRS: 0 never classified, 1 unclassified, 2 ground, 7 noise, … */
  std::vector<std::uint8_t> classification;
  /** 1 for points that the file marks as not to be used; they take no part in anything. */
  std::vector<std::uint8_t> withheld;

  std::string coordinateSystem;  //!< as WKT or "EPSG:N"; empty if the file names none
  /** What the file says of the units of its coordinates. */
  std::optional<grid::SystemUnits> namedUnits;
  /** What they were multiplied with when they were read [m]: 1 for degrees. @{ */
  double unit = 1;        //!< x and y
  double heightUnit = 1;  //!< z
  /** @} */
  std::string format;  //!< of the file, as people call it ("LAS 1.2, point format 3")
  std::vector<std::string> otherFields;  //!< names of what else the file says of each point
  std::size_t notFinite = 0;  //!< points that were left out, since a coordinate is NaN or infinite

  std::size_t size() const { return x.size(); }
  bool empty() const { return x.empty(); }
};

/** Classes of the ASPRS that are written here. */
constexpr std::uint8_t kUnclassified = 1, kGround = 2;

}  // namespace mrpt_mapconv::cloud
