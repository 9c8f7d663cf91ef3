#include <mrpt_mapconv/files/AtomicFile.h>
#include <mrpt_mapconv/files/FileIo.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace fs = std::filesystem;

namespace mrpt_mapconv::files
{
AtomicFile::AtomicFile(const std::string& path)
{
  std::error_code none;
  const fs::path target = fs::is_symlink(path, none) && fs::exists(path, none)
                              ? fs::canonical(path, none)
                              : fs::path(path);
  if (fs::is_directory(target, none) || !target.has_filename())
    throwFileError("write", path, EISDIR);
  if (fs::exists(target, none) && !fs::is_regular_file(target, none))
  {
    m_stagingPath = target.string();
    return;
  }
  m_folder.emplace(target.has_parent_path() ? target.parent_path().string() : ".");
  m_stagingPath = m_folder->path(target.filename().string());
}

void AtomicFile::commit()
{
  if (m_folder)
    m_folder->commit();
  else
    checkWritten(m_stagingPath);
}

}  // namespace mrpt_mapconv::files
