#include "input/InputFile.h"

#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>

#include <filesystem>

namespace mapconv
{
using namespace mrpt_mapconv;
using files::InputStream;

InputStream openInput(const std::string& path)
{
  return path == "-" ? InputStream::standardInput() : InputStream(path);
}

std::string shownName(const std::string& path) { return path == "-" ? "stdin" : path; }

bool isOctree(InputStream& stream)
{
  if (voxel::beginsAsOctree(stream.preview())) return true;
  const std::filesystem::path path(stream.name());
  const std::string ending = params::lowerCase(path.extension().string());
  const std::string kind =
      ending == ".gz" ? params::lowerCase(path.stem().extension().string()) : ending;
  return kind == ".bt" || kind == ".ot";
}

}  // namespace mapconv
