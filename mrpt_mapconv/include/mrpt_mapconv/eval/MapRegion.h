#pragma once

#include <mrpt_mapconv/sim/Primitive.h>

#include <string>

namespace mrpt_mapconv::eval
{
/** A rectangle in which maps are looked at more closely. */
struct MapRegion
{
  std::string name;     //!< what it is called
  std::string kind;     //!< what leads into it
  sim::Footprint area;  //!< that is judged
  sim::Footprint room;  //!< the one behind, of which scans may be left out
};

/** True if a rectangle holds a place [m]. */
inline bool holds(const sim::Footprint& rectangle, double x, double y)
{
  return x >= rectangle.xMin && x < rectangle.xMax && y >= rectangle.yMin && y < rectangle.yMax;
}

}  // namespace mrpt_mapconv::eval
