#pragma once

#include <mrpt/obs/CObservation.h>
#include <mrpt/system/COutputLogger.h>
#include <mrpt_mapconv/observation/SayOnceLog.h>

#include <string>
#include <string_view>

namespace mrpt_mapconv::maps
{
/** What a map says: its logger, what it has said once, and why the last observation changed
 * nothing.
 *
 * Maps are copied per particle: a copy has a logger of its own, without the callbacks and levels of
 * the other's, and what one of them has said once, the others do not repeat. It has skipped nothing
 * yet. A map that is assigned to keeps its logger. */
class MapLog
{
 public:
  explicit MapLog(const std::string& className) : logger(className), warnings(&logger) {}
  MapLog(const MapLog& o) : logger(o.logger.getLoggerName()), warnings(&logger, o.warnings) {}
  MapLog& operator=(const MapLog& o);

  mrpt::system::COutputLogger logger;
  observation::SayOnceLog warnings;  //!< on that logger

  /** Forgets the last skip; every insertion begins with it. */
  void begin()
  {
    m_lastSkip.clear();
    m_lastSkipKind.clear();
  }
  /** Remembers why an observation is not for the map. \return false */
  bool ignore(std::string_view why);
  /** Remembers, and says once for each reason and sensor, why a scan is not inserted.
   * \return false */
  bool skip(const mrpt::obs::CObservation& obs, std::string_view why);
  /** \param kind of reason, without the numbers that differ from one scan to the next */
  bool skip(const mrpt::obs::CObservation& obs, std::string_view kind, std::string_view why);
  /** Why the last observation changed nothing, in one line; empty if it was inserted. */
  const std::string& lastSkip() const { return m_lastSkip; }
  /** The kind of that reason, the same for all scans that are skipped for it; empty for an
   * observation that is not for the map. */
  const std::string& lastSkipKind() const { return m_lastSkipKind; }

 private:
  std::string m_lastSkip, m_lastSkipKind;
};

}  // namespace mrpt_mapconv::maps
