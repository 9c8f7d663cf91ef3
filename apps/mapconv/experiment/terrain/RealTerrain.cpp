#include "experiment/terrain/RealTerrain.h"

#include <mrpt_mapconv/eval/ElevationMap.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/terrain/ScanInsertion.h>

#include <algorithm>
#include <cmath>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct RealScan
{
  observation::SensorPoints seen;
  terrain::UsedPoints used;
};

std::vector<RealScan> readScans(const RealLog& log)
{
  observation::RawlogOptions options;
  options.staticSensor = log.staticSensor;
  std::vector<RealScan> scans;
  for (const auto& scan : observation::readRawlog(log.file, options))
  {
    RealScan real;
    if (!observation::sensorPoints(*scan.observation, scan.robotPose, real.seen)) continue;
    real.used = terrain::usedPoints(real.seen, log.limits);
    scans.push_back(std::move(real));
  }
  return scans;
}

/** Heights of cells by the map's rule, whatever planes they lie in. */
grid::Layer<float> cellHeights(const terrain::TerrainMap& map)
{
  grid::Layer<float> heights(map.frame(), NAN);
  const grid::GridFrame& frame = heights.frame();
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      if (const auto cell = map.cell(frame.x0 + ix, frame.y0 + iy))
        heights.at(ix, iy) = static_cast<float>(cell->height);
  return heights;
}

eval::CellMask cellsOf(std::size_t plane, const grid::Layer<float>& planes)
{
  eval::CellMask mask(planes.frame(), 0);
  for (std::size_t i = 0; i < mask.cells().size(); ++i)
    mask.cells()[i] = planes.cells()[i] == static_cast<float>(plane);
  return mask;
}

std::vector<RealPlane> largestPlanes(const terrain::TerrainMap& map,
                                     const PerTerrainHeights<grid::Layer<float>>& heights,
                                     std::size_t most)
{
  std::vector<std::size_t> order(map.planes().size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b)
                   { return map.planes()[a].cells > map.planes()[b].cells; });
  order.resize(std::min(order.size(), most));
  const auto planes = map.layers().plane;
  std::vector<RealPlane> largest;
  for (const std::size_t plane : order)
  {
    const auto cells = cellsOf(plane, planes);
    RealPlane real{map.planes()[plane], {}};
    for (std::size_t i = 0; i < kTerrainHeights; ++i)
      real.residuals[i] = eval::residualsToPlane(heights[i], cells);
    largest.push_back(real);
  }
  return largest;
}

RealTerrain mapScans(const std::vector<RealScan>& scans, double resolution,
                     const TerrainExperimentSettings& settings)
{
  auto params = settings.params;
  params.heightRule = terrain::HeightRule::Fused;
  terrain::TerrainMap fused(resolution, params);
  params.heightRule = terrain::HeightRule::Maximum;
  terrain::TerrainMap maximum(resolution, params);
  eval::ElevationMap elevation(resolution);
  const terrain::PointSigmas sigmas;
  RealTerrain run;
  run.resolution = resolution;
  run.scans = scans.size();
  for (const RealScan& scan : scans)
  {
    const auto input = terrain::terrainScan(scan.seen, scan.used, sigmas.poseCovariance());
    run.points += fused.insert(input, sigmas).inserted;
    fused.update(1);
    maximum.insert(input, sigmas);
    elevation.insert(input, sigmas);
  }
  run.cells = fused.cells();
  run.leaves = fused.leaves();
  run.planes = fused.planes().size();
  run.largest = largestPlanes(
      fused,
      {cellHeights(fused), cellHeights(maximum), elevation.fuse().height, elevation.height()},
      settings.largestPlanes);
  return run;
}
}  // namespace

std::vector<RealTerrain> mapRealScans(const RealLog& log, const TerrainExperimentSettings& settings)
{
  const auto scans = readScans(log);
  std::vector<RealTerrain> runs;
  for (const double resolution : log.resolutions)
    runs.push_back(mapScans(scans, resolution, settings));
  return runs;
}

}  // namespace mapconv
