#include <mrpt/maps/CHeightGridMap2D.h>
#include <mrpt_mapconv/eval/ElevationMap.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "experiment/terrain/TerrainMappings.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using terrain::TerrainScan;

namespace
{
using Scans = std::vector<TerrainScan>;

double secondsFor(const Scans& scans, const std::function<void(const TerrainScan&)>& insert)
{
  Stopwatch watch;
  for (const TerrainScan& scan : scans) insert(scan);
  return watch.lap();
}

double terrainTime(const Scans& scans, const terrain::PointSigmas& sigmas, double resolution,
                   terrain::TerrainParams params, terrain::HeightRule rule, int threads)
{
  params.heightRule = rule;
  terrain::TerrainMap map(resolution, params);
  return secondsFor(scans,
                    [&](const TerrainScan& scan)
                    {
                      map.insert(scan, sigmas);
                      map.update(threads);
                    });
}

double elevationTime(const Scans& scans, const terrain::PointSigmas& sigmas, double resolution,
                     bool fuse)
{
  eval::ElevationMap map(resolution);
  return secondsFor(scans,
                    [&](const TerrainScan& scan)
                    {
                      map.insert(scan, sigmas);
                      if (fuse) map.fuse();
                    });
}

/** Calls visit(x, y, z) for each point of a scan in the map's frame [m]. */
template <class Visit>
void forEachPoint(const TerrainScan& scan, const Visit& visit)
{
  const auto turn = scan.sensorPose.getRotationMatrix();
  const double x0 = scan.sensorPose.x(), y0 = scan.sensorPose.y(), z0 = scan.sensorPose.z();
  for (std::size_t i = 0; i < scan.points; ++i)
  {
    const auto x = static_cast<double>(scan.x[i * scan.stride]),
               y = static_cast<double>(scan.y[i * scan.stride]),
               z = static_cast<double>(scan.z[i * scan.stride]);
    visit(turn(0, 0) * x + turn(0, 1) * y + turn(0, 2) * z + x0,
          turn(1, 0) * x + turn(1, 1) * y + turn(1, 2) * z + y0,
          turn(2, 0) * x + turn(2, 1) * y + turn(2, 2) * z + z0);
  }
}

/** MRPT's grid has its size from the start and knows no poses, so that its points are moved first.
 */
double heightGridTime(const Scans& scans, const sim::World& world, double resolution)
{
  mrpt::maps::CHeightGridMap2D map(mrpt::maps::CHeightGridMap2D::mrSimpleAverage, world.min().x,
                                   world.max().x, world.min().y, world.max().y, resolution);
  return secondsFor(scans,
                    [&](const TerrainScan& scan) {
                      forEachPoint(scan, [&](double x, double y, double z)
                                   { map.insertIndividualPoint(x, y, z); });
                    });
}

octomap::Pointcloud cloudOf(const TerrainScan& scan)
{
  octomap::Pointcloud cloud;
  forEachPoint(
      scan, [&](double x, double y, double z)
      { cloud.push_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)); });
  return cloud;
}

/** As COctoMap inserts a scan. \param every how manyth scan is inserted; the time is that of all,
 * if the others take as long */
double octoMapTime(const Scans& scans, double resolution, std::size_t every)
{
  octomap::OcTree tree(resolution);
  double seconds = 0;
  std::size_t inserted = 0;
  for (std::size_t i = 0; i < scans.size(); i += every)
  {
    const octomap::Pointcloud cloud = cloudOf(scans[i]);
    const auto& pose = scans[i].sensorPose;
    const octomap::point3d sensor(static_cast<float>(pose.x()), static_cast<float>(pose.y()),
                                  static_cast<float>(pose.z()));
    Stopwatch watch;
    tree.insertPointCloud(cloud, sensor, -1, true);
    seconds += watch.lap();
    ++inserted;
  }
  return seconds * static_cast<double>(scans.size()) / static_cast<double>(inserted);
}

}  // namespace

PerTerrainMethod<double> mappingTimes(const TerrainWalk& walk, std::size_t noise, double resolution,
                                      const TerrainExperimentSettings& settings, Progress& progress)
{
  const Scans scans = walk.scans(noise);
  const auto sigmas = walk.sigmas(noise);
  const auto ours = [&](terrain::HeightRule rule, int threads)
  { return terrainTime(scans, sigmas, resolution, settings.params, rule, threads); };
  using Rule = terrain::HeightRule;
  const PerTerrainMethod<std::function<double()>> methods = {
      [&] { return ours(Rule::Fused, 1); },
      [&] { return ours(Rule::Maximum, 1); },
      [&] { return ours(Rule::Fused, 2); },
      [&] { return ours(Rule::Maximum, 2); },
      [&] { return elevationTime(scans, sigmas, resolution, true); },
      [&] { return elevationTime(scans, sigmas, resolution, false); },
      [&] { return heightGridTime(scans, walk.world(), resolution); },
      [&]
      { return octoMapTime(scans, resolution, static_cast<std::size_t>(settings.octoMapEvery)); }};
  PerTerrainMethod<double> seconds;
  seconds.fill(NAN);
  for (int i = 0; i < settings.repetitions; ++i)
    for (std::size_t method = 0; method < kTerrainMethods; ++method)
    {
      if (static_cast<TerrainMethod>(method) == TerrainMethod::OctoMap &&
          (resolution < settings.octoMapFrom || i > 0))
        continue;
      seconds[method] = std::fmin(seconds[method], methods[method]());
      progress.done(static_cast<double>(i * static_cast<int>(kTerrainMethods) + 1 +
                                        static_cast<int>(method)) /
                    (settings.repetitions * static_cast<int>(kTerrainMethods)));
    }
  return seconds;
}

}  // namespace mapconv
