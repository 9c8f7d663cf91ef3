#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/maps/InsertionTimes.h>

#include <utility>

namespace mrpt_mapconv::maps
{
InsertionTimes::InsertionTimes(std::string name) : m_name(std::move(name)) {}

InsertionTimes::InsertionTimes(const InsertionTimes& o) : m_name(o.m_name) {}

InsertionTimes::~InsertionTimes() { forget(); }

InsertionTimes& InsertionTimes::operator=(const InsertionTimes& o)
{
  if (this != &o) forget();
  return *this;
}

mrpt::system::CTimeLogger& InsertionTimes::logger() const
{
  constexpr bool enabled = true, wholeHistory = true;
  const std::lock_guard<std::mutex> lock(m_mutex);
  if (!m_logger)
    m_logger = std::make_unique<mrpt::system::CTimeLogger>(enabled, m_name, wholeHistory);
  return *m_logger;
}

void InsertionTimes::forget()
{
  if (m_logger) m_logger->clear(true);  // or MRPT prints it
  m_logger.reset();
}

void InsertionTimes::saveTo(const std::string& path) const { m_logger->saveToCSVFile(path); }

}  // namespace mrpt_mapconv::maps
