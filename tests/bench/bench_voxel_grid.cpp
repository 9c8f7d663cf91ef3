// Speed and memory of the voxel grid, as ratios to OctoMap in this process.
//
// rays:    38 m rays and 0.25 m voxels into an empty grid, ray by ray (insertRays), one and two
//          threads: a VLP-16's in firing order from a moving sensor (targets: >= 1.2 million rays/s
//          on one thread, goal 1.5; >= 1.6 times that on two), and unrelated ones, whose middles
//          are anywhere in a cube of 38 m (>= 0.4 million). OctoMap: computeRayKeys() and an
//          updateNode() for each voxel, the first of the same rays.
// worlds:  all scans of the simplemaps of building, cave and outdoor as an octree takes them, each
//          voxel once a scan, one thread (target: >= 8 times as fast as insertPointCloud()), and
//          the heap bytes of both maps (target: not above OctoMap's).
// files:   heap bytes of the voxel maps in files (geb079.bt, say).
//
//   bench_voxel_grid rays [RAYS]            default: a million
//   bench_voxel_grid worlds [EVERY [NAME]]  each EVERY-th scan only; one of the worlds
//   bench_voxel_grid files FILE...
#include <malloc.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/TempDir.h"

using namespace mrpt_mapconv;
using voxel::Ray;
using voxel::VoxelGrid;

namespace
{
double seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::size_t heapBytes() { return mallinfo2().uordblks + mallinfo2().hblkhd; }

// --- rays

constexpr double kRange = 38, kVoxel = 0.25;  // [m]

std::vector<Ray> scannerRays(int count)
{
  constexpr int beams = 16;
  constexpr double turn = 0.2, drive = 5e-5;  // a firing [degrees, m]
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i)
  {
    const int beam = i % beams, firing = i / beams;
    const int order = beam % 2 == 0 ? beam / 2 : beams / 2 + beam / 2;  // as a VLP-16 fires
    const double elevation = mrpt::DEG2RAD(-15.0 + 2 * order),
                 azimuth = mrpt::DEG2RAD(turn * firing);
    const mrpt::math::TPoint3D origin(drive * firing, 0, 1);
    rays.push_back({origin, origin + mrpt::math::TPoint3D(std::cos(elevation) * std::cos(azimuth),
                                                          std::cos(elevation) * std::sin(azimuth),
                                                          std::sin(elevation)) *
                                         kRange});
  }
  return rays;
}

std::vector<Ray> unrelatedRays(int count)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto point = [&] { return mrpt::math::TPoint3D(any(random), any(random), any(random)); };
  std::vector<Ray> rays;
  while (rays.size() < static_cast<std::size_t>(count))
  {
    const auto direction = point();
    if (direction.norm() > 1 || direction.norm() < 0.1) continue;
    const auto half = direction * (kRange / 2 / direction.norm()), middle = point() * (kRange / 2);
    rays.push_back({middle - half, middle + half});
  }
  return rays;
}

/** Rays per second of OctoMap with the same sensor model. */
double octomapRate(const std::vector<Ray>& rays)
{
  const voxel::RayParams params;
  octomap::OcTree tree(kVoxel);
  tree.setProbHit(params.probHit);
  tree.setProbMiss(params.probMiss);
  tree.setClampingThresMin(octomap::probability(params.minLogOdds));
  tree.setClampingThresMax(octomap::probability(params.maxLogOdds));
  const auto toOctomap = [](const mrpt::math::TPoint3D& p)
  {
    return octomap::point3d(static_cast<float>(p.x), static_cast<float>(p.y),
                            static_cast<float>(p.z));
  };
  const std::size_t count = std::min<std::size_t>(rays.size(), 20000);
  octomap::KeyRay keys;
  const double begin = seconds();
  for (std::size_t i = 0; i < count; ++i)
  {
    tree.computeRayKeys(toOctomap(rays[i].origin), toOctomap(rays[i].end), keys);
    for (const auto& key : keys) tree.updateNode(key, false);
    tree.updateNode(toOctomap(rays[i].end), true);
  }
  return static_cast<double>(count) / (seconds() - begin);
}

void reportRays(const char* name, const std::vector<Ray>& rays)
{
  constexpr int rounds = 5;
  std::vector<double> best(2, 0);
  voxel::InsertedRays inserted;
  for (int round = 0; round < rounds; ++round)
    for (int threads = 1; threads <= 2; ++threads)
    {
      VoxelGrid grid(kVoxel);
      const double begin = seconds();
      inserted = voxel::insertRays(grid, rays, {}, threads);
      double& rate = best[static_cast<std::size_t>(threads - 1)];
      rate = std::max(rate, static_cast<double>(rays.size()) / (seconds() - begin));
    }
  const double octomap = octomapRate(rays);
  const double voxels = static_cast<double>(inserted.updates) / static_cast<double>(rays.size());
  std::printf(
      "%s: %zu rays of %.0f voxels: %.2f million rays/s on one thread (%.0f million voxels/s), "
      "%.2f "
      "times that on two; OctoMap %.3f million rays/s, ratio %.0f\n",
      name, rays.size(), voxels, best[0] / 1e6, best[0] * voxels / 1e6, best[1] / best[0],
      octomap / 1e6, best[0] / octomap);
}

