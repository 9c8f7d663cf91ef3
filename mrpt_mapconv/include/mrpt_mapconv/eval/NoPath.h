#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::eval
{
/** Why a map has no path for a robot where there is one in truth. "Made free" are only cells that
 * are free in truth. */
enum class NoPath : std::uint8_t
{
  EndUnknown,               //!< the robot could stand at both ends if unknown cells were made free
  EndOccupied,              //!< not even then
  Unknown,                  //!< there would be a way if unknown cells were made free
  FalseObstacle,            //!< likewise, if occupied ones were
  UnknownAndFalseObstacle,  //!< likewise, if both were, but neither alone is enough
  Truth,                    //!< not even then: something real is in the way
  Heights                   //!< there is a way over free cells, but not in 3D
};

/** How tables call them, in the order of the enumeration. */
inline const std::vector<std::string>& namesOf(NoPath)
{
  static const std::vector<std::string> names{"an end unknown",
                                              "an end occupied",
                                              "blocked by unknown",
                                              "blocked by a false obstacle",
                                              "blocked by unknown and false obstacles",
                                              "blocked in truth",
                                              "heights do not fit"};
  return names;
}

/** Whether a disc of this radius may stand at a place: no cell that is not free, or not on the
 * layer, is nearer than that to the place's own. See planning::planOnGrid(). */
bool canStand(const grid::Layer<float>& occupancy, const mrpt::math::TPoint2D& place,
              double radius);

/** Why there is no path on a map, found out by planning (planning::planOnGrid()) on it with some of
 * its cells made free.
 *
 * \param map, truth occupancy layers of the same resolution; each may have a frame of its own,
 * beyond which all is unknown
 * \param radius of the robot [m]
 * \exception std::invalid_argument for different resolutions, or as planOnGrid() */
NoPath whyNoPath(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                 const mrpt::math::TPoint2D& start, const mrpt::math::TPoint2D& goal,
                 double radius);

}  // namespace mrpt_mapconv::eval
