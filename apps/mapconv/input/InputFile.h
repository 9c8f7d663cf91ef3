#pragma once

#include <string>

namespace mapconv
{
/** What a file seems to hold, so which reader is asked to make sense of it. */
enum class FileKind
{
  Octree,     //!< OctoMap's `.bt` or `.ot`
  SimpleMap,  //!< `.simplemap`
  Rawlog,     //!< `.rawlog`
  Object      //!< anything else: serialized MRPT objects
};

/** Tells a file's kind by its first bytes where they are clear, else by its extension; ".gz" at the
 * end of a name is passed over. A file that is not there is no error here, but the reader's. */
FileKind kindOf(const std::string& path);

}  // namespace mapconv
