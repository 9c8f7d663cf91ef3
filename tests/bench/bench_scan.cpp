// Speed of inserting 3D scans into a 2D grid of 5 cm cells that is large enough, everything from
// points to updated cells, on one thread, as the ratio to mrpt::maps::COctoMap inserting the same
// clouds up to 20 m in this process (target: >= 20 million points per second). Each figure is the
// best of many rounds over all scans; the baseline's of fewer, since it takes so long. "The class"
// is CScanShapeGridMap2D::insertObservation(), which takes the points from the observation first.
//
//   bench_scan [FEWER]    FEWER: divides the number of rounds, to see quickly that it works
#include <mrpt/maps/COctoMap.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace mrpt_mapconv;

namespace
{
constexpr double kResolution = 0.05;  // [m]

/** A scan as either side is given it. */
struct Scan
{
  std::vector<mrpt::math::TPoint3Df> points;
  scan::Viewpoint view;
  mrpt::obs::CObservationVelodyneScan cloud;  //!< of the same points; COctoMap skips other clouds
};

Scan scanOf(const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& robotPose)
{
  auto seen = observation::sensorPoints(observation, robotPose);
  if (!seen || seen->points.empty()) throw std::runtime_error("a scan has no points");
  Scan scan;
  scan.points = std::move(seen->points);
  scan.view = {seen->sensorPose, robotPose.z(), 0};
  scan.cloud.sensorPose = seen->sensorPose;
  for (const auto& point : scan.points)
  {
    scan.cloud.point_cloud.x.push_back(point.x);
    scan.cloud.point_cloud.y.push_back(point.y);
    scan.cloud.point_cloud.z.push_back(point.z);
  }
  return scan;
}

/** Scans from places all along the way through the office. */
std::vector<Scan> officeScans(int count)
{
  const auto scenario =
      sim::Scenario::load(std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/worlds/office.ini");
  const sim::RayCaster caster(scenario.world);
  const auto lidar = std::find_if(scenario.sensors.begin(), scenario.sensors.end(),
                                  [](const auto& sensor) { return sensor->is3D(); });
  std::vector<Scan> scans;
  for (int i = 0; i < count; ++i)
  {
    const auto pose = scenario.trajectory.poseAt(scenario.trajectory.duration() * i / count);
    const auto key = static_cast<std::uint64_t>(i);
    scans.push_back(scanOf(*(*lidar)->scan(caster, pose, key).observation, pose));
  }
  return scans;
}

std::vector<Scan> velodyneScans(const std::string& file)
{
  std::vector<Scan> scans;
  for (const auto& posed : observation::readRawlog(file, {true}))
    if (observation::is3DScan(*posed.observation))
      scans.push_back(scanOf(*posed.observation, posed.robotPose));
  return scans;
}

double seconds(const std::function<void()>& task)
{
  const auto begin = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double bestOf(int rounds, const std::function<void()>& task)
{
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) best = std::min(best, seconds(task));
  return best;
}

/** A grid that holds whatever the scans say. */
class Grid
{
 public:
  void insert(const Scan& scan, const scan::ProfileParams& params)
  {
    m_profile.compute(scan.points, scan.view, kResolution, params);
    m_update.apply(m_profile, m_frame, m_cells.data());
  }

 private:
  grid::GridFrame m_frame{kResolution, -1000, -1000, 2000, 2000};
  std::vector<std::int8_t> m_cells = std::vector<std::int8_t>(m_frame.size(), 0);
  scan::ScanProfile m_profile;
  scan::LogOddsUpdate m_update;
};

void insertIntoOctoMap(const std::vector<Scan>& scans)
{
  mrpt::maps::COctoMap map(kResolution);
  map.insertionOptions.maxrange = 20;
  std::size_t nodes = 0;
  for (const Scan& scan : scans)
  {
    if (!map.insertObservation(scan.cloud) || map.calcNumNodes() <= nodes)
      throw std::runtime_error("COctoMap has not inserted a scan");
    if (nodes == 0) nodes = 1;  // later scans may see nothing new
  }
}

struct Subject
{
  std::string name;
  std::vector<Scan> scans;
  scan::ProfileParams params;
  int baselineRounds;

  double points() const
  {
    double points = 0;
    for (const Scan& scan : scans) points += static_cast<double>(scan.points.size());
    return points;
  }
};

void report(const std::string& what, const Subject& subject, double time, double octoMap)
{
  constexpr double kTarget = 20e6;  // points per second
  const double perSecond = subject.points() / time;
  std::printf("  %-27s %6.3f ms a scan, %6.1f million points/s (%s), COctoMap/ours %5.0f\n",
              what.c_str(), 1e3 * time / static_cast<double>(subject.scans.size()), perSecond / 1e6,
              perSecond >= kTarget ? "target met" : "MISSED", octoMap / time);
}

/** Through MRPT's interface, the points taken from the observation. */
double insertIntoClass(const Subject& subject, int rounds)
{
  CScanShapeGridMap2D map(kResolution);
  map.scanInsertionOptions.profile = subject.params;
  return bestOf(rounds,
                [&]
                {
                  for (const Scan& scan : subject.scans)
                    if (!map.insertObservation(scan.cloud))
                      throw std::runtime_error("CScanShapeGridMap2D has not inserted a scan");
                });
}

void measure(const Subject& subject, int fewer)
{
  const int rounds = std::max(1, 100 / fewer);
  const double octoMap = bestOf(std::max(1, subject.baselineRounds / fewer),
                                [&] { insertIntoOctoMap(subject.scans); });
  const auto scans = static_cast<double>(subject.scans.size());
  std::printf("%s: %.0f scans of %.0f points; COctoMap %.1f ms a scan\n", subject.name.c_str(),
              scans, subject.points() / scans, 1e3 * octoMap / scans);
  for (const bool closest : {false, true})
    for (const bool filter : {true, false})
    {
      scan::ProfileParams params = subject.params;
      params.model = closest ? scan::Model::ClosestPoint : scan::Model::WholeShape;
      params.reflectionFilter = filter;
      Grid grid;
      const double time = bestOf(rounds,
                                 [&]
                                 {
                                   for (const Scan& scan : subject.scans) grid.insert(scan, params);
                                 });
      report(std::string(closest ? "closest point" : "whole shape") +
                 (filter ? ", with the cut" : ", without"),
             subject, time, octoMap);
    }
  report("the class, with the cut", subject, insertIntoClass(subject, rounds), octoMap);
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    const int fewer = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1;
    scan::ProfileParams office;
    office.structureMinZ = 2.3;
    office.structureMaxZ = 2.6;
    measure({"office", officeScans(std::max(1, 16 / fewer)), office, 2}, fewer);
    const std::string log = std::string(MRPT_MAPCONV_SHARED_DIR) + "/vlp16_3scans.rawlog";
    if (!std::filesystem::exists(log))
    {
      std::printf("VLP-16: left out, there is no %s\n", log.c_str());
      return 0;
    }
    scan::ProfileParams velodyne;  // in a small room, 1.8 m above the floor
    velodyne.objectMaxZ = 2;
    velodyne.structureMinZ = 2;
    velodyne.structureMaxZ = 3;
    measure({"VLP-16", velodyneScans(log), velodyne, 20}, fewer);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_scan: error: %s\n", error.what());
    return 1;
  }
  return 0;
}
