#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/ObjectStream.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <stdexcept>

namespace mrpt_mapconv::files
{
namespace
{
/** The size modulo 2^32 of what a gzip file holds, which are its last four bytes. */
std::uint32_t sizeAtEnd(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(-4, std::ios::end);
  std::uint32_t size = 0;
  for (int shift = 0; shift < 32; shift += 8)
    size |= static_cast<std::uint32_t>(file.get() & 0xFF) << shift;
  return size;
}
}  // namespace

std::string serialized(const mrpt::serialization::CSerializable& object)
{
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  return {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()};
}

ObjectStream::ObjectStream(const std::string& path) : m_path(path)
{
  files::writeFile(path, {});  // gives the system's reason if that cannot be
  if (!m_file.open(path)) files::throwFileError("write", path, errno);
}

void ObjectStream::write(const mrpt::serialization::CSerializable& object)
{
  write(serialized(object));
}

void ObjectStream::write(std::string_view bytes)
{
  if (bytes.empty() || m_file.Write(bytes.data(), bytes.size()) == bytes.size()) return;
  files::throwUnwritten(m_path, "it is incomplete");
}

void ObjectStream::finish()
{
  const auto size = static_cast<std::uint32_t>(m_file.getPosition());
  m_file.close();  // does not say whether it could write the rest
  files::checkWritten(m_path);
  if (sizeAtEnd(m_path) != size) files::throwUnwritten(m_path, "it is incomplete");
}

SimpleMapStream::SimpleMapStream(const std::string& path, std::uint32_t keyFrames)
    : m_stream(path), m_missing(keyFrames)
{
  // An empty map, cut open where its number of key frames stands, before the mark of its end.
  const std::string empty = serialized(mrpt::maps::CSimpleMap());
  const std::size_t countAt = empty.size() - 1 - sizeof(keyFrames);
  std::string count;
  for (int shift = 0; shift < 32; shift += 8)
    count.push_back(static_cast<char>(keyFrames >> shift & 0xFF));
  m_stream.write(empty.substr(0, countAt) + count);
  m_end = empty.substr(empty.size() - 1);
}

void SimpleMapStream::write(const mrpt::serialization::CSerializable& pose,
                            const mrpt::serialization::CSerializable& frame)
{
  if (m_missing == 0) throw std::logic_error("more key frames than were announced");
  --m_missing;
  m_stream.write(pose);
  m_stream.write(frame);
}

void SimpleMapStream::finish()
{
  if (m_missing != 0) throw std::logic_error("fewer key frames than were announced");
  m_stream.write(m_end);
  m_stream.finish();
}

}  // namespace mrpt_mapconv::files
