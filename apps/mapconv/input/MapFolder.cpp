#include "input/MapFolder.h"

#include <mrpt_mapconv/files/ForeignKind.h>
#include <mrpt_mapconv/files/InputStream.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/AbstractOcTree.h>

#include <filesystem>
#include <stdexcept>

#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using namespace std::string_literals;

namespace
{
/** Somebody may have named the map itself. */
[[noreturn]] void refuseFile(const std::string& path)
{
  files::InputStream stream(path);
  files::refuseForeignKinds(stream);
  throw std::runtime_error(path +
                           ": is a file; what is wanted is the folder that mapconv convert "
                           "makes of a map");
}

/** The voxel map, gzipped or not; empty if there is none. */
std::string voxelsIn(const std::string& dir)
{
  for (const std::string& name : {std::string(MapFolder::kVoxels), MapFolder::kVoxels + ".gz"s})
    if (const auto path = std::filesystem::path(dir) / name; std::filesystem::exists(path))
      return path.string();
  return "";
}

std::string layersIn(const std::string& dir)
{
  const auto path = std::filesystem::path(dir) / MapFolder::kLayers;
  if (!std::filesystem::exists(dir)) throw std::runtime_error(dir + ": there is no such folder");
  if (std::filesystem::is_regular_file(dir)) refuseFile(dir);
  if (!std::filesystem::exists(path))
    throw std::runtime_error(dir + ": it holds no " + MapFolder::kLayers +
                             ", so it is no output folder of mapconv convert");
  return path.string();
}
}  // namespace

MapFolder::MapFolder(const std::string& dir) : m_file(freespace::readLayersTiff(layersIn(dir)))
{
  const std::string path = voxelsIn(dir);
  if (path.empty())
  {
    printWarning(dir + " holds no " + kVoxels + ": slabs between two free ranges are not seen");
    return;
  }
  m_tree = voxel::readOctreeFile(path);
  m_source = voxel::makeOctreeSource(*m_tree);
}

MapFolder::~MapFolder() = default;

}  // namespace mapconv
