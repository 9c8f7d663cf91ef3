#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <stdexcept>
#include <system_error>

namespace fs = std::filesystem;

namespace mrpt_mapconv::files
{
namespace
{
std::string createStaging(const std::string& dir)
{
  std::string name = (fs::path(dir) / ".mapconv-XXXXXX").string();
  if (!::mkdtemp(name.data())) throwFileError("write into", dir, errno);
  return name;
}
}  // namespace

OutputDir::OutputDir(const std::string& dir) : m_dir(dir)
{
  try
  {
    createDir();
    m_staging = createStaging(m_dir);
  }
  catch (...)
  {
    removeCreated();
    throw;
  }
}

OutputDir::~OutputDir() { discard(); }

void OutputDir::discard() noexcept
{
  if (m_staging.empty()) return;
  // Another thread may be writing a file there just now, so that the folder is not empty yet.
  std::error_code error;
  for (int tries = 0; tries < 100; ++tries)
  {
    fs::remove_all(m_staging, error);
    if (!error && !fs::exists(m_staging, error)) break;
  }
  removeCreated();
}

void OutputDir::createDir()
{
  fs::path path;
  for (const fs::path& part : fs::path(m_dir))
  {
    path /= part;
    if (::mkdir(path.c_str(), 0777) == 0)
    {
      m_created.push_back(path.string());
      continue;
    }
    const int reason = errno;  // looking at the folder sets another
    if (std::error_code ignored; !fs::is_directory(path, ignored))
      throwFileError("create the folder", m_dir, reason == EEXIST ? ENOTDIR : reason);
  }
  if (m_dir.empty()) throwFileError("create the folder", m_dir, ENOENT);
}

void OutputDir::removeCreated()
{
  // rmdir leaves folders alone that somebody has put something into.
  for (auto dir = m_created.rbegin(); dir != m_created.rend(); ++dir) ::rmdir(dir->c_str());
  m_created.clear();
}

std::string OutputDir::path(const std::string& name)
{
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
    throw std::invalid_argument("OutputDir: '" + name + "' is not a plain file name");
  m_expected.insert(name);
  return (fs::path(m_staging) / name).string();
}

std::vector<std::string> OutputDir::stagedNames() const
{
  std::set<std::string> names = m_expected;
  for (const auto& entry : fs::directory_iterator(m_staging))
    names.insert(entry.path().filename().string());
  return {names.begin(), names.end()};
}

void OutputDir::checkStaged(const std::vector<std::string>& names) const
{
  for (const std::string& name : names)
  {
    const fs::path staged = fs::path(m_staging) / name;
    const fs::path target = fs::path(m_dir) / name;
    if (!fs::is_regular_file(fs::symlink_status(staged)))
      throw std::runtime_error("cannot write '" + target.string() + "': it was never written");
    checkWritten(staged.string());
    if (fs::exists(target) && !fs::is_regular_file(target))
      throw std::runtime_error("cannot replace '" + target.string() +
                               "': it is not a regular file");
  }
}

void OutputDir::commit()
{
  const std::vector<std::string> names = stagedNames();
  checkStaged(names);
  for (const std::string& name : names)
  {
    const std::string target = (fs::path(m_dir) / name).string();
    if (std::rename((fs::path(m_staging) / name).c_str(), target.c_str()) != 0)
      throwFileError("write", target, errno);
  }
  m_created.clear();
  std::error_code ignored;
  fs::remove_all(m_staging, ignored);
  m_staging.clear();
}

std::string withoutStaging(const std::string& message)
{
  static const std::regex staging("/\\.mapconv-[A-Za-z0-9]{6}(?=/)");
  return std::regex_replace(message, staging, "");
}

}  // namespace mrpt_mapconv::files
