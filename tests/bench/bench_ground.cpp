// Finding the ground below a forest, as the ratio to one pass that counts the points of each cell,
// with the peak of memory as a multiple of the cloud's. Targets: 10 million points on 0.25 km² (1
// million particles) in 20 s (csf) and 5 s (smrf) on two threads, memory at most 4 times the
// cloud's.
//
//   bench_ground [POINTS]        default: 10 million, 40 on each square metre
#include <mrpt_mapconv/aerial/Ground.h>
#include <mrpt_mapconv/params/Fields.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace mrpt_mapconv;

namespace
{
constexpr double kDensity = 40;  // [1/m²]

/** A hilly forest: 2 % of the points are ground, 10 % undergrowth, the rest leaves. */
cloud::PointCloud forest(std::size_t points)
{
  std::mt19937 random(1);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double side = std::sqrt(static_cast<double>(points) / kDensity);
  cloud::PointCloud cloud;
  for (auto* axis : {&cloud.x, &cloud.y, &cloud.z}) axis->reserve(points);
  for (std::size_t i = 0; i < points; ++i)
  {
    const double x = side * share(), y = side * share();
    const double ground = 0.3 * x + 8 * std::sin(x / 40) * std::cos(y / 50) + 0.5 * std::sin(x / 5);
    const double kind = share();
    cloud.x.push_back(x);
    cloud.y.push_back(y);
    cloud.z.push_back(ground + (kind < 0.02   ? 0.1 * (share() - 0.5)
                                : kind < 0.12 ? 0.3 + 1.5 * share()
                                              : 6 + 12 * share()));
  }
  return cloud;
}

template <class Task>
double seconds(const Task& task)
{
  const auto begin = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/** What every filter begins with: each point is looked at, and a cell found for it. */
std::size_t countInCells(const cloud::PointCloud& cloud)
{
  constexpr std::size_t kWidth = 4096;
  std::vector<std::uint32_t> counts(kWidth * kWidth);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ++counts[static_cast<std::size_t>(2 * cloud.y[i]) % kWidth * kWidth +
             static_cast<std::size_t>(2 * cloud.x[i]) % kWidth];
  std::size_t most = 0;
  for (const auto count : counts) most = count > most ? count : most;
  return most;
}

/** The most memory that this process has had so far [bytes]. */
double peakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}
}  // namespace

int main(int argc, char** argv)
{
  const std::size_t points = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 10'000'000;
  const cloud::PointCloud cloud = forest(points);
  const double bytes = 3.0 * sizeof(double) * static_cast<double>(points);
  std::size_t most = 0;
  const double once = seconds([&] { most = countInCells(cloud); });
  std::printf("%zu points (%.0f MB), up to %zu in a cell: one pass %.3f s\n", points, bytes / 1e6,
              most, once);
  for (const auto filter : {aerial::GroundFilter::Smrf, aerial::GroundFilter::Csf})
    for (const int threads : {1, 2})
    {
      aerial::GroundParams params;
      params.groundFilter = filter;
      std::size_t ground = 0;
      const double time =
          seconds([&] { ground = aerial::findGround(cloud, params, threads).groundPoints; });
      std::printf("%s, %d thread%s: %.2f s, %.0f passes; %zu ground points; memory up to %.2f x\n",
                  params::textOf(filter).c_str(), threads, threads == 1 ? "" : "s", time,
                  time / once, ground, peakMemory() / bytes);
    }
  return 0;
}
