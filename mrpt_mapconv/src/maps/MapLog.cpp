#include <mrpt_mapconv/maps/MapLog.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>

namespace mrpt_mapconv::maps
{
MapLog& MapLog::operator=(const MapLog& o)
{
  if (this == &o) return *this;
  warnings.rememberWith(o.warnings);
  begin();
  return *this;
}

bool MapLog::ignore(std::string_view why)
{
  m_lastSkip = why;
  return false;
}

bool MapLog::skip(const mrpt::obs::CObservation& obs, std::string_view why)
{
  return skip(obs, why, why);
}

bool MapLog::skip(const mrpt::obs::CObservation& obs, std::string_view kind, std::string_view why)
{
  m_lastSkip = why;
  m_lastSkipKind = kind;
  warnings.warnOnceOf(
      {kind, obs.GetRuntimeClass()->className, obs.sensorLabel},
      [&] { return "a scan of " + observation::nameOf(obs) + " is skipped: " + m_lastSkip; });
  return false;
}

}  // namespace mrpt_mapconv::maps
