#pragma once

#include <mrpt_mapconv/scan/ProfileParams.h>

#include <string>

namespace mrpt_mapconv::scan
{
/** The gist of how scans are seen, for people, e.g. "wholeShape, objects from 0.05 to 1.5 m, walls
 * from 2.3 to 2.6 m". */
std::string summaryOf(const ProfileParams& params);

/** That the structure slice holds the ceiling, and which one would not, e.g. "the ceiling at 2.45 m
 * is in the structure slice (2.2 to 2.6 m) and passes for walls: …".
 * \param height of the ceiling above the robot's base [m] */
std::string ceilingText(double height, const ProfileParams& params);

/** That the slices overlap, what comes of it, and what would be right. */
std::string overlapText(const ProfileParams& params);

}  // namespace mrpt_mapconv::scan
