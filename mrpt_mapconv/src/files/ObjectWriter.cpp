#define ZLIB_CONST  // input to zlib is const
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/ObjectWriter.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace mrpt_mapconv::files
{
namespace
{
/** Compresses bytes into one gzip member. */
std::string gzip(const Bytef* data, std::uint64_t size)
{
  constexpr int kGzipFormat = MAX_WBITS + 16, kUsualMemory = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipFormat, kUsualMemory,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("gzip compression failed");
  std::string out;
  std::string buffer(1 << 18, '\0');
  int state = Z_OK;
  do
  {
    if (stream.avail_in == 0)  // zlib counts in 32 bits
    {
      const auto part = std::min<std::uint64_t>(size, std::numeric_limits<uInt>::max());
      stream.next_in = data;
      stream.avail_in = static_cast<uInt>(part);
      data += part;
      size -= part;
    }
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = deflate(&stream, size == 0 ? Z_FINISH : Z_NO_FLUSH);
    out.append(buffer.data(), buffer.size() - stream.avail_out);
  } while (state == Z_OK || state == Z_BUF_ERROR);
  deflateEnd(&stream);
  if (state != Z_STREAM_END) throw std::runtime_error("gzip compression failed");
  return out;
}
}  // namespace

void writeObject(const std::string& path, const mrpt::serialization::CSerializable& object)
{
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << object;
  writeFile(path, gzip(static_cast<const Bytef*>(stream.getRawBufferData()),
                       stream.getTotalBytesCount()));
}

}  // namespace mrpt_mapconv::files
