#include "input/ScanFile.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>

#include <algorithm>
#include <stdexcept>

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

/** Looks into a file whose name does not tell what it is. */
FileKind logKindIn(const std::string& path)
{
  const FileKind named = kindOf(path);
  if (named == FileKind::Octree)
    throw std::runtime_error(path +
                             ": holds no scans, but an octree; a .rawlog or .simplemap does");
  if (named != FileKind::Object) return named;
  const auto object = files::ObjectFile(path).next();
  if (!object) throw std::runtime_error(path + ": holds no scans, but no object at all");
  if (const auto kind = logKindOf(*object)) return *kind;
  throw std::runtime_error(path + ": holds no scans, but a " +
                           object->GetRuntimeClass()->className);
}
}  // namespace

std::optional<FileKind> logKindOf(const CSerializable& object)
{
  if (isRawlogEntry(object)) return FileKind::Rawlog;
  if (dynamic_cast<const mrpt::maps::CSimpleMap*>(&object)) return FileKind::SimpleMap;
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

ScanFile readScans(const std::string& path, FileKind kind,
                   const observation::RawlogOptions& options, NoEffect& noEffect)
{
  const ConsoleLog log;
  ScanFile file;
  if (kind == FileKind::Rawlog)
  {
    file.scans = observation::readRawlog(path, options, &log);
    file.description = describe("rawlog", file.scans);
    return file;
  }
  noteRawlogOptions(options, path, noEffect);
  file.scans = observation::readSimpleMap(path, &log);
  file.description = describe("simplemap", file.scans);
  return file;
}

ScanFile read3DScans(const std::string& path, const observation::RawlogOptions& options,
                     Progress& progress)
{
  progress.stage("reading " + path);
  NoEffect noEffect;
  ScanFile file = readScans(path, logKindIn(path), options, noEffect);
  noEffect.warn();
  const bool any =
      std::any_of(file.scans.begin(), file.scans.end(),
                  [](const PosedObservation& s) { return observation::is3DScan(*s.observation); });
  if (!any)
    throw std::runtime_error(path + ": none of its " + std::to_string(file.scans.size()) +
                             " scans is a 3D scan");
  return file;
}

}  // namespace mapconv
