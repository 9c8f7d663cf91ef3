#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/files/ForeignKind.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/params/Require.h>

#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

namespace mrpt_mapconv::files
{
using mrpt::serialization::CSerializable;

namespace
{
/** The class of which MRPT says that it is not registered; nothing if it says something else. */
std::optional<std::string> unknownClass(const std::string& error)
{
  const auto end = error.find("' which is not registered");
  const auto begin = error.find('\'') + 1;
  if (end == std::string::npos || begin > end) return std::nullopt;
  return error.substr(begin, end - begin);
}
}  // namespace

class ObjectFile::Archive : public mrpt::serialization::CArchive
{
 public:
  explicit Archive(InputStream stream) : m_stream(std::move(stream)) {}

  InputStream& stream() { return m_stream; }
  bool isShort() const { return m_short; }  //!< something wanted more bytes than there were

 protected:
  std::size_t write(const void*, std::size_t) override { throw std::logic_error("read only"); }

  std::size_t read(void* buffer, std::size_t size) override
  {
    if (m_stream.read(buffer, size) == size) return size;
    m_short = true;
    throw std::runtime_error("end of file");
  }

 private:
  InputStream m_stream;
  bool m_short = false;
};

ObjectFile::ObjectFile(const std::string& path) : ObjectFile(InputStream(path)) {}

ObjectFile::ObjectFile(InputStream stream) : m_path(stream.name())
{
  refuseForeignKinds(stream);
  if (!stream.preview().empty() && !beginsAsObject(stream.preview()))
    throw std::runtime_error(m_path +
                             ": is no file of MRPT objects (.rawlog, .simplemap or a map), nor of "
                             "another kind that is known here");
  m_archive = std::make_unique<Archive>(std::move(stream));
}

ObjectFile::ObjectFile(ObjectFile&&) noexcept = default;
ObjectFile::~ObjectFile() = default;

CSerializable::Ptr ObjectFile::peek()
{
  if (!m_next) m_next = read();
  return m_next;
}

CSerializable::Ptr ObjectFile::next() { return m_next ? std::exchange(m_next, nullptr) : read(); }

CSerializable::Ptr ObjectFile::read()
{
  const std::string which = "object " + std::to_string(m_count + 1);
  std::string problem;
  try
  {
    while (!m_archive->stream().atEnd())
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
    const std::string cause = m_archive->stream().error();
    if (m_archive->isShort() && cause.empty())
      problem = "is truncated: it ends in the middle of " + which;
    else if (m_archive->isShort())
      problem = "is truncated or damaged: reading " + which + ": " + cause;
    else
      problem = m_count == 0 ? "is no file of MRPT objects, or of a newer MRPT"
                             : "is damaged: " + which + " cannot be read";
    if (const auto name = unknownClass(params::oneLine(e)))
      problem = which + (name->empty() ? " has no class, so the file is damaged"
                                       : " is of the class '" + *name +
                                             "', which neither MRPT nor this library has: a plugin "
                                             "that has it goes into LD_PRELOAD; without one the "
                                             "file is of a newer MRPT, or damaged");
  }
  throw std::runtime_error(m_path + ": " + problem);
}

}  // namespace mrpt_mapconv::files
