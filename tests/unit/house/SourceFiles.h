#pragma once

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

/** Reading a source tree. */
namespace mrpt_mapconv::house
{
/** The C++ files below a folder, sorted; none if there is no such folder. */
std::vector<std::filesystem::path> sourcesBelow(const std::filesystem::path& folder);

/** The files below a folder whose names end in one of these, sorted; none if there is no such
 * folder.
 */
std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder,
                                              const std::vector<std::string>& endings);

/** The names of what lies in a folder, sorted; none if there is no such folder. */
std::vector<std::string> namesIn(const std::filesystem::path& folder);

/** \exception std::runtime_error naming the file if it cannot be read */
std::string textOf(const std::filesystem::path& file);

/** What the pattern's first group matches, each time that the pattern is found. A `^` begins a
 * line.
 */
std::vector<std::string> allMatches(const std::string& text, const std::string& pattern);

}  // namespace mrpt_mapconv::house
