#pragma once

#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <optional>
#include <string>
#include <vector>

#include "input/NoEffect.h"
#include "output/Progress.h"

namespace mapconv
{
/** What scans are kept in. */
enum class LogKind
{
  SimpleMap,
  Rawlog
};

/** The scans of a rawlog or simplemap. */
struct ScanFile
{
  std::vector<mrpt_mapconv::observation::PosedObservation> scans;
  std::string description;  //!< what they were read from, e.g. "rawlog (3 scans)"
};

/** Which of both an object is the (first) part of; nothing if it is no part of either. */
std::optional<LogKind> logKindOf(const mrpt::serialization::CSerializable& object);

/** Notes the options that only rawlogs know, for a file that is none. */
void noteRawlogOptions(const mrpt_mapconv::observation::RawlogOptions& options,
                       const std::string& path, NoEffect& noEffect);

/** Reads one or the other, warning of what is left out.
 * \param log at its first entry
 * \param noEffect gets the options that have none
 * \exception std::runtime_error in one line naming the file and what is wrong with it */
ScanFile readScans(mrpt_mapconv::files::ObjectFile& log, LogKind kind,
                   const mrpt_mapconv::observation::RawlogOptions& options, NoEffect& noEffect);

/** The same of a file that has to hold 3D scans.
 * \exception std::runtime_error likewise, also if it holds something else or only 2D scans */
ScanFile read3DScans(mrpt_mapconv::files::InputStream stream,
                     const mrpt_mapconv::observation::RawlogOptions& options, NoEffect& noEffect);
/** \param path "-": what is piped in */
ScanFile read3DScans(const std::string& path,
                     const mrpt_mapconv::observation::RawlogOptions& options, NoEffect& noEffect,
                     Progress& progress);

}  // namespace mapconv
