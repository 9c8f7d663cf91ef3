#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mapconv
{
/** \exception std::runtime_error unless a cloud can be written to that name, and it is not that of
 * the input */
void checkPointsFile(const std::string& pointsFile, const std::string& input);

/** Writes a cloud with other classes than it has, in the order of its points. From `.las` to `.las`
 * all else is copied; other formats get what PointCloud holds, and a warning names what that leaves
 * out.
 * \param input where the cloud was read from; "-": it cannot be read again
 * \exception std::runtime_error naming the file and the reason */
void writeClassified(const std::string& pointsFile, const std::string& input,
                     mrpt_mapconv::cloud::PointCloud cloud, std::vector<std::uint8_t> classes);

}  // namespace mapconv
