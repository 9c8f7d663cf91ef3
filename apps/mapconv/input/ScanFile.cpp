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

void warnOfRawlogOptions(const observation::RawlogOptions& options, const std::string& path)
{
  if (options.staticSensor) printWarning("--static has no effect: " + path + " is no rawlog");
  if (!options.poseSource.empty())
    printWarning("--pose-source has no effect: " + path + " is no rawlog");
}

namespace
{
bool has3DScan(const std::vector<PosedObservation>& scans)
{
  return std::any_of(scans.begin(), scans.end(),
                     [](const PosedObservation& s)
                     { return observation::is3DScan(*s.observation); });
}

ScanFile readLog(const std::string& path, FileKind kind, const observation::RawlogOptions& options)
{
  const ConsoleLog log;
  ScanFile file;
  if (kind == FileKind::Rawlog)
  {
    file.scans = observation::readRawlog(path, options, &log);
    file.description = describe("rawlog", file.scans);
    return file;
  }
  warnOfRawlogOptions(options, path);
  file.scans = observation::readSimpleMap(path, &log);
  file.description = describe("simplemap", file.scans);
  return file;
}

}  // namespace

ScanFile readScans(const std::string& path, FileKind kind,
                   const observation::RawlogOptions& options)
{
  ScanFile file = readLog(path, kind, options);
  if (!has3DScan(file.scans))
    printWarning(path + ": all of its scans are 2D, so only what lies at their heights is known");
  return file;
}

ScanFile read3DScans(const std::string& path, const observation::RawlogOptions& options,
                     Progress& progress)
{
  progress.stage("reading " + path);
  ScanFile file = readLog(path, logKindIn(path), options);
  if (!has3DScan(file.scans))
    throw std::runtime_error(path + ": none of its " + std::to_string(file.scans.size()) +
                             " scans is a 3D scan; mapconv convert takes 2D scans, too");
  return file;
}

}  // namespace mapconv
