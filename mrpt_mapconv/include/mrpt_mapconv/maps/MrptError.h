#pragma once

#include <exception>
#include <string>

namespace mrpt_mapconv::maps
{
/** What an exception says, in one line: MRPT's own come with a frame, a location and a call stack,
 * which are of use to MRPT's developers only. */
std::string oneLine(const std::exception& error);

}  // namespace mrpt_mapconv::maps
