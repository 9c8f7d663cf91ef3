#pragma once

#include <malloc.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace mrpt_mapconv::fixtures
{
/** A drive along a street that repeats itself: a floor that never ends, kerbs and a wall beside it,
 * stairs onto platforms, ramps, a bank that rises and falls, and rubble. The map keeps a local
 * window. */
class TerrainDrive
{
 public:
  static constexpr double kLength = 500, kPeriod = 12.5, kStride = 0.5;  // [m]

  struct Scan
  {
    double way = 0;          //!< [m]
    double seconds = 0;      //!< of insertion and update, of this thread alone
    std::size_t memory = 0;  //!< TerrainMap::memory()
    std::size_t heap = 0;    //!< of the process: all blocks in use [bytes]
  };

  explicit TerrainDrive(double resolution) : m_map(resolution, params()) {}

  /** Drives all of it. \param points of a scan */
  std::vector<Scan> drive(std::size_t points)
  {
    std::vector<Scan> scans;
    for (double way = 0; way <= kLength; way += kStride) scans.push_back(scanAt(way, points));
    return scans;
  }
  const terrain::TerrainMap& map() const { return m_map; }

  /** The scans of a stretch [m]. */
  static std::vector<Scan> between(const std::vector<Scan>& scans, double from, double to)
  {
    std::vector<Scan> some;
    for (const Scan& scan : scans)
      if (scan.way >= from && scan.way <= to) some.push_back(scan);
    return some;
  }
  static double medianSeconds(std::vector<Scan> scans)
  {
    const auto middle = scans.begin() + static_cast<std::ptrdiff_t>(scans.size() / 2);
    std::nth_element(scans.begin(), middle, scans.end(),
                     [](const Scan& a, const Scan& b) { return a.seconds < b.seconds; });
    return middle->seconds;
  }
  static std::size_t mostOf(const std::vector<Scan>& scans, std::size_t Scan::*what)
  {
    std::size_t most = 0;
    for (const Scan& scan : scans) most = std::max(most, scan.*what);
    return most;
  }

 private:
  static terrain::TerrainParams params()
  {
    terrain::TerrainParams params;
    params.localWindow = 10;
    return params;
  }

  /** What others do on the machine does not count. */
  static double threadSeconds()
  {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  /** Without noise [m]. */
  double heightAt(double x, double y)
  {
    const double along = x - kPeriod * std::floor(x / kPeriod);
    if (std::abs(y) < 1) return 0;
    if (y > 4.5) return std::uniform_real_distribution<double>(0, 2)(m_random);   // a wall
    if (y < -3) return 0.3 + 0.15 * std::sin(2 * M_PI * x / kPeriod) * (-3 - y);  // a bank
    if (y < -1) return 0.14;                                                      // a pavement
    if (along < 2) return 0.17 * std::ceil(along / 0.3);
    if (along < 5) return 0.17 * 7;
    if (along < 8) return 0.17 * 7 * (8 - along) / 3;
    if (along < 10) return std::uniform_real_distribution<double>(0, 0.3)(m_random);
    return 0;
  }

  Scan scanAt(double way, std::size_t points)
  {
    constexpr double kReach = 6;  // [m]
    std::normal_distribution<double> noise(0, 0.015);
    std::uniform_real_distribution<double> range(0.3, kReach), angle(-M_PI, M_PI);
    m_x.resize(points);
    m_y.resize(points);
    m_z.resize(points);
    for (std::size_t i = 0; i < points; ++i)
    {
      const double r = range(m_random), a = angle(m_random);
      const double x = way + r * std::cos(a), y = r * std::sin(a);
      m_x[i] = static_cast<float>(x - way + noise(m_random));
      m_y[i] = static_cast<float>(y + noise(m_random));
      m_z[i] = static_cast<float>(heightAt(x, y) + noise(m_random));
    }
    terrain::TerrainScan scan;
    scan.x = m_x.data();
    scan.y = m_y.data();
    scan.z = m_z.data();
    scan.points = points;
    scan.sensorPose.x(way);
    scan.robotPose.x(way);
    const double begin = threadSeconds();
    m_map.insert(scan, {});
    m_map.update(1);
    const double end = threadSeconds();
    const auto heap = mallinfo2();
    return {way, end - begin, m_map.memory(), heap.uordblks + heap.hblkhd};
  }

  terrain::TerrainMap m_map;
  std::mt19937 m_random{1};
  std::vector<float> m_x, m_y, m_z;
};

}  // namespace mrpt_mapconv::fixtures
