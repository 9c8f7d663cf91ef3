#include "input/EachScan.h"

#include <mrpt_mapconv/params/Require.h>

#include <stdexcept>

namespace mapconv
{
using mrpt_mapconv::observation::PosedObservation;

void forEachScan(const std::vector<PosedObservation>& scans, const std::string& file,
                 Progress& progress, const std::function<void(const PosedObservation&)>& insert)
{
  std::size_t count = 0;
  for (const auto& scan : scans)
  {
    progress.done(static_cast<double>(count++) / static_cast<double>(scans.size()));
    try
    {
      insert(scan);
    }
    catch (const std::invalid_argument&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      throw std::runtime_error(file + ": scan " + std::to_string(count) + " of " +
                               std::to_string(scans.size()) + ": " +
                               mrpt_mapconv::params::oneLine(error));
    }
  }
}

}  // namespace mapconv
