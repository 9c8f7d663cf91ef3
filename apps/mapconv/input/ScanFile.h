#pragma once

#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <optional>
#include <string>
#include <vector>

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

/** Warns of options that only rawlogs know, for a file that is none. */
void warnOfRawlogOptions(const mrpt_mapconv::observation::RawlogOptions& options,
                         const std::string& path);

/** Reads one or the other, warning of what is left out and of options where they have no effect.
 * \param log at its first entry
 * \exception std::runtime_error in one line naming the file and what is wrong with it */
ScanFile readScans(mrpt_mapconv::files::ObjectFile& log, LogKind kind,
                   const mrpt_mapconv::observation::RawlogOptions& options);

/** The same for a file that has to hold 3D scans. \param path "-": what is piped in
 * \exception std::runtime_error likewise, also if it holds something else or
 * only 2D scans */
ScanFile read3DScans(const std::string& path,
                     const mrpt_mapconv::observation::RawlogOptions& options, Progress& progress);

}  // namespace mapconv
