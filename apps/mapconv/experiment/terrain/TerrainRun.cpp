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

NoiseErrors errorsOf(const Heights& heights, const eval::TerrainTruth& truth, double noise)
{
  const auto known = knownToAll(heights, truth.height.frame());
  const auto clear = eval::without(known, truth.apart), apart = eval::both(known, truth.apart);
  NoiseErrors errors{noise, {}, {}};
  for (std::size_t i = 0; i < kTerrainHeights; ++i)
  {
    errors.clear[i] = eval::summaryOf(eval::errorsOf(heights[i], truth.height, clear));
    errors.apart[i] = eval::summaryOf(eval::errorsOf(heights[i], truth.height, apart));
  }
  return errors;
}

std::vector<PlaneErrors> planeErrors(const Heights& heights, const eval::TerrainTruth& truth,
                                     std::size_t most)
{
  const auto judged = eval::without(knownToAll(heights, truth.height.frame()), truth.apart);
  std::vector<PlaneErrors> all(truth.planes.size());
  for (std::size_t plane = 0; plane < all.size(); ++plane) all[plane].plane = truth.planes[plane];
  for (std::size_t i = 0; i < kTerrainHeights; ++i)
  {
    const auto errors = eval::errorsOfPlanes(heights[i], truth, judged);
    for (std::size_t plane = 0; plane < all.size(); ++plane) all[plane].errors[i] = errors[plane];
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const PlaneErrors& a, const PlaneErrors& b)
                   { return a.errors[0].cells > b.errors[0].cells; });
  if (all.size() > most) all.resize(most);
  return all;
}

std::vector<JudgedStep> judgedSteps(const terrain::TerrainMap& map, const sim::World& world,
                                    const std::vector<StairsLine>& flights)
{
  constexpr double kReach = 2;  // [cells]
  const auto steps = map.steps();
  std::vector<JudgedStep> judged;
  for (const StairsLine& flight : flights)
    for (const eval::TrueStep& truth :
         eval::trueSteps(world, flight.from, flight.to, map.params().planeTolerance))
      judged.push_back(
          {flight.name, truth, eval::stepFor(truth, steps, kReach * map.resolution())});
  return judged;
}

AdaptiveMap adaptive(const terrain::TerrainMap& map, const terrain::TerrainLayers& layers,
                     const eval::TerrainTruth& truth, const sim::World& world,
                     const std::vector<StairsLine>& flights, double overlap)
{
  const eval::PlaneMatchParams match{overlap, static_cast<std::size_t>(map.params().minPlaneCells)};
  return {map.cells(),
          map.leaves(),
          map.memory(),
          map.planes().size(),
          eval::matchPlanes(layers.plane, layers.height, truth.plane, match),
          judgedSteps(map, world, flights)};
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
  for (std::size_t noise = 0; noise < settings.poseNoise.size(); ++noise)
  {
    auto maps = mappingsOf(walk, noise, resolution, settings);
    auto layers = maps.fused.layers();
    const auto highest = maps.maximum.layers();
    Heights heights = {layers.height, highest.height, std::move(maps.elevationFused),
                       std::move(maps.elevationRaw)};
    run.errors.push_back(errorsOf(heights, truth, settings.poseNoise[noise]));
    if (settings.poseNoise[noise] != 1) continue;
    run.fused = adaptive(maps.fused, layers, truth, walk.world(), world.flights, settings.overlap);
    run.maximum =
        adaptive(maps.maximum, highest, truth, walk.world(), world.flights, settings.overlap);
    run.elevationCells =
        knownCells(heights[static_cast<std::size_t>(TerrainHeights::ElevationFused)]);
    run.elevationMemory = maps.elevationMemory;
    run.queries = queryTimes(maps.fused, layers.height);
    run.planes = planeErrors(heights, truth, settings.largestPlanes);
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
