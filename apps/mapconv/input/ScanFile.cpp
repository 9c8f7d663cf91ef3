#include "input/ScanFile.h"

#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>

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
  return kind + " (" + params::counted(scans.size(), "scan") + ")";
}

files::ObjectFile openLog(files::InputStream stream)
{
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

namespace
{
/** Those of the options that say which poses are used, and that are not the default. */
std::vector<std::string> poseOptions(const observation::RawlogOptions& options)
{
  std::vector<std::string> given;
  if (options.poseSource) given.emplace_back("--pose-source");
  if (options.maxPoseGap != observation::RawlogOptions().maxPoseGap)
    given.emplace_back("--max-pose-gap");
  return given;
}
}  // namespace

void noteRawlogOptions(const observation::RawlogOptions& options, const std::string& path,
                       NoEffect& noEffect)
{
  auto given = poseOptions(options);
  if (options.staticSensor) given.insert(given.begin(), "--static");
  noEffect.add(given, path + " is no rawlog");
}

ScanFile readScans(files::ObjectFile& log, LogKind kind, const observation::RawlogOptions& options,
                   NoEffect& noEffect)
{
  const ConsoleLog console;
  ScanFile file;
  if (kind == LogKind::Rawlog)
  {
    if (options.staticSensor) noEffect.add(poseOptions(options), "--static needs no poses");
    file.scans = observation::readRawlog(log, options, &console);
    file.description = describe("rawlog", file.scans);
    return file;
  }
  noteRawlogOptions(options, log.path(), noEffect);
  file.scans = observation::readSimpleMap(log, &console);
  file.description = describe("simplemap", file.scans);
  return file;
}

ScanFile read3DScans(const std::string& path, const observation::RawlogOptions& options,
                     NoEffect& noEffect, Progress& progress)
{
  progress.stage("reading " + shownName(path));
  return read3DScans(openInput(path), options, noEffect);
}

ScanFile read3DScans(files::InputStream stream, const observation::RawlogOptions& options,
                     NoEffect& noEffect)
{
  files::ObjectFile log = openLog(std::move(stream));
  ScanFile file = readScans(log, logKindIn(log), options, noEffect);
  if (!observation::has3DScan(file.scans))
    throw std::runtime_error(log.path() + ": holds " + params::counted(file.scans.size(), "scan") +
                             ", but no 3D scan; mapconv convert takes 2D scans, too");
  return file;
}

}  // namespace mapconv
