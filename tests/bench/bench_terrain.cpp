// Speed of the terrain map: points into cells (target: >= 80 million points/s on one thread at
// 0.05 m, from float arrays, pose and variance included), planes and leaves of 1000 x 1000 cells
// (targets on two threads: <= 60 ms with 10 % rubble, <= 150 ms of rubble alone), and an update
// after a scan that touches 2 % of the cells, cells of the largest plane among them (target:
// <= 10 % of the full extraction). Best of several rounds; the baseline of the ratios is a plain
// sum of the same points. Over a drive of 500 m with a local window: heap and median time per scan
// of the last tenth (targets: <= 1.1 times those between 50 and 100 m).
//
//   bench_terrain [FEWER [PART]]    FEWER: divides the number of rounds, to see quickly that it
//                                   works; PART: insertion, structured, rubble, update or drive
//                                   alone
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Scenario.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../support/TerrainDrive.h"

using namespace mrpt_mapconv;
using terrain::TerrainMap;

namespace
{
constexpr double kResolution = 0.05;  // [m]
constexpr int kSide = 1000;           // [cells]

int fewer = 1;

/** The shortest time of several rounds [s]. */
double best(int rounds, const std::function<void()>& prepare, const std::function<void()>& work)
{
  double least = 1e9;
  for (int i = 0; i < std::max(1, rounds / fewer); ++i)
  {
    prepare();
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    least = std::min(least, took.count());
  }
  return least;
}

struct Cloud
{
  std::vector<float> x, y, z;

  void add(double px, double py, double pz)
  {
    x.push_back(static_cast<float>(px));
    y.push_back(static_cast<float>(py));
    z.push_back(static_cast<float>(pz));
  }
  terrain::TerrainScan scan() const
  {
    terrain::TerrainScan scan;
    scan.x = x.data();
    scan.y = y.data();
    scan.z = z.data();
    scan.points = x.size();
    return scan;
  }
};

/** Without noise [m]. */
double structuredHeight(int x, int y)
{
  if (y > 700) return y > 940 ? 3.0 : 0.17 * ((y - 700) / 6 % 40);  // stairs: treads of 6 cells
  if (x > 100 && x < 300 && y > 100 && y < 250) return 0.4;         // platforms
  if (x > 350 && x < 500 && y > 100 && y < 300) return 0.15;
  if (x > 600 && x < 900 && y > 300 && y < 500) return 0.3 * kResolution * (x - 600);  // a ramp
  return 0;
}

/** A point for each cell. \param rubble share of cells whose height is anything within ±0.15 m,
 * in heaps */
Cloud ground(double rubble, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.005);
  std::uniform_real_distribution<double> heap(-0.15, 0.15), share(0, 1);
  std::vector<bool> isHeap(100 * 100);
  for (std::size_t i = 0; i < isHeap.size(); ++i) isHeap[i] = share(random) < rubble;
  Cloud cloud;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
    {
      const bool in = isHeap[static_cast<std::size_t>(y / 10 * 100 + x / 10)];
      const double z = structuredHeight(x, y) + (in ? heap(random) : noise(random));
      cloud.add(kResolution * x, kResolution * y, z);
    }
  return cloud;
}

TerrainMap mapOf(const Cloud& cloud)
{
  TerrainMap map(kResolution);
  map.insert(cloud.scan(), {});
  map.update(2);
  return map;
}

void printExtraction(const char* name, const Cloud& cloud)
{
  TerrainMap map = mapOf(cloud);
  for (const int threads : {1, 2})
  {
    const double seconds = best(
        10, [] {}, [&] { map.extract(threads); });
    std::printf("%-28s %d threads: %7.1f ms; %zu cells, %zu planes, %zu leaves\n", name, threads,
                1e3 * seconds, map.cells(), map.planes().size(), map.leaves());
  }
}

/** A square of 2 % of the cells, seen again with other noise. */
Cloud touched(int x0, int y0)
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.005);
  Cloud cloud;
  for (int y = y0; y < y0 + 141; ++y)
    for (int x = x0; x < x0 + 141; ++x)
      cloud.add(kResolution * x, kResolution * y, structuredHeight(x, y) + noise(random));
  return cloud;
}

