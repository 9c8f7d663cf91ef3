#include "input/PointInput.h"

#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanCloud.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelCloud.h>
#include <octomap/AbstractOcTree.h>

#include <stdexcept>
#include <utility>

#include "input/CloudInput.h"
#include "input/EachScan.h"
#include "input/InputFile.h"
#include "input/MapOrScans.h"
#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
PointInput ofCloud(files::InputStream& stream, const PointRequest& request, NoEffect& noEffect)
{
  const std::string name = shownName(request.file);
  noteRawlogOptions(request.log, name, noEffect);
  CloudInput read = readCloudInput(stream, request.geo, request.columns, noEffect);
  const std::string description = describeCloud(read.cloud, read.cloud.size());
  return {std::move(read.cloud), std::move(read.reference), description};
}

PointInput ofTree(const octomap::AbstractOcTree& tree, const std::string& kind,
                  const PointRequest& request, NoEffect& noEffect)
{
  const std::string name = shownName(request.file);
  noteRawlogOptions(request.log, name, noEffect);
  noteOrigin(request.geo, name + " holds voxels in a frame of their own", noEffect);
  PointInput input;
  input.cloud = voxel::occupiedCentres(*voxel::makeOctreeSource(tree));
  if (input.cloud.empty()) throw std::runtime_error(name + ": not one of its voxels is occupied");
  input.reference = referenceOf({0, 0, 0}, request.geo.coordinateSystem);
  input.description = kind + ", " + params::counted(input.cloud.size(), "occupied voxel");
  return input;
}

PointInput ofScans(files::ObjectFile& file, LogKind kind, const PointRequest& request,
                   NoEffect& noEffect, Progress& progress)
{
  ScanFile log = readScans(file, kind, request.log, noEffect);
  PointInput input;
  input.reference = moveToOrigin(log.scans, shownName(request.file), request.geo, 0);
  input.cloud.origin = input.reference.origin;
  ConsoleLog console;
  observation::SayOnceLog warnings(&console);
  const std::string name = shownName(request.file);
  progress.stage("collecting the points of " + name);
  std::size_t scans2D = 0;
  forEachScan(log.scans, name, progress,
              [&](const observation::PosedObservation& scan)
              {
                if (observation::is3DScan(*scan.observation))
                  observation::appendScan(scan, input.cloud, &warnings);
                else
                  ++scans2D;
              });
  if (input.cloud.empty())
    throw std::runtime_error(name + ": none of its scans has a 3D point" +
                             (scans2D > 0 ? ", " + std::to_string(scans2D) + " are 2D" : ""));
  if (scans2D > 0)
    printWarning(params::counted(scans2D, "2D scan") + (scans2D == 1 ? " is" : " are") +
                 " left out: they see no ground");
  input.description = log.description + " with " + params::counted(input.cloud.size(), "point");
  return input;
}
}  // namespace

PointInput readPoints(const PointRequest& request, NoEffect& noEffect, Progress& progress)
{
  progress.stage("reading " + shownName(request.file));
  files::InputStream stream = openInput(request.file);
  if (cloud::isCloud(stream)) return ofCloud(stream, request, noEffect);
  noteCloudOptions({}, request.columns, request.geo, shownName(request.file), noEffect);
  if (isOctree(stream))
  {
    const auto tree = voxel::readOctree(stream);
    return ofTree(*tree, "OctoMap file (" + tree->getTreeType() + ")", request, noEffect);
  }
  files::ObjectFile file(std::move(stream));
  const MapOrScans found = findMapOrScans(file);
  if (found.scans) return ofScans(file, *found.scans, request, noEffect, progress);
  return ofTree(*found.tree, found.description, request, noEffect);
}

}  // namespace mapconv
