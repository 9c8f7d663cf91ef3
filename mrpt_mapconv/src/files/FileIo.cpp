#include <fcntl.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/params/Text.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace mrpt_mapconv::files
{
namespace
{
/** A file descriptor that is closed on every way out. */
class Descriptor
{
 public:
  Descriptor(const std::string& path, int flags) : m_fd(::open(path.c_str(), flags, 0666)) {}
  ~Descriptor()
  {
    if (m_fd >= 0) ::close(m_fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return m_fd; }
  int close() { return ::close(std::exchange(m_fd, -1)); }

 private:
  int m_fd;
};

void writeAll(int fd, std::string_view bytes, const std::string& path)
{
  while (!bytes.empty())
  {
    const ssize_t count = ::write(fd, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throwFileError("write", path, errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

bool syncFails(int fd)
{
  // Devices and pipes cannot be synchronized and say so; that is no error of the file.
  return ::fsync(fd) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS;
}
}  // namespace

void throwFileError(const std::string& action, const std::string& path, int systemError)
{
  throw std::runtime_error("cannot " + action + " '" + path +
                           "': " + std::generic_category().message(systemError));
}

void throwUnwritten(const std::string& path, const std::string& what)
{
  constexpr std::size_t kPiece = std::size_t(1) << 16U, kMostPieces = 1024;
  const std::string piece(kPiece, '\0');
  Descriptor file(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC);
  if (file.get() < 0) throwFileError("write", path, errno);
  for (std::size_t i = 0; i < kMostPieces; ++i) writeAll(file.get(), piece, path);
  if (syncFails(file.get()) || file.close() != 0) throwFileError("write", path, errno);
  throw std::runtime_error("cannot write '" + path + "': " + what);
}

void writeFile(const std::string& path, std::string_view bytes)
{
  Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
  if (file.get() < 0) throwFileError("write", path, errno);
  writeAll(file.get(), bytes, path);
  if (file.close() != 0) throwFileError("write", path, errno);
}

std::string endingOf(const std::string& name)
{
  const std::filesystem::path path(name);
  const auto ending = params::lowerCase(path.extension().string());
  return ending == ".gz" ? params::lowerCase(path.stem().extension().string()) : ending;
}

void checkWritten(const std::string& path)
{
  Descriptor file(path, O_RDONLY | O_CLOEXEC);
  if (file.get() < 0) throwFileError("write", path, errno);
  if (syncFails(file.get())) throwFileError("write", path, errno);
  if (file.close() != 0) throwFileError("write", path, errno);
}

}  // namespace mrpt_mapconv::files
