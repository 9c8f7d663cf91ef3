#include "input/InputMap.h"

#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/maps/OctoMapAccess.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelMapParams.h>
#include <octomap/OcTree.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "input/InputFile.h"
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
                 shownName(request.file) + " has voxels of " + jsonNumber(resolution) + " m");
  warnOfRawlogOptions(request.log, shownName(request.file));
}

std::unique_ptr<octomap::OcTree> buildTree(const std::vector<observation::PosedObservation>& scans,
                                           const InputRequest& request, Progress& progress)
{
  auto tree = std::make_unique<octomap::OcTree>(
      request.resolution.value_or(voxel::VoxelMapParams().resolution));
  const ConsoleLog log;
  observation::SayOnceLog warnings(&log);
  try
  {
    voxel::insertScans(*tree, scans, request.insertion, &warnings,
                       [&](double share) { progress.done(share); });
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(shownName(request.file) + ": " + params::oneLine(error));
  }
  if (tree->size() == 0)
    throw std::runtime_error(shownName(request.file) + ": none of its " +
                             std::to_string(scans.size()) + " scans has a usable point");
  return tree;
}
}  // namespace

InputMap::InputMap(const InputRequest& request, Progress& progress)
{
  progress.stage("reading " + shownName(request.file));
  files::InputStream stream = openInput(request.file);
  if (isOctree(stream))
  {
    readTree(stream, request);
    return;
  }
  files::ObjectFile file(std::move(stream));
  readObject(file, request, progress);
}

InputMap::~InputMap() = default;

const octomap::AbstractOccupancyOcTree& InputMap::octree() const { return *m_tree; }

void InputMap::useTree(const octomap::AbstractOcTree& tree)
{
  m_source = voxel::makeOctreeSource(tree);  // which refuses all but occupancy trees
  m_tree = dynamic_cast<const octomap::AbstractOccupancyOcTree*>(&tree);
}

void InputMap::readTree(files::InputStream& stream, const InputRequest& request)
{
  m_ownTree = voxel::readOctree(stream);
  if (m_ownTree->size() == 0)
    throw std::runtime_error(stream.name() + ": the map is empty: not one voxel is known");
  useTree(*m_ownTree);
  m_description = "OctoMap file (" + m_ownTree->getTreeType() + ")";
  warnOfUnusedOptions(request, m_source->resolution());
}

void InputMap::readObject(files::ObjectFile& file, const InputRequest& request, Progress& progress)
{
  std::string others;
  for (auto object = file.peek(); object; file.next(), object = file.peek())
  {
    if (const auto kind = logKindOf(*object)) return buildFromScans(file, *kind, request, progress);
    const std::string name = object->GetRuntimeClass()->className;
    if (const auto* tree = maps::octreeIn(*object))
    {
      if (tree->size() == 0)
        throw std::runtime_error(file.path() + ": the octomap in its " + name +
                                 " is empty: not one voxel is known");
      m_object = object;
      useTree(*tree);
      m_description = name + " (" + tree->getTreeType() + ")";
      warnOfUnusedOptions(request, m_source->resolution());
      return;
    }
    others += (others.empty() ? "a " : ", a ") + name;
  }
  throw std::runtime_error(file.path() + ": holds no octomap and no scans, but " +
                           (others.empty() ? "no object at all" : others));
}

void InputMap::buildFromScans(files::ObjectFile& log, LogKind kind, const InputRequest& request,
                              Progress& progress)
{
  const ScanFile file = readScans(log, kind, request.log);
  progress.stage("inserting the scans of " + log.path());
  m_ownTree = buildTree(file.scans, request, progress);
  useTree(*m_ownTree);
  m_description = file.description;
}

}  // namespace mapconv
