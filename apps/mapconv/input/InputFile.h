#pragma once

#include <mrpt_mapconv/files/InputStream.h>

#include <string>

namespace mapconv
{
/** What help says of a file that may be piped in. */
constexpr const char* kOrStdin = "; - is what is piped in";

/** Opens a file that the command line names; "-" stands for what is piped into the program.
 * \exception std::runtime_error in one line naming the file and what is wrong with it */
mrpt_mapconv::files::InputStream openInput(const std::string& path);

/** How messages and summaries call what the command line names: the path, or "stdin". */
std::string shownName(const std::string& path);

/** Whether it is one of OctoMap's files (else MRPT's objects): by its first bytes, and by its name
 * for a file that is to be a `.bt` or `.ot` but does not begin as one. */
bool isOctree(mrpt_mapconv::files::InputStream& stream);

}  // namespace mapconv
