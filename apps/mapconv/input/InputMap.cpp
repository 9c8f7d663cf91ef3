#include "input/InputMap.h"

#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelMapParams.h>
#include <octomap/OcTree.h>

#include <stdexcept>
#include <vector>

#include "input/ScanFile.h"
#include "output/Console.h"
#include "output/Json.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
void warnOfUnusedOptions(const InputRequest& request, double resolution)
{
  if (request.resolution)
    printWarning("--resolution " + jsonNumber(*request.resolution) + " has no effect: " +
                 request.file + " has voxels of " + jsonNumber(resolution) + " m");
  warnOfRawlogOptions(request.log, request.file);
}

std::unique_ptr<octomap::OcTree> buildTree(const std::vector<observation::PosedObservation>& scans,
                                           const InputRequest& request, Progress& progress)
{
  auto tree = std::make_unique<octomap::OcTree>(
      request.resolution.value_or(voxel::VoxelMapParams().resolution));
  const ConsoleLog log;
  observation::SayOnceLog warnings(&log);
  voxel::insertScans(*tree, scans, request.insertion, &warnings,
                     [&](double share) { progress.done(share); });
  if (tree->size() == 0)
    throw std::runtime_error(request.file + ": none of its " + std::to_string(scans.size()) +
                             " scans has a usable point");
  return tree;
}
}  // namespace

InputMap::InputMap(const InputRequest& request, Progress& progress)
{
  progress.stage("reading " + request.file);
  switch (const FileKind kind = kindOf(request.file))
  {
    case FileKind::Octree:
      readTree(request);
      break;
    case FileKind::Rawlog:
    case FileKind::SimpleMap:
      buildFromScans(kind, request, progress);
      break;
    case FileKind::Object:
      readObject(request, progress);
      break;
  }
}

InputMap::~InputMap() = default;

const octomap::AbstractOccupancyOcTree& InputMap::octree() const { return *m_tree; }

void InputMap::useTree(const octomap::AbstractOcTree& tree)
{
  m_source = voxel::makeOctreeSource(tree);  // which refuses all but occupancy trees
  m_tree = dynamic_cast<const octomap::AbstractOccupancyOcTree*>(&tree);
}

void InputMap::readTree(const InputRequest& request)
{
  m_ownTree = voxel::readOctreeFile(request.file);
  if (m_ownTree->size() == 0)
    throw std::runtime_error(request.file + ": the map is empty: not one voxel is known");
  useTree(*m_ownTree);
  m_description = "OctoMap file (" + m_ownTree->getTreeType() + ")";
  warnOfUnusedOptions(request, m_source->resolution());
}

void InputMap::readObject(const InputRequest& request, Progress& progress)
{
  files::ObjectFile file(request.file);
  std::string others;
  while (const auto object = file.next())
  {
    if (const auto kind = logKindOf(*object)) return buildFromScans(*kind, request, progress);
    const std::string name = object->GetRuntimeClass()->className;
    if (const auto* tree = maps::octreeIn(*object))
    {
      if (tree->size() == 0)
        throw std::runtime_error(request.file + ": the octomap in its " + name +
                                 " is empty: not one voxel is known");
      m_object = object;
      useTree(*tree);
      m_description = name + " (" + tree->getTreeType() + ")";
      warnOfUnusedOptions(request, m_source->resolution());
      return;
    }
    others += (others.empty() ? "a " : ", a ") + name;
  }
  throw std::runtime_error(request.file + ": holds no octomap and no scans, but " +
                           (others.empty() ? "no object at all" : others));
}

void InputMap::buildFromScans(FileKind kind, const InputRequest& request, Progress& progress)
{
  const ScanFile file = readScans(request.file, kind, request.log);
  progress.stage("inserting the scans of " + request.file);
  m_ownTree = buildTree(file.scans, request, progress);
  useTree(*m_ownTree);
  m_description = file.description;
}

}  // namespace mapconv
