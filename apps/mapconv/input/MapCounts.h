#pragma once

#include <string>

namespace mapconv
{
/** Warns about maps that an MRPT ini file asks for (NAME_count = …) but that no class stands
 * behind: MRPT itself ignores them silently. A file that cannot be read is left to the program to
 * complain. */
void warnUnknownMaps(const std::string& iniFile);

}  // namespace mapconv
