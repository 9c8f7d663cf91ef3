#include "experiment/terrain/TerrainRun.h"

#include <mrpt_mapconv/eval/LayerErrors.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <cmath>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
constexpr double kNoiseReach = 3;  // standard deviations of a range

using Heights = PerTerrainHeights<grid::Layer<float>>;

/** All cells of a world, centred on multiples of the resolution. */
grid::GridFrame terrainFrame(const sim::World& world, double resolution)
{
  grid::GridFrame frame = sim::frameOf(world, resolution);
  frame.shift = -0.5;
  ++frame.width;  // the last cells begin half a cell earlier
  ++frame.height;
  return frame;
}

/** The cells of a frame that are finite in all layers. */
eval::CellMask knownToAll(const Heights& heights, const grid::GridFrame& frame)
{
  eval::CellMask known(frame, 1);
  for (const auto& layer : heights)
  {
    const auto cells = layer.onFrame(frame, NAN);
    for (std::size_t i = 0; i < known.cells().size(); ++i)
      if (!std::isfinite(cells.cells()[i])) known.cells()[i] = 0;
  }
  return known;
}

/** Which cells are judged apart from each other. */
struct JudgedCells
{
  eval::CellMask clear, apart;  //!< away from jumps, and within a cell of them
  eval::CellMask far;           //!< of the clear ones, those that no noise reaches across a jump
};

/** \param reach of noise [m] */
JudgedCells judgedCells(const eval::TerrainTruth& truth, double reach)
{
  const eval::CellMask all(truth.height.frame(), 1);
  const auto cells = static_cast<std::int32_t>(std::ceil(reach / truth.height.frame().resolution));
  return {eval::without(all, truth.apart), truth.apart,
          eval::without(all, eval::around(truth.apart, cells))};
}

NoiseErrors errorsOf(const Heights& heights, const eval::TerrainTruth& truth,
                     const JudgedCells& judged, double noise)
{
  const auto known = knownToAll(heights, truth.height.frame());
  const auto summaries = [&](const eval::CellMask& mask)
  {
    const auto cells = eval::both(known, mask);
    PerTerrainHeights<eval::ErrorSummary> errors;
    for (std::size_t i = 0; i < kTerrainHeights; ++i)
      errors[i] = eval::summaryOf(eval::errorsOf(heights[i], truth.height, cells));
    return errors;
  };
  return {noise, summaries(judged.clear), summaries(judged.apart), summaries(judged.far)};
}

std::size_t leastCells(const TerrainExperimentSettings& settings)
{
  return static_cast<std::size_t>(settings.params.minPlaneCells);
}

/** Of the largest planes, as far as they have enough judged cells for a plane. */
std::vector<PlaneErrors> planeErrors(const Heights& heights, const eval::TerrainTruth& truth,
                                     const eval::CellMask& clear,
                                     const TerrainExperimentSettings& settings)
{
  const auto judged = eval::both(knownToAll(heights, truth.height.frame()), clear);
  std::vector<PlaneErrors> all(truth.planes.size());
  for (std::size_t plane = 0; plane < all.size(); ++plane) all[plane].plane = truth.planes[plane];
  for (std::size_t i = 0; i < kTerrainHeights; ++i)
  {
    const auto errors = eval::errorsOfPlanes(heights[i], truth, judged);
    for (std::size_t plane = 0; plane < all.size(); ++plane) all[plane].errors[i] = errors[plane];
  }
  const auto cells = [](const PlaneErrors& plane) { return plane.errors.front().cells; };
  const std::size_t least = leastCells(settings);
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const PlaneErrors& plane) { return cells(plane) < least; }),
            all.end());
  std::stable_sort(all.begin(), all.end(),
                   [&](const PlaneErrors& a, const PlaneErrors& b) { return cells(a) > cells(b); });
  if (all.size() > settings.largestPlanes) all.resize(settings.largestPlanes);
  return all;
}

std::vector<JudgedStep> judgedSteps(const terrain::TerrainMap& map, const sim::World& world,
                                    const std::vector<StairsLine>& flights)
{
  std::vector<JudgedStep> judged;
  for (const StairsLine& flight : flights)
    for (const eval::StepMatch& match : eval::matchSteps(
             eval::trueSteps(world, flight.from, flight.to, map.params().planeTolerance), map))
      judged.push_back({match, flight.name});
  return judged;
}

AdaptiveMap adaptive(const terrain::TerrainMap& map, const terrain::TerrainLayers& layers,
                     const eval::TerrainTruth& truth, const TerrainWalk& walk,
                     const TerrainWorld& world, const TerrainExperimentSettings& settings)
{
  const eval::PlaneMatchParams match{settings.overlap, leastCells(settings)};
  return {map.cells(),
          map.leaves(),
          map.memory(),
          map.planes().size(),
          eval::matchPlanes(layers.plane, layers.height, truth.plane, match),
          judgedSteps(map, walk.world(), world.flights)};
}

std::size_t knownCells(const grid::Layer<float>& layer)
{
  return static_cast<std::size_t>(std::count_if(layer.cells().begin(), layer.cells().end(),
                                                [](float cell) { return std::isfinite(cell); }));
}
}  // namespace

TerrainRun runTerrain(const TerrainWalk& walk, const TerrainWorld& world, double resolution,
                      const TerrainExperimentSettings& settings, Progress& progress)
{
  TerrainRun run;
  run.resolution = resolution;
  auto truth = eval::terrainTruth(walk.world(), terrainFrame(walk.world(), resolution),
                                  settings.params.planeTolerance);
  const JudgedCells judged = judgedCells(truth, kNoiseReach * walk.sigmas(0).range);
  for (std::size_t noise = 0; noise < settings.poseNoise.size(); ++noise)
  {
    auto maps = mappingsOf(walk, noise, resolution, settings);
    auto layers = maps.fused.layers();
    const auto highest = maps.maximum.layers();
    Heights heights = {layers.height, highest.height, std::move(maps.elevationFused),
                       std::move(maps.elevationRaw)};
    run.errors.push_back(errorsOf(heights, truth, judged, settings.poseNoise[noise]));
    if (settings.poseNoise[noise] != 1) continue;
    run.fused = adaptive(maps.fused, layers, truth, walk, world, settings);
    run.maximum = adaptive(maps.maximum, highest, truth, walk, world, settings);
    run.elevationCells =
        knownCells(heights[static_cast<std::size_t>(TerrainHeights::ElevationFused)]);
    run.elevationMemory = maps.elevationMemory;
    run.queries = queryTimes(maps.fused, layers.height);
    run.planes = planeErrors(heights, truth, judged.clear, settings);
    if (resolution == settings.pictured)
    {
      run.layers = std::move(layers);
      run.heights = std::move(heights);
    }
    run.seconds = mappingTimes(walk, noise, resolution, settings, progress);
  }
  if (resolution == settings.pictured) run.truth = std::move(truth);
  return run;
}

}  // namespace mapconv
