#pragma once

#include <string>

namespace mrpt_mapconv::maps
{
/** Reads the text of an ini file, for mrpt::config::CConfigFileMemory, and checks its lines: MRPT
 * passes over those that it does not understand, so a forgotten "=" would go unnoticed.
 * \exception std::runtime_error in one line naming the file and the reason if it cannot be read, or
 * the file and the line that is no section, comment or key = value */
std::string readIniText(const std::string& path);

}  // namespace mrpt_mapconv::maps