// --- worlds

std::vector<observation::SensorPoints> scansOf(const std::string& world, std::size_t every)
{
  const mrpt_mapconv::testing::TempDir dir;
  files::OutputDir out(dir.path(world));
  const auto scenario = sim::Scenario::load(std::string(MRPT_MAPCONV_SOURCE_DIR) +
                                            "/config/worlds/" + world + ".ini");
  sim::simulateTo(out, scenario, 1);
  out.commit();
  std::vector<observation::SensorPoints> scans;
  const auto posed = observation::readSimpleMap(dir.path(world) + "/scans.simplemap");
  for (std::size_t i = 0; i < posed.size(); i += every)
    if (auto scan = observation::sensorPoints(*posed[i].observation, posed[i].robotPose))
      if (!scan->empty()) scans.push_back(std::move(*scan));
  return scans;
}

/** OctoMap's own insertion of a scan. It knows no beams without return: they end in hits. */
double octomapSeconds(octomap::OcTree& tree, const observation::SensorPoints& scan)
{
  const auto inMap = [&scan](const mrpt::math::TPoint3Df& point)
  {
    double x = 0, y = 0, z = 0;
    scan.sensorPose.composePoint(point.x, point.y, point.z, x, y, z);
    return octomap::point3d(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  };
  octomap::Pointcloud cloud;
  for (const auto* points : {&scan.points, &scan.noReturns})
    for (const auto& point : *points) cloud.push_back(inMap(point));
  const octomap::point3d origin(static_cast<float>(scan.sensorPose.x()),
                                static_cast<float>(scan.sensorPose.y()),
                                static_cast<float>(scan.sensorPose.z()));
  const double begin = seconds();
  tree.insertPointCloud(cloud, origin);
  return seconds() - begin;
}

void reportWorld(const std::string& world, double resolution, std::size_t every)
{
  const auto scans = scansOf(world, every);
  const voxel::TVoxelInsertionOptions options;
  octomap::OcTree timed(resolution);
  double octomap = 0;
  for (const auto& scan : scans) octomap += octomapSeconds(timed, scan);

  double best = 1e9;
  std::size_t bytes = 0, counted = 0;
  std::optional<VoxelGrid> grid;
  for (int round = 0; round < 3; ++round)
  {
    grid.reset();
    const std::size_t before = heapBytes();
    double took = 0;
    grid.emplace(resolution);
    for (const auto& scan : scans)
    {
      const double begin = seconds();
      voxel::insertScan(*grid, scan, options, nullptr, 1);
      took += seconds() - begin;
    }
    best = std::min(best, took);
    bytes = heapBytes() - before;
    counted = grid->heapBytes();
  }
  const std::size_t before = heapBytes();
  const auto tree = voxel::toOcTree(*grid);
  const std::size_t treeBytes = heapBytes() - before;
  std::printf(
      "%s: %zu scans at %g m: %.2f s, insertPointCloud %.2f s, ratio %.1f; heap %.1f MB (counted "
      "%.1f), as an octree %.1f MB, ratio %.2f\n",
      world.c_str(), scans.size(), resolution, best, octomap, octomap / best,
      static_cast<double>(bytes) / 1e6, static_cast<double>(counted) / 1e6,
      static_cast<double>(treeBytes) / 1e6,
      static_cast<double>(bytes) / static_cast<double>(treeBytes));
}

// --- files

void reportFile(const std::string& path)
{
  std::size_t before = heapBytes();
  const auto tree = voxel::readOctreeFile(path);
  const std::size_t treeBytes = heapBytes() - before;
  before = heapBytes();
  const VoxelGrid grid = voxel::toVoxelGrid(*tree);
  const std::size_t bytes = heapBytes() - before;
  std::printf("%s: heap %.1f MB, octree %.1f MB, ratio %.2f\n", path.c_str(),
              static_cast<double>(bytes) / 1e6, static_cast<double>(treeBytes) / 1e6,
              static_cast<double>(bytes) / static_cast<double>(treeBytes));
}
}  // namespace

int main(int argc, char** argv)
{
  const std::string part = argc > 1 ? argv[1] : "";
  const int number = argc > 2 ? std::atoi(argv[2]) : 0;
  try
  {
    if (part == "files")
      for (int i = 2; i < argc; ++i) reportFile(argv[i]);
    if (part == "rays" || part.empty())
    {
      const int count = number > 0 ? number : 1'000'000;
      reportRays("VLP-16, moving", scannerRays(count));
      reportRays("unrelated", unrelatedRays(count));
    }
    if (part == "worlds" || part.empty())
      for (const auto& [world, resolution] :
           {std::pair{"building", 0.1}, std::pair{"cave", 0.1}, std::pair{"outdoor", 0.2}})
        if (argc < 4 || std::string(argv[3]) == world)
          reportWorld(world, resolution, static_cast<std::size_t>(std::max(1, number)));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_voxel_grid: error: %s\n", error.what());
    return 1;
  }
  return 0;
}
