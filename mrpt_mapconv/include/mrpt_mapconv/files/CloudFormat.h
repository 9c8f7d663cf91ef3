#pragma once

#include <mrpt_mapconv/files/ForeignKind.h>

#include <optional>
#include <string_view>

namespace mrpt_mapconv::files
{
/** Files of points that the room `cloud` reads. */
enum class CloudFormat
{
  Las,
  Ply,
  Pcd,
  Text,
  Kitti
};

/** Which of them a file is: by its first bytes, or by its name if its format has none of its own
 * (text, and KITTI's `.bin`, which also has whole points of 16 bytes). \return none for all other
 * files, packed ones (`.laz`) and files that do not begin as their name says */
std::optional<CloudFormat> cloudFormatOf(const FileTraits& file);

/** "a point cloud of PCL (.pcd)". */
std::string_view whatIs(CloudFormat format);

}  // namespace mrpt_mapconv::files
