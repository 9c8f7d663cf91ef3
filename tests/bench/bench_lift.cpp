// Speed of lifting an aerial robot's path of 10 000 points with a sphere of 10 cells' radius, as
// ratio to the straightforward scan of all cells around each point in the same process, with the
// same compiler flags. Each figure is the best of seven, ours and the baseline measured in turn.
//
//   bench_lift [--benchmark_filter=terrain|storeys|outdoor|small]
#include <benchmark/benchmark.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/path/LiftPath.h>
#include <mrpt_mapconv/sim/SampleMaps.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

using namespace mrpt_mapconv;

namespace
{
using Path = std::vector<mrpt::math::TPoint2D>;

double seconds(const std::function<void()>& task)
{
  const auto begin = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/** What is lifted: layers, a path over them, parameters and perhaps the voxel map. */
struct Subject
{
  freespace::ConversionParams conversion = freespace::ConversionParams::paper();
  path::LiftParams params;
  freespace::Layers layers;
  Path path;
  std::unique_ptr<octomap::OcTree> tree;
  std::unique_ptr<voxel::VoxelSource> voxels;
};

/** To and fro over the middle of a frame, a little less than a cell at a time. */
Path serpentine(const grid::GridFrame& frame, int points)
{
  constexpr double kStep = 0.93, kLaneDistance = 17;  // cells
  const double length = 0.8 * frame.width;
  Path path;
  for (int i = 0; i < points; ++i)
  {
    const double way = i * kStep, lane = std::floor(way / length), along = way - lane * length;
    const bool back = std::fmod(lane, 2.0) > 0;
    const double x = 0.1 * frame.width + (back ? length - along : along);
    const double y = 0.1 * frame.height + std::fmod(lane * kLaneDistance, 0.8 * frame.height) +
                     3 * std::sin(0.05 * along);
    path.push_back({frame.xMin() + x * frame.resolution, frame.yMin() + y * frame.resolution});
  }
  return path;
}

void setRadius(Subject& subject, double resolution)
{
  subject.params.safetyRadius = 10 * resolution;
  subject.conversion.minClearance = 20 * resolution;
}

/** Hills under a high ceiling: every point can be reached and the sphere matters at some. */
Subject terrain(int points)
{
  const grid::GridFrame frame{0.1, -500, -500, 1000, 1000};
  Subject subject;
  setRadius(subject, frame.resolution);
  subject.layers = freespace::Layers(frame);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const auto floor = static_cast<float>(std::sin(0.03 * x) + std::cos(0.05 * y));
      subject.layers.floor.at(x, y) = floor;
      subject.layers.ceiling.at(x, y) = floor + 3;
      subject.layers.aerial.at(x, y) = 0;
    }
  subject.path = serpentine(frame, points);
  return subject;
}

/** Two storeys: a slab in every column. */
class Storeys : public voxel::VoxelSource
{
 public:
  double resolution() const override { return 0.1; }
  std::optional<voxel::KeyRect> bounds() const override
  {
    return voxel::KeyRect{-512, -512, 511, 511};
  }
  void read(voxel::ColumnBlock& block) const override
  {
    block.setHeight(0, 64);
    block.markSlab(0, 30, false);
    block.markSlab(30, 33, true);
    block.markSlab(33, 63, false);
  }
};

Subject storeys(int points, double heightOffset)
{
  Subject subject;
  subject.voxels = std::make_unique<Storeys>();
  setRadius(subject, subject.voxels->resolution());
  subject.layers = freespace::convert(*subject.voxels, subject.conversion);
  subject.path = serpentine(subject.layers.frame(), points);
  subject.params.heightOffset = heightOffset;
  return subject;
}

Subject outdoor(double size, int points)
{
  sim::OutdoorOptions options;
  options.size = size;
  Subject subject;
  subject.tree = sim::outdoorMap(options);
  subject.voxels = voxel::makeOctreeSource(*subject.tree);
  setRadius(subject, options.resolution);
  subject.layers = freespace::convert(*subject.voxels, subject.conversion);
  subject.path = serpentine(subject.layers.frame(), points);
  subject.params.unknownIsPassable = true;
  return subject;
}

/** The limits of a sphere's height at each point, by the definition's plain loop. */
double plainScan(const Subject& subject, const path::LiftedPath& lifted)
{
  const freespace::Layers& layers = subject.layers;
  const grid::GridFrame& frame = layers.frame();
  const double res = frame.resolution, radius = subject.params.safetyRadius;
  const auto reach = static_cast<std::int32_t>(std::ceil(radius / res)) + 1;
  double check = 0;
  for (const path::LiftedPoint& point : lifted.points)
  {
    const double px = point.position.x, py = point.position.y;
    const auto kx = static_cast<std::int32_t>(std::floor(px / res));
    const auto ky = static_cast<std::int32_t>(std::floor(py / res));
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    bool blocked = false;
    for (std::int32_t y = ky - reach; y <= ky + reach; ++y)
      for (std::int32_t x = kx - reach; x <= kx + reach; ++x)
      {
        const double dx = std::max({x * res - px, 0.0, px - (x + 1) * res});
        const double dy = std::max({y * res - py, 0.0, py - (y + 1) * res});
        const double distance = std::hypot(dx, dy);
        if (distance > radius) continue;
        const bool inside = frame.containsKey(x, y);
        if (!inside || std::isnan(layers.floor.cells()[frame.indexOfKey(x, y)]))
        {
          blocked = true;
          continue;
        }
        const double half = std::sqrt(radius * radius - distance * distance);
        low = std::max(low, layers.floor.cells()[frame.indexOfKey(x, y)] + half);
        high = std::min(high, layers.ceiling.cells()[frame.indexOfKey(x, y)] - half);
      }
    if (!blocked) check += low + high;
  }
  return check;
}

void lift(benchmark::State& state, const Subject& subject, bool withVoxels)
{
  const voxel::VoxelSource* voxels = withVoxels ? subject.voxels.get() : nullptr;
  path::LiftedPath lifted;
  double best = std::numeric_limits<double>::max(), bestBaseline = best;
  for (auto _ : state)
  {
    const double time = seconds(
        [&]
        {
          lifted = path::liftPath(subject.path, subject.layers, subject.conversion, subject.params,
                                  voxels);
        });
    bestBaseline = std::min(bestBaseline,
                            seconds([&] { benchmark::DoNotOptimize(plainScan(subject, lifted)); }));
    best = std::min(best, time);
    state.SetIterationTime(time);
  }
  double reachable = 0, slabs = 0;
  for (const path::LiftedPoint& point : lifted.points)
  {
    reachable += point.problem == path::Infeasibility::None;
    slabs += point.rule == path::HeightRule::SphereSlab;
  }
  state.counters["best_ms"] = 1e3 * best;
  state.counters["plain_scan_ms"] = 1e3 * bestBaseline;
  state.counters["ratio_to_plain_scan"] = best / bestBaseline;
  state.counters["points"] = static_cast<double>(lifted.points.size());
  state.counters["reachable"] = reachable;
  state.counters["moved_by_slabs"] = slabs;
}

template <class Make>
void add(const std::string& name, bool withVoxels, const Make& make)
{
  benchmark::RegisterBenchmark((name + (withVoxels ? "/voxels" : "/layers")).c_str(),
                               [=](benchmark::State& state) { lift(state, make(), withVoxels); })
      ->Iterations(7)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}
}  // namespace

int main(int argc, char** argv)
{
  constexpr int kPoints = 10000;
  add("terrain", false, [] { return terrain(kPoints); });
  // at 1.5 m the sphere is clear of the slabs; from 2.5 m each point has to be moved
  add("storeys", true, [] { return storeys(kPoints, 1.5); });
  add("storeys_moved", true, [] { return storeys(kPoints, 2.5); });
  add("outdoor", false, [] { return outdoor(200, kPoints); });
  add("outdoor", true, [] { return outdoor(200, kPoints); });
  add("small", true, [] { return outdoor(20, 200); });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
