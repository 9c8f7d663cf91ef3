#include "input/EachScan.h"

#include <mrpt_mapconv/params/Require.h>

#include <stdexcept>

namespace mapconv
{
using mrpt_mapconv::observation::PosedObservation;

void forEachScan(const std::vector<PosedObservation>& scans, const std::string& file,
                 Progress& progress, const std::function<void(const PosedObservation&)>& insert)
{
  forEachScan(scans.size(), file, progress, [&](std::size_t index) { insert(scans[index]); });
}

void forEachScan(std::size_t scans, const std::string& file, Progress& progress,
                 const std::function<void(std::size_t)>& insert)
{
  for (std::size_t i = 0; i < scans; ++i)
  {
    progress.done(static_cast<double>(i) / static_cast<double>(scans));
    try
    {
      insert(i);
    }
    catch (const std::invalid_argument&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      throw std::runtime_error(file + ": scan " + std::to_string(i + 1) + " of " +
                               std::to_string(scans) + ": " + mrpt_mapconv::params::oneLine(error));
    }
  }
}

}  // namespace mapconv
