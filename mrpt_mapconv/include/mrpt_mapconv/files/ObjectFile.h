#pragma once

#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/files/InputStream.h>

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
   * unreadable, empty or of a kind that others read (see foreignKindOf()) */
  explicit ObjectFile(const std::string& path);
  /** The same of something that has been opened, and of which nothing has been read. */
  explicit ObjectFile(InputStream stream);
  ObjectFile(ObjectFile&&) noexcept;
  ~ObjectFile();

  /** The next object; null at the end of the file. Objects stored as null are skipped.
   * \exception std::runtime_error in one line naming the file: it ends in the middle of an object
   * or of its compressed data, holds something that is no MRPT object, or an object of a class that
   * is not registered */
  mrpt::serialization::CSerializable::Ptr next();
  /** What next() is going to return. \exception std::runtime_error as next() */
  mrpt::serialization::CSerializable::Ptr peek();

  /** How messages call the file. */
  const std::string& path() const { return m_path; }

 private:
  class Archive;
  mrpt::serialization::CSerializable::Ptr read();

  std::string m_path;
  std::unique_ptr<Archive> m_archive;
  mrpt::serialization::CSerializable::Ptr m_next;  //!< that has been read, but not taken
  std::size_t m_count = 0;                         //!< objects read so far
};

}  // namespace mrpt_mapconv::files
