#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>

namespace mrpt_mapconv::cloud
{
/** A file that is written in blocks. Whether all has reached the disk is for files::AtomicFile to
 * find out. */
class OutputFile
{
 public:
  explicit OutputFile(const std::string& path);

  /** Where to append what is to be written next. */
  std::string& bytes() { return m_bytes; }
  /** Writes what has gathered, once it is a block. \exception std::runtime_error naming the file */
  void writeBlock();
  /** Writes all of it and closes the file. \exception as writeBlock() */
  void close();

 private:
  void write();

  std::string m_path, m_bytes;
  std::ofstream m_file;
};

}  // namespace mrpt_mapconv::cloud
