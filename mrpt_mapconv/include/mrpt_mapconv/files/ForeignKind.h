#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mrpt_mapconv::files
{
class InputStream;

/** What is known of a file before it is read. */
struct FileTraits
{
  std::string name;                         //!< its path
  std::string_view begin;                   //!< its first bytes, unpacked
  std::optional<std::uintmax_t> size = {};  //!< in bytes, where that is known
};

/** Says what a file is that nothing here reads, and which program turns it into something that is
 * read: "is a bag of ROS 1; rosbag2rawlog (of mrpt-apps) makes a .rawlog of it". It is recognised
 * by its first bytes, or by name and size if its kind has none of its own.
 * \return empty for all other files */
std::string foreignKindOf(const FileTraits& file);

/** \exception std::runtime_error "NAME: " and what foreignKindOf() says, if it says something */
void refuseForeignKinds(InputStream& stream);

/** Whether these are the first bytes of MRPT's serialized objects: a length (of four bytes
 * in files of MRPT's first years) and the name of a class. */
bool beginsAsObject(std::string_view bytes);

}  // namespace mrpt_mapconv::files
