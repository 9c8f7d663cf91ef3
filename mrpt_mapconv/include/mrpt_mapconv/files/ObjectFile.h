#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <cstddef>
#include <memory>
#include <string>

namespace mrpt_mapconv::files
{
/** A file of serialized MRPT objects, gzipped or plain, read one after another.
 *
 * Stricter than MRPT's own reading, which takes a file that ends in the middle of an object for a
 * complete one, and accepts buffers that were only filled in part.
 */
class ObjectFile
{
 public:
  /** Opens the file.
   * \exception std::runtime_error in one line naming the file, if it is missing, a directory,
   * unreadable or empty */
  explicit ObjectFile(const std::string& path);
  ~ObjectFile();
  ObjectFile(const ObjectFile&) = delete;
  ObjectFile& operator=(const ObjectFile&) = delete;

  /** The next object; null at the end of the file. Objects stored as null are skipped.
   * \exception std::runtime_error in one line naming the file: it ends in the middle of an object
   * or of its compressed data, holds something that is no MRPT object, or an object of a class that
   * is not registered */
  mrpt::serialization::CSerializable::Ptr next();

  const std::string& path() const { return m_path; }

 private:
  class Archive;
  std::string m_path;
  std::unique_ptr<Archive> m_archive;
  std::size_t m_count = 0;  //!< objects read so far
};

}  // namespace mrpt_mapconv::files
