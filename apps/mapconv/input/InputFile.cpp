#include "input/InputFile.h"

#include <mrpt_mapconv/params/Text.h>

#include <filesystem>
#include <fstream>

namespace mapconv
{
namespace
{
using mrpt_mapconv::params::lowerCase;

std::string extensionOf(const std::filesystem::path& path)
{
  const std::string extension = lowerCase(path.extension().string());
  return extension == ".gz" ? lowerCase(path.stem().extension().string()) : extension;
}

/** Both of OctoMap's formats begin with a line like "# Octomap OcTree binary file". */
bool beginsAsOctree(const std::string& path)
{
  // Looking into a pipe would take its first bytes away.
  if (std::error_code ignored; !std::filesystem::is_regular_file(path, ignored)) return false;
  const std::string begin = "# Octomap OcTree";
  std::string first(begin.size(), '\0');
  std::ifstream(path, std::ios::binary)
      .read(first.data(), static_cast<std::streamsize>(begin.size()));
  return first == begin;
}
}  // namespace

FileKind kindOf(const std::string& path)
{
  if (beginsAsOctree(path)) return FileKind::Octree;
  const std::string extension = extensionOf(path);
  if (extension == ".bt" || extension == ".ot") return FileKind::Octree;
  if (extension == ".simplemap") return FileKind::SimpleMap;
  if (extension == ".rawlog") return FileKind::Rawlog;
  return FileKind::Object;
}

}  // namespace mapconv
