// How fast is the baseline that terrain maps are compared with? A robot walks through
// config/worlds/stairs.ini; for each resolution this prints, on one thread, the points a second
// that are inserted into an elevation map, pose and variance included, and how long the pass takes
// that fuses all cells, by itself and beside the insertion of a scan.
//
//   bench_terrain_baseline [SCANS]    SCANS: only the first ones, to see quickly that it works
#include <mrpt_mapconv/eval/ElevationMap.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/sim/Simulator.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

using namespace mrpt_mapconv;

namespace
{
/** A scan's points, and where it was made. */
struct Scan
{
  std::vector<float> x, y, z;
  mrpt::poses::CPose3D sensorPose, robotPose;
};

const std::string kWorld = MRPT_MAPCONV_SOURCE_DIR "/config/worlds/stairs.ini";

/** \param most number of scans, at most */
std::vector<Scan> walkThrough(std::size_t most)
{
  std::vector<Scan> scans;
  const auto scenario = sim::Scenario::load(kWorld);
  sim::Simulator simulator(scenario, 1);
  while (const auto moment = simulator.next())
    for (const sim::Scan& seen : moment->scans)
    {
      if (scans.size() == most) return scans;
      const auto points = observation::sensorPoints(*seen.observation, moment->estimatedPose);
      Scan scan;
      for (const auto& p : points->points)
      {
        scan.x.push_back(p.x);
        scan.y.push_back(p.y);
        scan.z.push_back(p.z);
      }
      scan.sensorPose = points->sensorPose;
      scan.robotPose = points->robotPose;
      scans.push_back(std::move(scan));
    }
  return scans;
}

/** Of this program alone: other programs' share of a machine does not count [s]. */
double cpuTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Times
{
  double insertion = 1e9, fusion = 1e9;  //!< of all scans, the best of some runs [s]
  std::size_t points = 0, cells = 0;
};

Times timesOf(const std::vector<Scan>& scans, double resolution)
{
  Times best;
  const terrain::PointSigmas sigmas;
  for (int run = 0; run < 3; ++run)
  {
    Times times{0, 0, 0, 0};
    eval::ElevationMap map(resolution);
    for (const Scan& scan : scans)
    {
      terrain::TerrainScan input;
      input.x = scan.x.data();
      input.y = scan.y.data();
      input.z = scan.z.data();
      input.points = scan.x.size();
      input.sensorPose = scan.sensorPose;
      input.robotPose = scan.robotPose;
      input.poseCovariance = sigmas.poseCovariance();
      double start = cpuTime();
      times.points += map.insert(input, sigmas).inserted;
      times.insertion += cpuTime() - start;
      start = cpuTime();
      map.fuse();
      times.fusion += cpuTime() - start;
    }
    best.points = times.points;
    best.cells = map.frame().size();
    best.insertion = std::min(best.insertion, times.insertion);
    best.fusion = std::min(best.fusion, times.fusion);
  }
  return best;
}
}  // namespace

int main(int argc, char** argv)
{
  const std::size_t most = argc > 1 ? std::stoul(argv[1]) : std::numeric_limits<std::size_t>::max();
  const auto scans = walkThrough(most);
  std::printf("%s, %zu scans\n", kWorld.c_str(), scans.size());
  std::printf("resolution    cells   Mpoints/s   insertion   fusion   fusion : insertion\n");
  for (const double resolution : {0.005, 0.01, 0.02, 0.05, 0.1})
  {
    const Times times = timesOf(scans, resolution);
    std::printf("%8g m %10zu %11.1f %9.3f s %6.3f s %20.2f\n", resolution, times.cells,
                1e-6 * static_cast<double>(times.points) / times.insertion, times.insertion,
                times.fusion, times.fusion / times.insertion);
  }
  return 0;
}
