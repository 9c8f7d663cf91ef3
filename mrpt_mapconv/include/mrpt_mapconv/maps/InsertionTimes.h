#pragma once

#include <memory>
#include <mutex>
#include <string>

namespace mrpt::system
{
class CTimeLogger;
}

namespace mrpt_mapconv::maps
{
/** The times of a map's insertions, with the whole history. The logger is made when it is needed:
 * it has 0.6 MB, and most copies of a map never insert anything. A copy begins without times, and
 * what is assigned to forgets its own. */
class InsertionTimes
{
 public:
  explicit InsertionTimes(std::string name);
  ~InsertionTimes();
  InsertionTimes(const InsertionTimes& o);
  InsertionTimes& operator=(const InsertionTimes& o);

  /** May be called by several threads. */
  mrpt::system::CTimeLogger& logger() const;
  void forget();
  /** Writes the times as a CSV file, if there is a logger. \return whether there is
   * \param makePath called only then */
  template <class MakePath>
  bool save(const MakePath& makePath) const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_logger) saveTo(makePath());
    return m_logger != nullptr;
  }

 private:
  void saveTo(const std::string& path) const;

  std::string m_name;
  mutable std::mutex m_mutex;
  mutable std::unique_ptr<mrpt::system::CTimeLogger> m_logger;
};

}  // namespace mrpt_mapconv::maps
