#include "input/InputFile.h"

#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>

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
  const std::string ending = files::endingOf(stream.name());
  return ending == ".bt" || ending == ".ot";
}

}  // namespace mapconv
