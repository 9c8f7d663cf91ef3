#include "OutputFile.h"

#include <mrpt_mapconv/files/FileIo.h>

namespace mrpt_mapconv::cloud
{
OutputFile::OutputFile(const std::string& path) : m_path(path), m_file(path, std::ios::binary) {}

void OutputFile::writeBlock()
{
  constexpr std::size_t kBlock = std::size_t(1) << 20U;
  if (m_bytes.size() >= kBlock) write();
}

void OutputFile::write()
{
  m_file.write(m_bytes.data(), static_cast<std::streamsize>(m_bytes.size()));
  if (!m_file) files::throwUnwritten(m_path, "the points are incomplete");
  m_bytes.clear();
}

void OutputFile::close()
{
  write();
  m_file.close();
  if (!m_file) files::throwUnwritten(m_path, "the points are incomplete");
}

}  // namespace mrpt_mapconv::cloud
