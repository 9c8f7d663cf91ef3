#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace mrpt_mapconv::files
{
/** A file, device or pipe that is read once, from its first byte to its last, and is never asked to
 * go back. What is gzipped is unpacked, whatever its name is. */
class InputStream
{
 public:
  /** Opens it. \exception std::runtime_error in one line naming the file, if it is missing, a
   * folder, empty or may not be read */
  explicit InputStream(const std::string& path);
  /** What is piped into the program; `name()` is "stdin".
   * \exception std::runtime_error if that is a terminal or closed */
  static InputStream standardInput();

  InputStream(InputStream&&) noexcept;
  ~InputStream();

  /** How messages call it: the path, or "stdin". */
  const std::string& name() const { return m_name; }
  /** Bytes on disk of a regular file, packed or not; nothing for all else. */
  std::optional<std::uintmax_t> fileSize() const { return m_fileSize; }

  /** The first bytes (kPreview, or all there are), which are not taken away by that. Only before
   * the first read(). */
  std::string_view preview();
  static constexpr std::size_t kPreview = 4096;

  /** Reads up to `size` bytes: fewer only at the end or where error() says why. */
  std::size_t read(void* to, std::size_t size);
  /** The next bytes, `most` at most. \exception std::runtime_error naming the file and saying what
   * is wrong with it: cut off, damaged or not readable */
  std::string readUpTo(std::size_t most);
  /** True at the end of whole data; the end of broken data is for read() to find. */
  bool atEnd();
  /** What prevented reading on; empty if nothing did. */
  std::string error() const;

 private:
  struct Unpacker;
  InputStream(std::string name, int descriptor);

  std::string m_name;
  std::unique_ptr<Unpacker> m_unpacker;
  std::optional<std::uintmax_t> m_fileSize;
  std::string m_preview;
  std::size_t m_used = 0;  //!< bytes of the preview that have been read
};

}  // namespace mrpt_mapconv::files
