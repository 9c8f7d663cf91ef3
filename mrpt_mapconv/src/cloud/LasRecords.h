#pragma once

#include <mrpt_mapconv/grid/CoordinateSystem.h>

#include <optional>
#include <string>

#include "LasHeader.h"

namespace mrpt_mapconv::cloud
{
/** What the variable length records of a `.las` say of its coordinate system. */
struct LasProjection
{
  std::string wkt, epsg;  //!< empty: not given so
  /** What the keys of GeoTIFF say, of which those of units outdo the system's. @{ */
  std::optional<grid::SystemKind> kind;
  std::optional<double> horizontal, vertical;  //!< [m]
  /** @} */

  /** As the header wants it, else the one that is there. */
  std::string text(bool preferWkt) const { return prefersWkt(preferWkt) ? wkt : epsg; }
  /** What it says of the units of coordinates; nothing if it says nothing. */
  std::optional<grid::SystemUnits> units(bool preferWkt) const;

 private:
  bool prefersWkt(bool preferWkt) const { return (preferWkt && !wkt.empty()) || epsg.empty(); }
};

/** Reads the records that follow the header, up to the first point.
 * \exception std::runtime_error naming the file, if they do not fit between the two */
void readRecords(BlockInput& input, const LasHeader& header, LasProjection& projection);
/** Reads those behind the points; nothing if there are none. \exception as readRecords() */
void readLateRecords(BlockInput& input, const LasHeader& header, LasProjection& projection);

/** The record of GeoTIFF's keys for "EPSG:N", that of WKT for all else, with its head; empty for
 * no system, and for a text that no record has room for. */
std::string projectionRecord(const std::string& coordinateSystem);
/** Whether such a record holds WKT, which the header has to say. */
bool holdsWkt(const std::string& record);

}  // namespace mrpt_mapconv::cloud
