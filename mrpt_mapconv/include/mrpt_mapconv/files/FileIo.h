#pragma once

#include <string>
#include <string_view>

namespace mrpt_mapconv::files
{
/** Writes (or overwrites) a file with these bytes and closes it.
 * \exception std::runtime_error naming the file and the system's reason, also if the disk is full
 */
void writeFile(const std::string& path, std::string_view bytes);

/** The ending of a file's name with its dot, in small letters; ".gz" is passed over. */
std::string endingOf(const std::string& name);

/** Makes sure that a file somebody has written and closed has reached the disk: errors that the
 * system reports late (full disk, broken device) show here.
 * \exception std::runtime_error naming the file and the system's reason */
void checkWritten(const std::string& path);

/** For a file that another library could not write without saying why: appends to it (which
 * keeps the room that it takes) until the system says it, but at most 64 MB, more than a picture
 * has that a library removes when it cannot write all of it.
 * \exception std::runtime_error always, naming the file and the system's reason, or else `what` is
 * wrong with it, e.g. "the PNG is incomplete" */
[[noreturn]] void throwUnwritten(const std::string& path, const std::string& what);

/** Throws the one-line error "cannot <action> '<path>': <the system's reason>".
 * \param action such as "write"
 * \param systemError value of errno
 * \exception std::runtime_error always */
[[noreturn]] void throwFileError(const std::string& action, const std::string& path,
                                 int systemError);

}  // namespace mrpt_mapconv::files
