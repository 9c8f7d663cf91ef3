#include "input/ScanFile.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "input/InputFile.h"
#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using mrpt::serialization::CSerializable;
using observation::PosedObservation;

namespace
{
bool isRawlogEntry(const CSerializable& object)
{
  return dynamic_cast<const mrpt::obs::CObservation*>(&object) ||
         dynamic_cast<const mrpt::obs::CSensoryFrame*>(&object) ||
         dynamic_cast<const mrpt::obs::CActionCollection*>(&object) ||
         dynamic_cast<const mrpt::obs::CRawlog*>(&object);
}

std::string describe(const std::string& kind, const std::vector<PosedObservation>& scans)
{
  return kind + " (" + std::to_string(scans.size()) + (scans.size() == 1 ? " scan)" : " scans)");
}

files::ObjectFile openLog(const std::string& path)
{
  files::InputStream stream = openInput(path);
  if (voxel::beginsAsOctree(stream.preview()))
    throw std::runtime_error(stream.name() +
                             ": holds no scans, but an octree; a .rawlog or .simplemap does");
  return files::ObjectFile(std::move(stream));
}

LogKind logKindIn(files::ObjectFile& file)
{
  const auto object = file.peek();
  if (!object) throw std::runtime_error(file.path() + ": holds no scans, but no object at all");
  if (const auto kind = logKindOf(*object)) return *kind;
  throw std::runtime_error(file.path() + ": holds no scans, but a " +
                           object->GetRuntimeClass()->className);
}
}  // namespace

std::optional<LogKind> logKindOf(const CSerializable& object)
{
  if (isRawlogEntry(object)) return LogKind::Rawlog;
  if (dynamic_cast<const mrpt::maps::CSimpleMap*>(&object)) return LogKind::SimpleMap;
  return std::nullopt;
}

void noteRawlogOptions(const observation::RawlogOptions& options, const std::string& path,
                       NoEffect& noEffect)
{
  std::vector<std::string> given;
  if (options.staticSensor) given.emplace_back("--static");
  if (!options.poseSource.empty()) given.emplace_back("--pose-source");
  noEffect.add(given, path + " is no rawlog");
}

namespace
{
bool has3DScan(const std::vector<PosedObservation>& scans)
{
  return std::any_of(scans.begin(), scans.end(),
                     [](const PosedObservation& s)
                     { return observation::is3DScan(*s.observation); });
}

ScanFile readLog(files::ObjectFile& log, LogKind kind, const observation::RawlogOptions& options,
                 NoEffect& noEffect)
{
  const ConsoleLog console;
  ScanFile file;
  if (kind == LogKind::Rawlog)
  {
    file.scans = observation::readRawlog(log, options, &console);
    file.description = describe("rawlog", file.scans);
    return file;
  }
  noteRawlogOptions(options, log.path(), noEffect);
  file.scans = observation::readSimpleMap(log, &console);
  file.description = describe("simplemap", file.scans);
  return file;
}

}  // namespace

ScanFile readScans(files::ObjectFile& log, LogKind kind, const observation::RawlogOptions& options,
                   NoEffect& noEffect)
{
  ScanFile file = readLog(log, kind, options, noEffect);
  if (!has3DScan(file.scans))
    printWarning(log.path() +
                 ": all of its scans are 2D, so only what lies at their heights is known");
  return file;
}

ScanFile read3DScans(const std::string& path, const observation::RawlogOptions& options,
                     Progress& progress)
{
  progress.stage("reading " + shownName(path));
  files::ObjectFile log = openLog(path);
  NoEffect noEffect;
  ScanFile file = readLog(log, logKindIn(log), options, noEffect);
  noEffect.warn();
  if (!has3DScan(file.scans))
    throw std::runtime_error(log.path() + ": none of its " + std::to_string(file.scans.size()) +
                             " scans is a 3D scan; mapconv convert takes 2D scans, too");
  return file;
}

}  // namespace mapconv
