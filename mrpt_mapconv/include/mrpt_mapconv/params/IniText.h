#pragma once

#include <string>

namespace mrpt_mapconv::params
{
/** Reads the text of an ini file, for mrpt::config::CConfigFileMemory, and checks its lines: MRPT
 * passes over those that it does not understand, so a forgotten "=" would go unnoticed, and of
 * sections and keys that are there twice (in small or capital letters) it mixes both without a
 * word. \exception std::runtime_error in one line naming the file and the reason if it cannot be
 * read, or the file and the line that is no section, comment or key = value, or both lines of what
 * is there twice */
std::string readIniText(const std::string& path);

}  // namespace mrpt_mapconv::params
