#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mrpt_mapconv::grid
{
/** What the coordinates of a system are. */
enum class SystemKind : std::uint8_t
{
  Plane,       //!< lengths on a map; the only ones of which maps are made here
  Geographic,  //!< degrees
  Geocentric   //!< lengths, but z leads from the middle of the Earth
};

/** Kind and units of the coordinates of a system. */
struct SystemUnits
{
  SystemKind kind = SystemKind::Plane;
  double horizontal = 1;           //!< of x and y, unless they are degrees [m]
  std::optional<double> vertical;  //!< of heights, where the system has them [m]

  /** Of z: surveys that say nothing of it measure it as they do x and y [m]. */
  double ofHeights() const { return vertical.value_or(horizontal); }
  bool operator==(const SystemUnits& o) const
  {
    return kind == o.kind && horizontal == o.horizontal && vertical == o.vertical;
  }
};

/** A foot, and that of the surveys of the United States [m]. */
constexpr double kFoot = 0.3048, kSurveyFoot = 1200.0 / 3937.0;

/** \param coordinateSystem "EPSG:N" or WKT; never the name of a file or an address
 * \return nothing for what GDAL does not know, and for an empty one */
std::optional<SystemUnits> unitsOf(const std::string& coordinateSystem);

/** \exception std::runtime_error unless GDAL knows the coordinate system, or it is empty */
void requireCoordinateSystem(const std::string& coordinateSystem);

/** A unit in words, of which there are several: "m", "feet", "US survey feet", "units of 0.5 m".
 * \param metres of one */
std::string unitInWords(double metres);

}  // namespace mrpt_mapconv::grid
