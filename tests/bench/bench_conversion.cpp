// Speed and memory of the conversion, as ratios to OctoMap's own leaf iterator walking the same
// tree in this process, with the same compiler flags. Each figure is the best of seven, ours and
// the baseline measured in turn. Updates are measured one after another, since an update follows
// the insertion of a scan, which has just been in the same part of the tree; "cold" ones follow a
// full conversion, and "changed" ones also find other floors there (the others find all as it was).
//
//   bench_conversion [--benchmark_filter=outdoor|geb079|small]
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/sim/SampleMaps.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <new>
#include <random>

using namespace mrpt_mapconv;

// --- memory: every allocation of this process, the library's included, passes here
namespace
{
std::atomic<std::size_t> allocated{0}, peak{0};

void* counted(void* memory)
{
  if (!memory) throw std::bad_alloc();
  const std::size_t now = allocated += malloc_usable_size(memory);
  std::size_t before = peak;
  while (before < now && !peak.compare_exchange_weak(before, now)) continue;
  return memory;
}
void release(void* memory)
{
  if (memory) allocated -= malloc_usable_size(memory);
  std::free(memory);
}
}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size)); }
void* operator new[](std::size_t size) { return counted(std::malloc(size)); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

namespace
{
using Task = std::function<void()>;

double seconds(const Task& task)
{
  const auto begin = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/** A map under test and its baseline. */
struct Subject
{
  std::unique_ptr<octomap::OcTree> tree;
  voxel::OctreeSource<octomap::OcTree> source{*tree};

  explicit Subject(std::unique_ptr<octomap::OcTree> octree) : tree(std::move(octree)) {}

  void walkLeaves() const
  {
    std::size_t occupied = 0;
    for (auto it = tree->begin_leafs(), end = tree->end_leafs(); it != end; ++it)
      occupied += tree->isNodeOccupied(*it);
    benchmark::DoNotOptimize(occupied);
  }
  /** The loop that a fixed projection of the whole height would be with OctoMap's own means. */
  void walkLeavesInBox() const
  {
    std::size_t occupied = 0;
    const octomap::OcTreeKey min(0, 0, 0), max(65535, 65535, 65535);
    for (auto it = tree->begin_leafs_bbx(min, max), end = tree->end_leafs_bbx(); it != end; ++it)
      occupied += tree->isNodeOccupied(*it);
    benchmark::DoNotOptimize(occupied);
  }
};

void report(benchmark::State& state, double best, double bestBaseline, const char* ratio)
{
  state.counters["best_ms"] = 1e3 * best;
  state.counters["baseline_ms"] = 1e3 * bestBaseline;
  state.counters[ratio] = best / bestBaseline;
}

/** Runs ours and the baseline in turn; reports the best times' ratio. */
void compare(benchmark::State& state, const Task& ours, const Task& baseline, const char* ratio)
{
  double best = std::numeric_limits<double>::max(), bestBaseline = best;
  for (auto _ : state)
  {
    bestBaseline = std::min(bestBaseline, seconds(baseline));
    const double time = seconds(ours);
    best = std::min(best, time);
    state.SetIterationTime(time);
  }
  report(state, best, bestBaseline, ratio);
}

voxel::ColumnSet centredSquare(const grid::GridFrame& frame, double share)
{
  const auto side = static_cast<std::int32_t>(std::sqrt(share * static_cast<double>(frame.size())));
  const std::int32_t height = std::min(side, frame.height);
  const auto width = static_cast<std::int32_t>(share * static_cast<double>(frame.size()) / height);
  return voxel::ColumnSet::of({frame.resolution, frame.x0 + (frame.width - width) / 2,
                               frame.y0 + (frame.height - height) / 2, width, height});
}

voxel::ColumnSet scattered(const grid::GridFrame& frame, double share)
{
  std::mt19937 random(1);
  voxel::ColumnSet set;
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(frame.size()));
  for (std::size_t count = 0; count < wanted; ++count)
    set.insert(
        frame.x0 + static_cast<std::int32_t>(random() % static_cast<unsigned>(frame.width)),
        frame.y0 + static_cast<std::int32_t>(random() % static_cast<unsigned>(frame.height)));
  return set;
}

void convertAll(benchmark::State& state, const Subject& map, int threads)
{
  compare(
      state,
      [&]
      {
        benchmark::DoNotOptimize(
            freespace::convert(map.source, freespace::ConversionParams::paper(), threads));
      },
      [&] { map.walkLeaves(); }, "ratio_to_leaf_walk");
  state.counters["leaves"] = static_cast<double>(map.tree->getNumLeafNodes());
}

freespace::ConversionParams seenParams()
{
  auto params = freespace::ConversionParams::paper();
  params.maxStep = 0.2;
  params.floorFrom = freespace::FloorFrom::Seen;
  return params;
}

/** What the evidence of floors costs. */
void convertSeen(benchmark::State& state, const Subject& map, int threads)
{
  const auto seen = seenParams();
  auto paper = seen;
  paper.floorFrom = freespace::FloorFrom::LowestFree;
  compare(
      state, [&] { benchmark::DoNotOptimize(freespace::convert(map.source, seen, threads)); },
      [&] { benchmark::DoNotOptimize(freespace::convert(map.source, paper, threads)); },
      "ratio_to_lowest_free");
}

void projectAll(benchmark::State& state, const Subject& map)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  compare(
      state,
      [&]
      { benchmark::DoNotOptimize(freespace::projectFixed(map.source, -infinite, infinite, 1)); },
      [&] { map.walkLeavesInBox(); }, "ratio_to_leafs_bbx");
}

voxel::ColumnSet onePercent(const grid::GridFrame& frame, bool inOneSquare)
{
  return inOneSquare ? centredSquare(frame, 0.01) : scattered(frame, 0.01);
}

/** Times updates of the same columns against full conversions.
 * \param cold a full conversion before each update drives the columns' nodes out of the caches
 * \param nextSource gives the voxel map of the next update */
template <class NextSource>
void compareUpdates(benchmark::State& state, const Subject& map, bool cold,
                    const voxel::ColumnSet& changed, freespace::IncrementalLayers& layers,
                    const NextSource& nextSource)
{
  double best = std::numeric_limits<double>::max(), bestFull = best;
  const auto full = [&] { freespace::convert(map.source, layers.params(), 1); };
  for (int i = 0; i < 7; ++i) bestFull = std::min(bestFull, seconds(full));
  for (auto _ : state)
  {
    if (cold) full();
    const auto& source = nextSource();
    const double time = seconds([&] { layers.update(source, changed); });
    best = std::min(best, time);
    state.SetIterationTime(time);
  }
  report(state, best, bestFull, "ratio_to_full");
  state.counters["columns"] = static_cast<double>(changed.size());
}

/** Updates that find nothing new. */
void updatePart(benchmark::State& state, const Subject& map, bool inOneSquare, bool cold = false,
                const freespace::ConversionParams& params = freespace::ConversionParams::paper())
{
  freespace::IncrementalLayers layers(params, 1);
  layers.rebuild(map.source);
  compareUpdates(
      state, map, cold, onePercent(layers.layers().frame(), inOneSquare),
      layers, [&]() -> const auto& { return map.source; });
}

/** A copy of a map in which the ground of some columns lies one voxel lower. */
std::unique_ptr<octomap::OcTree> withLowerGround(const octomap::OcTree& tree,
                                                 const grid::Layer<float>& floor,
                                                 const voxel::ColumnSet& columns)
{
  auto lower = std::make_unique<octomap::OcTree>(tree);
  const double resolution = tree.getResolution();
  columns.forEach(
      [&](std::int32_t kx, std::int32_t ky)
      {
        const float height = floor.at(kx - floor.frame().x0, ky - floor.frame().y0);
        if (std::isnan(height)) return;
        const double x = (kx + 0.5) * resolution, y = (ky + 0.5) * resolution;
        lower->setNodeValue(x, y, height - 0.5 * resolution, tree.getClampingThresMinLog(), true);
        lower->setNodeValue(x, y, height - 1.5 * resolution, tree.getClampingThresMaxLog(), true);
      });
  lower->updateInnerOccupancy();
  return lower;
}

/** Updates of which each finds other floors, and other cells to infer the ground of, than the one
 * before. */
void updateChangedPart(benchmark::State& state, const Subject& map, bool inOneSquare,
                       bool cold = false)
{
  freespace::IncrementalLayers layers(seenParams(), 1);
  layers.rebuild(map.source);
  const auto changed = onePercent(layers.layers().frame(), inOneSquare);
  const Subject other(withLowerGround(*map.tree, layers.layers().floor, changed));
  bool toOther = false;
  compareUpdates(
      state, map, cold, changed, layers, [&]() -> const auto& {
        toOther = !toOther;
        return toOther ? other.source : map.source;
      });
}

void memoryOf(benchmark::State& state, const voxel::VoxelSource& source, int threads,
              const freespace::ConversionParams& params = freespace::ConversionParams::paper())
{
  double extra = 0, layersSize = 0;
  for (auto _ : state)
  {
    const std::size_t before = allocated;
    peak = before;
    const auto layers = freespace::convert(source, params, threads);
    layersSize = 7.0 * sizeof(float) * static_cast<double>(layers.frame().size());
    extra = static_cast<double>(peak - before) - layersSize;
  }
  state.counters["layers_MB"] = layersSize / 1e6;
  state.counters["extra_MB"] = extra / 1e6;
}

/** 10 000 × 10 000 columns of free space between walls: what a conversion keeps beside the layers
 * must not grow with the map. */
class LargeSource : public voxel::VoxelSource
{
 public:
  double resolution() const override { return 0.1; }
  std::optional<voxel::KeyRect> bounds() const override
  {
    return voxel::KeyRect{0, 0, kSide - 1, kSide - 1};
  }
  void read(voxel::ColumnBlock& block) const override
  {
    block.setHeight(0, 32);
    block.markSlab(0, 20, false);
    for (int y = 0; y < voxel::kBlockSide; ++y) block.markCube<1>(5, y, 10, true);
  }

 private:
  static constexpr std::int32_t kSide = 10000;
};

/** The map that a benchmark asks for; made or read when the first one needs it, one at a time. */
const Subject& subject(const std::string& name)
{
  static std::string held;
  static std::unique_ptr<Subject> map;
  if (held == name) return *map;
  map.reset();
  if (name == "geb079")
  {
    auto tree = std::make_unique<octomap::OcTree>(0.1);
    if (!tree->readBinary(std::string(MRPT_MAPCONV_SHARED_DIR) + "/geb079.bt"))
      throw std::runtime_error("geb079.bt cannot be read");
    map = std::make_unique<Subject>(std::move(tree));
  }
  else
  {
    sim::OutdoorOptions options;
    if (name == "small") options.size = 20;
    map = std::make_unique<Subject>(sim::outdoorMap(options));
  }
  held = name;
  return *map;
}

void registerAll(const std::string& map)
{
  const auto add = [&](const std::string& what, auto run)
  {
    benchmark::RegisterBenchmark((map + "/" + what).c_str(),
                                 [=](benchmark::State& state) { run(state, subject(map)); })
        ->Iterations(7)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  add("convert/1_thread", [](auto& state, auto& m) { convertAll(state, m, 1); });
  add("convert/2_threads", [](auto& state, auto& m) { convertAll(state, m, 2); });
  add("convert_seen/1_thread", [](auto& state, auto& m) { convertSeen(state, m, 1); });
  add("convert_seen/2_threads", [](auto& state, auto& m) { convertSeen(state, m, 2); });
  add("project_fixed/1_thread", [](auto& state, auto& m) { projectAll(state, m); });
  add("update_1_percent/square", [](auto& state, auto& m) { updatePart(state, m, true); });
  add("update_1_percent/square_cold",
      [](auto& state, auto& m) { updatePart(state, m, true, true); });
  add("update_1_percent/scattered", [](auto& state, auto& m) { updatePart(state, m, false); });
  add("update_1_percent_seen/square",
      [](auto& state, auto& m) { updatePart(state, m, true, false, seenParams()); });
  add("update_1_percent_seen/scattered",
      [](auto& state, auto& m) { updatePart(state, m, false, false, seenParams()); });
  add("update_1_percent_seen/square_changed",
      [](auto& state, auto& m) { updateChangedPart(state, m, true); });
  add("update_1_percent_seen/square_changed_cold",
      [](auto& state, auto& m) { updateChangedPart(state, m, true, true); });
  add("update_1_percent_seen/scattered_changed",
      [](auto& state, auto& m) { updateChangedPart(state, m, false); });
  const auto addMemory =
      [&](const std::string& what, int threads, const freespace::ConversionParams& params)
  {
    benchmark::RegisterBenchmark((map + "/" + what).c_str(), [=](benchmark::State& state)
                                 { memoryOf(state, subject(map).source, threads, params); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  };
  for (const int threads : {1, 2})
  {
    const std::string count = std::to_string(threads) + (threads == 1 ? "_thread" : "_threads");
    addMemory("memory/" + count, threads, freespace::ConversionParams::paper());
    addMemory("memory_seen/" + count, threads, seenParams());
  }
}
}  // namespace

int main(int argc, char** argv)
{
  registerAll("outdoor");
  if (std::filesystem::exists(std::string(MRPT_MAPCONV_SHARED_DIR) + "/geb079.bt"))
    registerAll("geb079");
  registerAll("small");
  benchmark::RegisterBenchmark("large/memory/2_threads",
                               [](benchmark::State& state) { memoryOf(state, LargeSource(), 2); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  for (const int threads : {1, 2})
    benchmark::RegisterBenchmark(("large/memory_seen/" + std::to_string(threads)).c_str(),
                                 [threads](benchmark::State& state)
                                 { memoryOf(state, LargeSource(), threads, seenParams()); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