void printUpdate(const Cloud& cloud)
{
  TerrainMap first = mapOf(cloud);
  const double full = best(
      10, [] {}, [&] { first.extract(2); });
  for (const int x0 : {0, 280, 560})
  {
    const Cloud scan = touched(x0, 240);
    TerrainMap map = first;
    const double update = best(
        10,
        [&]
        {
          map = first;
          map.insert(scan.scan(), {});
        },
        [&] { map.update(2); });
    std::printf(
        "update, 2 %% of the cells from x = %3d: %6.2f ms, %4.1f %% of the full extraction\n", x0,
        1e3 * update, 100 * update / full);
  }
}

struct OfficeScan
{
  Cloud cloud;
  terrain::TerrainScan scan;
};

/** Scans from places along the way through the office. */
std::vector<OfficeScan> officeScans(int count)
{
  const auto scenario =
      sim::Scenario::load(std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/worlds/office.ini");
  const sim::RayCaster caster(scenario.world);
  const auto lidar = std::find_if(scenario.sensors.begin(), scenario.sensors.end(),
                                  [](const auto& sensor) { return sensor->is3D(); });
  std::vector<OfficeScan> scans(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    const auto pose =
        scenario.trajectory.poseAt(scenario.trajectory.duration() * static_cast<double>(i) / count);
    const auto seen = observation::sensorPoints(*(*lidar)->scan(caster, pose, i).observation, pose);
    for (const auto& point : seen->points) scans[i].cloud.add(point.x, point.y, point.z);
    scans[i].scan = scans[i].cloud.scan();
    scans[i].scan.sensorPose = seen->sensorPose;
    scans[i].scan.robotPose = pose;
    scans[i].scan.poseCovariance = terrain::PointSigmas().poseCovariance();
  }
  return scans;
}

void printInsertion()
{
  const auto scans = officeScans(40);
  std::size_t points = 0;
  for (const auto& scan : scans) points += scan.scan.points;
  TerrainMap map(kResolution);
  const double seconds = best(
      20, [] {},
      [&]
      {
        for (const auto& scan : scans) map.insert(scan.scan, {});
      });
  volatile double sink = 0;
  const double sum = best(
      20, [] {},
      [&]
      {
        double all = 0;
        for (const auto& scan : scans)
          for (std::size_t i = 0; i < scan.scan.points; ++i)
            all += static_cast<double>(scan.scan.x[i] + scan.scan.y[i] + scan.scan.z[i]);
        sink = all;
      });
  std::printf("insertion, %zu scans, %zu points: %.1f million points/s on 1 thread, %.1f x a sum\n",
              scans.size(), points, 1e-6 * static_cast<double>(points) / seconds, seconds / sum);
}

void printDrive()
{
  using fixtures::TerrainDrive;
  TerrainDrive drive(kResolution);
  const auto scans = drive.drive(20000);
  const auto early = TerrainDrive::between(scans, 50, 100),
             late = TerrainDrive::between(scans, 450, 500);
  const auto print = [](const char* what, double first, double last, const char* unit)
  {
    std::printf("drive, %-22s %6.2f %s between 50 and 100 m, %.3f times that at the end\n", what,
                first, unit, last / first);
  };
  const auto printBytes = [&](const char* what, std::size_t TerrainDrive::Scan::*bytes)
  {
    print(what, 1e-6 * static_cast<double>(TerrainDrive::mostOf(early, bytes)),
          1e-6 * static_cast<double>(TerrainDrive::mostOf(late, bytes)), "MB");
  };
  print("median time per scan:", 1e3 * TerrainDrive::medianSeconds(early),
        1e3 * TerrainDrive::medianSeconds(late), "ms");
  printBytes("most heap of the map:", &TerrainDrive::Scan::memory);
  printBytes("most heap of all:", &TerrainDrive::Scan::heap);
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc > 1) fewer = std::max(1, std::atoi(argv[1]));
  const std::string part = argc > 2 ? argv[2] : "";
  const auto isWanted = [&part](const char* name) { return part.empty() || part == name; };
  if (isWanted("insertion")) printInsertion();
  if (isWanted("drive")) printDrive();
  const Cloud structured = ground(0.1, 1);
  if (isWanted("structured")) printExtraction("structured, 10 % rubble", structured);
  if (isWanted("rubble")) printExtraction("rubble alone", ground(1, 2));
  if (isWanted("update")) printUpdate(structured);
  return 0;
}
