#include "experiment/terrain/TerrainMappings.h"

#include <mrpt_mapconv/eval/ElevationMap.h>

#include <future>
#include <random>

namespace mapconv
{
using namespace mrpt_mapconv;
using terrain::HeightRule;

namespace
{
terrain::TerrainParams withRule(terrain::TerrainParams params, HeightRule rule)
{
  params.heightRule = rule;
  return params;
}

terrain::TerrainMap terrainOf(const TerrainWalk& walk, std::size_t noise, double resolution,
                              const terrain::TerrainParams& params)
{
  terrain::TerrainMap map(resolution, params);
  const auto sigmas = walk.sigmas(noise);
  for (const terrain::TerrainScan& scan : walk.scans(noise))
  {
    map.insert(scan, sigmas);
    map.update(1);
  }
  return map;
}
}  // namespace

TerrainMappings mappingsOf(const TerrainWalk& walk, std::size_t noise, double resolution,
                           const TerrainExperimentSettings& settings)
{
  auto maximum = std::async(std::launch::async, terrainOf, std::cref(walk), noise, resolution,
                            withRule(settings.params, HeightRule::Maximum));
  TerrainMappings mappings{
      terrainOf(walk, noise, resolution, withRule(settings.params, HeightRule::Fused)),
      maximum.get(),
      {},
      {}};
  eval::ElevationMap elevation(resolution);
  const auto sigmas = walk.sigmas(noise);
  for (const terrain::TerrainScan& scan : walk.scans(noise)) elevation.insert(scan, sigmas);
  mappings.elevationFused = elevation.fuse().height;
  mappings.elevationRaw = elevation.height();
  mappings.elevationMemory = elevation.memory();
  return mappings;
}

QueryTimes queryTimes(const terrain::TerrainMap& map, const grid::Layer<float>& cells)
{
  constexpr std::size_t kQueries = 300000;
  const grid::GridFrame& frame = cells.frame();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(frame.xMin(), frame.xMax()),
      y(frame.yMin(), frame.yMax());
  std::vector<mrpt::math::TPoint2D> places(kQueries);
  for (auto& place : places) place = {x(random), y(random)};
  volatile double sum = 0;  // so that nothing is left out
  const auto nanoseconds = [&](const auto& heightAt)
  {
    Stopwatch watch;
    for (const auto& place : places) sum = sum + heightAt(place);
    return 1e9 * watch.lap() / static_cast<double>(kQueries);
  };
  QueryTimes times;
  times.leaves = nanoseconds(
      [&](const mrpt::math::TPoint2D& place)
      {
        const auto point = map.at(place.x, place.y);
        return point ? point->height : 0.0;
      });
  times.cells = nanoseconds(
      [&](const mrpt::math::TPoint2D& place)
      {
        const std::int32_t kx = map.keyOf(place.x), ky = map.keyOf(place.y);
        return frame.containsKey(kx, ky)
                   ? static_cast<double>(cells.cells()[frame.indexOfKey(kx, ky)])
                   : 0.0;
      });
  return times;
}

}  // namespace mapconv
