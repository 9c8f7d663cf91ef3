#pragma once

#include <mrpt_mapconv/eval/TerrainErrors.h>

#include <cstddef>
#include <vector>

#include "experiment/terrain/TerrainMappings.h"

namespace mapconv
{
/** A plane of real scans, and how the heights of its cells lie around the planes fitted to them. */
struct RealPlane
{
  mrpt_mapconv::terrain::TerrainPlane plane;  //!< of our map with fused heights
  PerTerrainHeights<mrpt_mapconv::eval::ErrorSummary> residuals;
};

/** Real scans at one resolution. */
struct RealTerrain
{
  double resolution = 0;  //!< [m]
  std::size_t scans = 0, points = 0;
  std::size_t cells = 0, leaves = 0, planes = 0;
  std::vector<RealPlane> largest;  //!< planes
};

/** Maps a log in all ways, at each of its resolutions.
 * \exception std::exception in one line naming the file if it cannot be read */
std::vector<RealTerrain> mapRealScans(const RealLog& log,
                                      const TerrainExperimentSettings& settings);

}  // namespace mapconv
