#include "input/InputMap.h"

#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/voxel/CloudRays.h>
#include <mrpt_mapconv/voxel/LeafProbabilities.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelMapParams.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "input/InputFile.h"
#include "input/MapOrScans.h"
#include "input/ScanFile.h"
#include "output/Console.h"
#include "output/Json.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
constexpr const char* kThreshold = "occupancyThres";

/** Notes what only goes for maps that are made of scans. */
void noteScanOptions(const InputRequest& request, double resolution, NoEffect& noEffect)
{
  if (request.resolution)
    noEffect.add({"--resolution " + jsonNumber(*request.resolution)},
                 shownName(request.file) + " has voxels of " + jsonNumber(resolution) + " m");
  noteRawlogOptions(request.log, shownName(request.file), noEffect);
  noteOrigin(request.geo, shownName(request.file) + " holds voxels in a frame of their own",
             noEffect);
  auto keys = request.insertionKeys;
  keys.erase(std::remove(keys.begin(), keys.end(), kThreshold), keys.end());
  noEffect.addKeys(keys, request.iniFile, shownName(request.file) + " holds voxels and no scans");
}

double resolutionOf(const InputRequest& request)
{
  return request.resolution.value_or(voxel::VoxelMapParams().resolution);
}

/** Does it; errors name the file. */
template <class Work>
auto naming(const std::string& file, const Work& work)
try
{
  return work();
}
catch (const std::runtime_error& error)
{
  throw std::runtime_error(file + ": " + params::oneLine(error));
}

voxel::VoxelMap buildMap(const std::vector<observation::PosedObservation>& scans,
                         const InputRequest& request, Progress& progress)
{
  voxel::VoxelMap map(resolutionOf(request));
  const ConsoleLog log;
  observation::SayOnceLog warnings(&log);
  naming(shownName(request.file),
         [&]
         {
           voxel::insertScans(
               map, scans, request.insertion, &warnings,
               [&](double share) { progress.done(share); }, request.threads);
         });
  if (map.empty())
    throw std::runtime_error(shownName(request.file) + ": no usable point in " +
                             params::counted(scans.size(), "scan"));
  return map;
}

/** Of 2D scans little can be known, and nothing if they are left out. */
void checkDimensions(const std::vector<observation::PosedObservation>& scans,
                     const std::string& name, const InputRequest& request)
{
  if (observation::has3DScan(scans)) return;
  if (!request.insertion.insert2D)
    throw std::runtime_error(name + ": all of its scans are 2D, and insert2D = false of " +
                             request.iniFile + " leaves them out");
  printWarning(name + ": all of its scans are 2D, so only what lies at their heights is known");
}
}  // namespace

InputMap::InputMap(const InputRequest& request, Progress& progress)
    : m_noEffect(request.noEffect), m_reference(referenceOf({}, request.geo.coordinateSystem))
{
  read(request, progress);
  m_noEffect.warn();
}

void InputMap::read(const InputRequest& request, Progress& progress)
{
  progress.stage("reading " + shownName(request.file));
  files::InputStream stream = openInput(request.file);
  if (!isOctree(stream) && cloud::isCloud(stream)) return buildFromCloud(stream, request, progress);
  noteCloudOptions(request.trajectory, request.columns, request.geo, shownName(request.file),
                   m_noEffect);
  if (isOctree(stream)) return readTree(stream, request);
  files::ObjectFile file(std::move(stream));
  readObject(file, request, progress);
}

InputMap::~InputMap() = default;

void InputMap::writeOctree(const std::string& path) const
{
  if (m_built)
    m_built->writeOctreeFile(path);
  else
    voxel::writeOctreeFile(path, *m_tree);
}

void InputMap::useTree(const octomap::AbstractOcTree& tree)
{
  m_source = voxel::makeOctreeSource(tree);  // which refuses all but occupancy trees
  m_tree = dynamic_cast<const octomap::AbstractOccupancyOcTree*>(&tree);
}

/** Has the threshold that was asked for decide what is occupied. */
void InputMap::applyThreshold(const InputRequest& request)
{
  const auto& keys = request.insertionKeys;
  if (std::find(keys.begin(), keys.end(), kThreshold) == keys.end()) return;
  if (!voxel::holdsProbabilities(*m_tree))
    return m_noEffect.addKeys({kThreshold}, request.iniFile,
                              shownName(request.file) +
                                  " says of each voxel whether it is occupied, but not how "
                                  "probably; an .ot of the same map would");
  auto tree = voxel::toOcTree(*m_tree);
  tree->setOccupancyThres(request.insertion.occupancyThres);
  useTree(*tree);
  m_ownTree = std::move(tree);
}

void InputMap::readTree(files::InputStream& stream, const InputRequest& request)
{
  m_ownTree = voxel::readOctree(stream);
  if (m_ownTree->size() == 0)
    throw std::runtime_error(stream.name() + ": the map is empty: not one voxel is known");
  useTree(*m_ownTree);
  m_description = "OctoMap file (" + m_ownTree->getTreeType() + ")";
  noteScanOptions(request, m_source->resolution(), m_noEffect);
  applyThreshold(request);
}

void InputMap::readObject(files::ObjectFile& file, const InputRequest& request, Progress& progress)
{
  const MapOrScans found = findMapOrScans(file);
  if (found.scans) return buildFromScans(file, *found.scans, request, progress);
  m_object = found.object;
  useTree(*found.tree);
  m_description = found.description;
  noteScanOptions(request, m_source->resolution(), m_noEffect);
  applyThreshold(request);
}

void InputMap::buildFromCloud(files::InputStream& stream, const InputRequest& request,
                              Progress& progress)
{
  const SeenCloud input =
      readSeenCloud(stream, request.geo, request.columns, request.trajectory, m_noEffect);
  progress.stage("inserting the points of " + stream.name());
  voxel::VoxelGrid grid(resolutionOf(request));
  auto times = request.trajectory.times;
  times.maxGap = request.log.maxPoseGap;
  const auto inserted =
      naming(stream.name(),
             [&]
             {
               return voxel::insertCloud(grid, input.cloud, input.sensor, times,
                                         voxel::rayParamsOf(request.insertion), request.threads);
             });
  checkCovered(input, stream.name(), request.trajectory, inserted.points, inserted.uncovered);
  m_built.emplace(grid.resolution());
  m_built->setGrid(std::move(grid), request.insertion);
  m_source = m_built->source();
  m_reference = input.reference;
  m_description = describeCloud(input.cloud, inserted.points);
}

void InputMap::buildFromScans(files::ObjectFile& log, LogKind kind, const InputRequest& request,
                              Progress& progress)
{
  ScanFile file = readScans(log, kind, request.log, m_noEffect);
  m_reference = moveToOrigin(file.scans, log.path(), request.geo, resolutionOf(request));
  checkDimensions(file.scans, log.path(), request);
  if (request.insertion.voxelEngine == voxel::VoxelEngine::Octomap && request.insertion.maxMemory)
    m_noEffect.addKeys({"maxMemory"}, request.iniFile, "voxelEngine is octomap");
  progress.stage("inserting the scans of " + log.path());
  m_built = buildMap(file.scans, request, progress);
  m_source = m_built->source();
  m_description = file.description;
}

}  // namespace mapconv
