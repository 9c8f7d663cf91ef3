#pragma once

#include <mrpt_mapconv/files/InputStream.h>
#include <mrpt_mapconv/observation/PoseTrack.h>

#include <string>

namespace mrpt_mapconv::observation
{
/** Units of coordinates [m]. */
struct LengthUnits
{
  double horizontal = 1;  //!< of x and y
  double vertical = 1;    //!< of z
};

/** The time of a trajectory or a cloud, in whose own epoch it has so many seconds, as PoseTrack has
 * it: to 1e-7 s. */
mrpt::system::TTimeStamp timeStampOf(double seconds);

/** Reads the poses of a sensor or robot over time, a line each; lines are separated into columns by
 * commas, semicolons or blanks, `#` begins a comment, a first line of names is passed over:
 * - 7 columns, as `mapconv simulate` writes: t, x, y, z, yaw, pitch, roll [s, m, rad];
 * - 8 columns, as the TUM data sets have: t, x, y, z, qx, qy, qz, qw;
 * - 28 columns: as 7, and the 21 terms of the covariance's upper triangle, row by row in MRPT's
 * order x, y, z, yaw, pitch, roll.
 * \param units of the file's lengths; they become metres
 * \exception std::runtime_error naming the file and the line's number, and what would be right @{
 */
PoseTrack readTrajectory(files::InputStream& stream, const LengthUnits& units = {});
PoseTrack readTrajectoryFile(const std::string& path, const LengthUnits& units = {});
/** @} */

}  // namespace mrpt_mapconv::observation
