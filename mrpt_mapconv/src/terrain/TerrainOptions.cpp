#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/terrain/TerrainOptions.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::terrain
{
using params::require;

void TerrainGridParams::check() const
{
  grid::requireResolution(resolution);
  require(maxGridCells >= 1, "maxGridCells", maxGridCells, ">= 1");
}

void TerrainGridParams::checkSize(const grid::GridFrame& frame) const
{
  const double cells = static_cast<double>(frame.width) * frame.height;
  if (cells <= maxGridCells) return;
  std::ostringstream message;
  message << "maxGridCells = " << maxGridCells << ": the layers would have " << frame.width << " x "
          << frame.height << " = " << cells << " cells; is the scan's pose right?";
  throw std::runtime_error(message.str());
}

void PointLimits::check() const
{
  require(maxRange > 0 && std::isfinite(maxRange), "maxRange", maxRange, "a range > 0 m");
  require(std::isfinite(minHeight), "minHeight", minHeight, "a finite height");
  require(maxHeight > minHeight && std::isfinite(maxHeight), "maxHeight", maxHeight,
          "above minHeight");
}

}  // namespace mrpt_mapconv::terrain
