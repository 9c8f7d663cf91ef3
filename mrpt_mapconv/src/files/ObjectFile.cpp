#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/params/Require.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>

namespace mrpt_mapconv::files
{
namespace fs = std::filesystem;

/** zlib directly: MRPT's CFileGZInputStream does not tell the end of a file from damage. */
class ObjectFile::Archive : public mrpt::serialization::CArchive
{
 public:
  explicit Archive(const std::string& path) : m_file(gzopen(path.c_str(), "rb"))
  {
    if (m_file) gzbuffer(m_file, 1u << 18);
  }
  ~Archive() override
  {
    if (m_file) gzclose(m_file);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  bool isOpen() const { return m_file != nullptr; }
  bool isShort() const { return m_short; }  //!< something wanted more bytes than there were

  /** True at the end of whole data; the end of broken data is for read() to find. */
  bool atEnd()
  {
    const int c = gzgetc(m_file);
    if (c < 0) return error().empty();
    gzungetc(c, m_file);
    return false;
  }

  /** What zlib has to say; empty if all is well. */
  std::string error() const
  {
    int code = Z_OK;
    const char* text = gzerror(m_file, &code);
    return code == Z_OK || code == Z_STREAM_END ? "" : text;
  }

 protected:
  std::size_t write(const void*, std::size_t) override { throw std::logic_error("read only"); }

  std::size_t read(void* buffer, std::size_t size) override
  {
    constexpr std::size_t mostAtOnce = 1u << 30;
    auto* to = static_cast<char*>(buffer);
    for (std::size_t left = size; left > 0;)
    {
      const int n = gzread(m_file, to, static_cast<unsigned>(std::min(left, mostAtOnce)));
      if (n <= 0)
      {
        m_short = true;
        throw std::runtime_error("end of file");
      }
      to += n;
      left -= static_cast<std::size_t>(n);
    }
    return size;
  }

 private:
  gzFile m_file;
  bool m_short = false;
};

ObjectFile::ObjectFile(const std::string& path) : m_path(path)
{
  std::error_code error;
  const auto status = fs::status(path, error);
  if (!fs::exists(status)) throw std::runtime_error(path + ": no such file");
  if (fs::is_directory(status)) throw std::runtime_error(path + ": is a directory, not a file");
  if (fs::is_regular_file(status) && fs::file_size(path, error) == 0)
    throw std::runtime_error(path + ": is empty");
  m_archive = std::make_unique<Archive>(path);
  if (!m_archive->isOpen()) throw std::runtime_error(path + ": cannot be opened for reading");
}

ObjectFile::~ObjectFile() = default;

mrpt::serialization::CSerializable::Ptr ObjectFile::next()
{
  const std::string which = "object " + std::to_string(m_count + 1);
  std::string problem;
  try
  {
    while (!m_archive->atEnd())
    {
      auto object = m_archive->ReadObject();
      ++m_count;
      if (object) return object;
    }
    return nullptr;
  }
  catch (const std::bad_alloc&)
  {
    problem = "is damaged: " + which + " wants more memory than there is";
  }
  catch (const std::exception& e)
  {
    if (m_archive->isShort() && m_archive->error().empty())
      problem = "is truncated: it ends in the middle of " + which;
    else if (m_archive->isShort())
      problem = "is truncated or damaged: reading " + which + ": " + m_archive->error();
    else
      problem = m_count == 0 ? "is no file of MRPT objects, or of a newer MRPT"
                             : "is damaged: " + which + " cannot be read";
    if (const auto text = params::oneLine(e); text.find("not registered") != std::string::npos)
      problem = text;
  }
  throw std::runtime_error(m_path + ": " + problem);
}

}  // namespace mrpt_mapconv::files
