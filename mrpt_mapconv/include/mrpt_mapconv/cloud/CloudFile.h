#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/files/InputStream.h>

#include <optional>
#include <string>

namespace mrpt_mapconv::cloud
{
/** How a file of points is read. */
struct CloudReading
{
  /** What is taken off the coordinates, in the file's units; none: x and y of the first point,
   * rounded down to whole metres, if any point is farther than 10 km from the origin, else nothing.
   */
  std::optional<mrpt::math::TPoint3D> origin = {};
  /** Names of the columns of a text, separated by commas ("x,y,z,_,time"; names that no field has
   * are passed over). Empty: as its header line says, else the first three are x, y and z. */
  std::string columns = {};
  /** Units of the coordinates; none: as the file says, else metres. */
  std::optional<grid::SystemUnits> units = {};
};

/** Whether it is a file of points that readCloud() reads, see files::cloudFormatOf(). */
bool isCloud(files::InputStream& stream);

/** Reads `.las` (1.0 to 1.4), `.ply`, `.pcd`, text (`.xyz`, `.txt`, `.csv`) or KITTI's `.bin`.
 * \exception std::runtime_error in one line naming the file and what is wrong with it: missing,
 * empty, truncated, of a kind that nothing here reads (with a command that converts it), a header
 * that lies, a line of text that is no point (by number) */
PointCloud readCloud(files::InputStream& stream, const CloudReading& reading = {});
PointCloud readCloudFile(const std::string& path, const CloudReading& reading = {});

/** \exception std::runtime_error unless the file's name ends in one that writeCloudFile() knows, of
 * a format that has classes */
void requireNameForClasses(const std::string& path);

/** Writes a cloud in the format that the file's name ends with, in the units that it was read in,
 * with its attributes as far as the format has them; the file appears whole or not at all.
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writeCloudFile(const std::string& path, const PointCloud& cloud);

}  // namespace mrpt_mapconv::cloud
