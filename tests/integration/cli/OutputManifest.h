#pragma once

#include <string>

namespace mrpt_mapconv::testing
{
/** Says what the files of a folder hold, in lines that are the same whenever the content is:
 * - names of all files, in order;
 * - `.tif`: size, geotransform, metadata, and of each band name, type, range and CRC of its floats;
 * - `.gridmap`: CRC of the object's bytes, without the compression;
 * - `.yaml`: its text; `.png`: width and height; `.3Dscene`: nothing; others: size and CRC. */
std::string manifestOf(const std::string& folder);

}  // namespace mrpt_mapconv::testing
