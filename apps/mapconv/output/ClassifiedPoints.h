#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/files/AtomicFile.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mapconv
{
/** The file of a cloud whose points got other classes; it appears when it is committed or not at
 * all. */
class ClassifiedPoints
{
 public:
  /** \param input where the cloud is read from; "-": it cannot be read again
   * \exception std::runtime_error naming the file and the reason unless a cloud can be written
   * there; also if it is the input */
  ClassifiedPoints(const std::string& pointsFile, const std::string& input);

  /** Writes the points in their order. From `.las` to `.las` all else is copied; other formats get
   * what PointCloud holds, and a warning names what that leaves out.
   * \exception std::runtime_error likewise */
  void write(mrpt_mapconv::cloud::PointCloud cloud, std::vector<std::uint8_t> classes);
  /** To be committed when it has been written. */
  mrpt_mapconv::files::AtomicFile& file() { return m_file; }

 private:
  const std::string m_pointsFile, m_input;
  mrpt_mapconv::files::AtomicFile m_file;
};

}  // namespace mapconv
