#include <fcntl.h>
#include <mrpt_mapconv/files/InputStream.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace mrpt_mapconv::files
{
namespace
{
int opened(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  throw std::runtime_error(path + ": " +
                           (errno == ENOENT ? "no such file"
                                            : "cannot be opened for reading: " +
                                                  std::generic_category().message(errno)));
}
}  // namespace

/** zlib directly: MRPT's CFileGZInputStream does not tell the end of a file from damage. */
struct InputStream::Unpacker
{
  explicit Unpacker(int descriptor) : file(gzdopen(descriptor, "rb"))
  {
    if (file)
      gzbuffer(file, 1U << 18U);
    else
      ::close(descriptor);
  }
  ~Unpacker()
  {
    if (file) gzclose(file);
  }
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  gzFile file;
};

InputStream::InputStream(const std::string& path) : InputStream(path, opened(path)) {}

InputStream InputStream::standardInput()
{
  if (::isatty(STDIN_FILENO) != 0)
    throw std::runtime_error("stdin: is a terminal; pipe a file into the program, or name one");
  const int descriptor = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
  if (descriptor < 0) throw std::runtime_error("stdin: is closed");
  return InputStream("stdin", descriptor);
}

InputStream::InputStream(std::string name, int descriptor)
    : m_name(std::move(name)), m_unpacker(std::make_unique<Unpacker>(descriptor))
{
  if (!m_unpacker->file) throw std::runtime_error(m_name + ": not enough memory to read it");
  struct stat status = {};
  if (::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode))
    throw std::runtime_error(m_name + ": is a directory, not a file");
  if (S_ISREG(status.st_mode)) m_fileSize = static_cast<std::uintmax_t>(status.st_size);
  if (preview().empty() && error().empty()) throw std::runtime_error(m_name + ": is empty");
}

InputStream::InputStream(InputStream&&) noexcept = default;
InputStream::~InputStream() = default;

std::string_view InputStream::preview()
{
  if (m_preview.empty() && m_used == 0)
  {
    std::string begin(kPreview, '\0');
    begin.resize(read(begin.data(), kPreview));
    m_preview = std::move(begin);
  }
  return m_preview;
}

std::size_t InputStream::read(void* to, std::size_t size)
{
  auto* out = static_cast<char*>(to);
  const std::size_t kept = std::min(size, m_preview.size() - m_used);
  std::memcpy(out, m_preview.data() + m_used, kept);
  m_used += kept;
  std::size_t count = kept;
  while (count < size)
  {
    constexpr std::size_t kMostAtOnce = 1U << 30U;
    const int n = gzread(m_unpacker->file, out + count,
                         static_cast<unsigned>(std::min(size - count, kMostAtOnce)));
    if (n <= 0) break;
    count += static_cast<std::size_t>(n);
  }
  return count;
}

std::string InputStream::readUpTo(std::size_t most)
{
  constexpr std::size_t kPiece = std::size_t(1) << 20U;  // a pipe does not tell its size
  std::string bytes;
  for (std::size_t size = 0; size < most;)
  {
    const std::size_t wanted = std::min(kPiece, most - size);
    bytes.resize(size + wanted);
    const std::size_t got = read(&bytes[size], wanted);
    size += got;
    bytes.resize(size);
    if (got < wanted) break;
  }
  if (bytes.size() < most && !error().empty())
    throw std::runtime_error(m_name + ": is truncated or damaged: " + error());
  return bytes;
}

bool InputStream::atEnd()
{
  if (m_used < m_preview.size()) return false;
  const int c = gzgetc(m_unpacker->file);
  if (c < 0) return error().empty();
  gzungetc(c, m_unpacker->file);
  return false;
}

std::string InputStream::error() const
{
  int code = Z_OK;
  std::string text = gzerror(m_unpacker->file, &code);
  if (code == Z_OK || code == Z_STREAM_END) return "";
  if (code == Z_ERRNO) return text;
  // zlib puts a name in front, which is that of a number here
  const auto colon = text.rfind(": ");
  return "unpacking (gzip) failed: " + (colon == std::string::npos ? text : text.substr(colon + 2));
}

}  // namespace mrpt_mapconv::files
