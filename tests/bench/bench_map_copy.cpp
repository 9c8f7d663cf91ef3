// Copying a map by MRPT's serialization, as rbpf-slam does with the map of each particle that it
// resamples (CMultiMetricMap's copy constructor), as the ratio to OctoMap's own writing and reading
// of the same tree in this process. Both are the best of 31, measured in turn.
//
//   bench_map_copy [--benchmark_filter=slam|building|outdoor]
#include <benchmark/benchmark.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/sim/SampleMaps.h>
#include <mrpt_mapconv/sim/Simulator.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>

using namespace mrpt_mapconv;

namespace
{
using MapMaker = std::function<CFreeSpaceGridMap2D::Ptr()>;

CFreeSpaceGridMap2D::Ptr mapOf(std::unique_ptr<octomap::OcTree> tree)
{
  auto map = std::make_shared<CFreeSpaceGridMap2D>();
  map->setVoxelMap(std::move(tree));
  return map;
}

/** The map at the end of a SLAM run through the storey that the tests of stock programs use. */
CFreeSpaceGridMap2D::Ptr slamMap()
{
  const auto scenario = sim::Scenario::load(std::string(MRPT_MAPCONV_SOURCE_DIR) +
                                            "/tests/integration/slam/flat.ini");
  auto map = std::make_shared<CFreeSpaceGridMap2D>(0.1);
  sim::Simulator simulator(scenario, 1);
  while (const auto moment = simulator.next())
    for (const auto& scan : moment->scans)
      if (scan.is3D) map->insertObservation(*scan.observation, moment->pose);
  return map;
}

double seconds(const std::function<void()>& task)
{
  const auto begin = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/** Without OctoMap's header, whose reading prints what it does. */
void writeAndReadTree(const octomap::OcTree& tree)
{
  std::stringstream stream;
  tree.writeData(stream);
  octomap::OcTree copy(tree.getResolution());
  copy.readData(stream);
  if (copy.size() != tree.size()) throw std::runtime_error("OctoMap cannot read the tree");
}

void copyMap(benchmark::State& state, const MapMaker& make)
{
  const auto map = make();
  mrpt::maps::CMultiMetricMap particle;
  particle.maps.push_back(map);
  double best = std::numeric_limits<double>::max(), bestBaseline = best;
  for (auto _ : state)
  {
    bestBaseline = std::min(bestBaseline, seconds([&] { writeAndReadTree(map->octree()); }));
    const double time =
        seconds([&] { benchmark::DoNotOptimize(mrpt::maps::CMultiMetricMap(particle)); });
    best = std::min(best, time);
    state.SetIterationTime(time);
  }
  state.counters["best_ms"] = 1e3 * best;
  state.counters["octomap_ms"] = 1e3 * bestBaseline;
  state.counters["ratio_to_octomap"] = best / bestBaseline;
  state.counters["nodes"] = static_cast<double>(map->octree().size());
}

void add(const std::string& name, const MapMaker& make)
{
  benchmark::RegisterBenchmark((name + "/copy").c_str(),
                               [=](benchmark::State& state) { copyMap(state, make); })
      ->Iterations(31)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}
}  // namespace

int main(int argc, char** argv)
{
  add("slam", slamMap);
  add("building", [] { return mapOf(sim::buildingMap()); });
  add("outdoor",
      []
      {
        sim::OutdoorOptions options;
        options.size = 80;
        return mapOf(sim::outdoorMap(options));
      });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
