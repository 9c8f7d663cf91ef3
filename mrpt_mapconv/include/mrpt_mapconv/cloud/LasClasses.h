#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::cloud
{
/** Copies a `.las` and gives its points other classes; all else stays as it is, byte for byte, also
 * the class of points that are withheld. The copy appears whole or not at all.
 * \param classes of all points, in the file's order; those of formats 0 to 5 are at most 31
 * \exception std::runtime_error naming the file and the reason if one cannot be read or written, or
 * if `classes` are not as many as its points or do not fit */
void copyLasWithClasses(const std::string& from, const std::string& to,
                        const std::vector<std::uint8_t>& classes);

}  // namespace mrpt_mapconv::cloud
