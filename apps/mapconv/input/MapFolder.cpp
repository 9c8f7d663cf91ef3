#include "input/MapFolder.h"

#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/AbstractOcTree.h>

#include <filesystem>
#include <stdexcept>

#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
std::string layersIn(const std::string& dir)
{
  const auto path = std::filesystem::path(dir) / MapFolder::kLayers;
  if (!std::filesystem::exists(dir)) throw std::runtime_error(dir + ": there is no such folder");
  if (!std::filesystem::exists(path))
    throw std::runtime_error(dir + ": it holds no " + MapFolder::kLayers +
                             ", so it is no output folder of mapconv convert");
  return path.string();
}
}  // namespace

MapFolder::MapFolder(const std::string& dir) : m_file(freespace::readLayersTiff(layersIn(dir)))
{
  const std::string path = (std::filesystem::path(dir) / kVoxels).string();
  if (!std::filesystem::exists(path))
  {
    printWarning(dir + " holds no " + kVoxels + ": slabs between two free ranges are not seen");
    return;
  }
  m_tree = voxel::readOctreeFile(path);
  m_source = voxel::makeOctreeSource(*m_tree);
}

MapFolder::~MapFolder() = default;

}  // namespace mapconv
