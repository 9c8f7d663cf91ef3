#pragma once

#include <mrpt/system/COutputLogger.h>

#include <set>
#include <string>

namespace mrpt_mapconv::maps
{
/** Where reading observations complains, remembering what it said.
 *
 * One object belongs to one map or one run of a program, so that a log with ten thousand scans of
 * an unknown lidar gives one warning and not ten thousand. The logger must outlive the object.
 */
class PointWarnings
{
 public:
  /** \param log may be null: warnings are dropped */
  explicit PointWarnings(const mrpt::system::COutputLogger* log = nullptr) : m_log(log) {}

  void warn(const std::string& text)
  {
    if (m_log) m_log->logStr(mrpt::system::LVL_WARN, text);
  }
  /** Says something about a subject only once, whatever the numbers in the text. */
  void warnOnceOf(const std::string& subject, const std::string& text)
  {
    if (m_said.insert(subject).second) warn(text + " (said once)");
  }
  /** Says the same text only once. */
  void warnOnce(const std::string& text)
  {
    if (m_said.insert(text).second) warn(text);
  }

 private:
  const mrpt::system::COutputLogger* m_log;
  std::set<std::string> m_said;
};

}  // namespace mrpt_mapconv::maps
