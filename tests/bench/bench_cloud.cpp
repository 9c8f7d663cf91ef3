// Reading a .las, as the ratio to a plain read of the same bytes (which are in the page cache) into
// memory; best of five each, in turn. Target: >= 100 MB/s.
//
//   bench_cloud [POINTS]         default: 3 million of point format 6
//   bench_cloud FILE             a file of points of any format
#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/files/InputStream.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>
#include <string>

#include "support/TempDir.h"

using namespace mrpt_mapconv;

namespace
{
cloud::PointCloud randomCloud(std::size_t points)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 1000);
  cloud::PointCloud cloud;
  cloud.origin = {600000, 5000000, 400};
  for (std::size_t i = 0; i < points; ++i)
  {
    cloud.x.push_back(any(random));
    cloud.y.push_back(any(random));
    cloud.z.push_back(any(random) / 10);
    cloud.time.push_back(static_cast<double>(i) * 1e-5);
    cloud.intensity.push_back(static_cast<float>(i % 1000));
    cloud.classification.push_back(static_cast<std::uint8_t>(i % 7));
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

void readPlainly(const std::string& path)
{
  files::InputStream stream(path);
  std::string block(1U << 20U, '\0');
  while (stream.read(block.data(), block.size()) == block.size()) continue;
}

void measure(const std::string& path)
{
  constexpr int kRounds = 5;
  double plain = std::numeric_limits<double>::infinity(), cloud = plain;
  std::size_t points = 0;
  for (int i = 0; i < kRounds; ++i)
  {
    plain = std::min(plain, seconds([&] { readPlainly(path); }));
    cloud = std::min(cloud, seconds([&] { points = cloud::readCloudFile(path).size(); }));
  }
  const auto megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
  std::printf("%zu points, %.1f MB: plain read %.0f MB/s, as a cloud %.0f MB/s, ratio %.3f\n",
              points, megabytes, megabytes / plain, megabytes / cloud, plain / cloud);
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc > 1 && std::filesystem::exists(argv[1]))
  {
    measure(argv[1]);
    return 0;
  }
  const mrpt_mapconv::testing::TempDir dir;
  const std::string path = dir.path("a.las");
  cloud::writeCloudFile(path, randomCloud(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 3000000));
  measure(path);
  return 0;
}
