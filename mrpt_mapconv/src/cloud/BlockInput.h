#pragma once

#include <mrpt_mapconv/files/InputStream.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mrpt_mapconv::cloud
{
/** A file that is read in blocks, and given out as records or lines. Its memory is that of a block
 * or of the longest record, whatever a header promises. */
class BlockInput
{
 public:
  explicit BlockInput(files::InputStream& stream);

  const std::string& name() const { return m_stream.name(); }
  /** Bytes that were given out or skipped. */
  std::uint64_t position() const { return m_position; }
  /** Lines that were given out, so the number of the last one. */
  std::size_t lineNumber() const { return m_lines; }
  /** Of a regular file, packed or not [bytes]. */
  std::optional<std::uintmax_t> fileSize() const { return m_stream.fileSize(); }

  /** The next bytes, which stay where they are until the next call of any function; null, and
   * nothing is used, if fewer are left. \exception std::runtime_error naming the file, if it is
   * damaged */
  const char* take(std::size_t size)
  {
    if (m_end - m_begin < size && !fill(size)) return nullptr;
    const char* bytes = m_buffer.data() + m_begin;
    m_begin += size;
    m_position += size;
    return bytes;
  }
  /** The next bytes, `most` at most: fewer only at the end. */
  std::string bytes(std::uint64_t most);
  /** \return false if fewer bytes are left */
  bool skip(std::uint64_t size);
  /** The next line without its end ("\n" or "\r\n"), valid as take(). \return none at the end
   * \exception std::runtime_error naming the file, for lines that no text has */
  std::optional<std::string_view> line();

  /** \exception std::runtime_error always: "NAME: WHAT" */
  [[noreturn]] void fail(const std::string& what) const;
  /** \exception std::runtime_error always: "NAME: line N: WHAT", of the last line */
  [[noreturn]] void failLine(const std::string& what) const;
  /** \exception std::runtime_error always: the header promises more points than the file has */
  [[noreturn]] void failTruncated(std::uint64_t promised, std::uint64_t found) const;

 private:
  bool fill(std::size_t size);

  files::InputStream& m_stream;
  std::string m_buffer;
  std::size_t m_begin = 0, m_end = 0;  //!< what of the buffer is still to be given out
  std::uint64_t m_position = 0;
  std::size_t m_lines = 0;
};

}  // namespace mrpt_mapconv::cloud
