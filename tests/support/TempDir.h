#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/mount.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::testing
{
/** A folder that is there during a test. */
class TempDir
{
 public:
  TempDir()
  {
    std::string name = (std::filesystem::temp_directory_path() / "mapconv-test-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    m_path = name;
  }
  ~TempDir()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  TempDir(const TempDir&) = delete;
  TempDir& operator=(const TempDir&) = delete;

  std::string path(const std::string& name = {}) const
  {
    return name.empty() ? m_path.string() : (m_path / name).string();
  }
  std::size_t entries() const
  {
    const std::filesystem::directory_iterator begin(m_path), end;
    return static_cast<std::size_t>(std::distance(begin, end));
  }

 private:
  std::filesystem::path m_path;
};

/** A disk of a few pages, if we are allowed to mount one. */
class TinyDisk
{
 public:
  explicit TinyDisk(int kilobytes)
  {
    const std::string options = "size=" + std::to_string(kilobytes) + "k";
    m_mounted = ::mount("tmpfs", m_dir.path().c_str(), "tmpfs", 0, options.c_str()) == 0;
  }
  ~TinyDisk()
  {
    if (m_mounted) ::umount2(m_dir.path().c_str(), MNT_DETACH);
  }
  TinyDisk(const TinyDisk&) = delete;
  TinyDisk& operator=(const TinyDisk&) = delete;

  bool mounted() const { return m_mounted; }
  std::string path(const std::string& name) const { return m_dir.path(name); }

 private:
  TempDir m_dir;
  bool m_mounted = false;
};

inline std::string readBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/** The message of the std::exception that `action` throws; fails the test if it throws none. */
template <class Exception = std::runtime_error, class Action>
std::string messageOf(Action action)
{
  try
  {
    action();
  }
  catch (const Exception& e)
  {
    return e.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}  // namespace mrpt_mapconv::testing
