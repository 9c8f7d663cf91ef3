#pragma once

#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "ScanFiles.h"

namespace mrpt_mapconv::testing
{
/** What a sensor at UTM coordinates saw, one point after the other: it goes 12 m along x, 1 m up,
 * and sees a floor at z = 200.03 m. Numbers are such that floats hold them, and no point lies
 * between two voxels of 0.125 m. */
struct FloorSurvey
{
  static constexpr double kX = 448258, kY = 5411929, kZ = 200;
  static constexpr int kPoints = 300;
  static constexpr double kSpacing = 0.25;  //!< of points, in time [s]

  static double time(int i) { return i * kSpacing; }
  static mrpt::math::TPoint3D sensor(double seconds)
  {
    return {kX + 0.00390625 + 0.15625 * seconds, kY + 1.03125, kZ + 1.03125};
  }
  /** In the sensor's frame: a fan to either side. */
  static mrpt::math::TPoint3Df seen(int i)
  {
    return {0.13f + 0.37f * static_cast<float>(i % 3),
            0.017f + 0.211f * static_cast<float>(i % 9 - 4), -1.003f};
  }
  static mrpt::math::TPoint3D point(int i)
  {
    const auto from = sensor(time(i));
    const auto ray = seen(i);
    return {from.x + static_cast<double>(ray.x), from.y + static_cast<double>(ray.y),
            from.z + static_cast<double>(ray.z)};
  }

  /** A scan of one point each, between poses of every second. */
  static void writeLog(const std::string& path)
  {
    Objects objects;
    for (int t = 0; t <= kPoints * kSpacing; ++t)
    {
      auto pose = mrpt::obs::CObservationRobotPose::Create();
      const auto at = sensor(t);
      pose->pose.mean = mrpt::poses::CPose3D(at.x, at.y, at.z, 0, 0, 0);
      pose->timestamp = mrpt::Clock::fromDouble(1.6e9 + t);
      objects.push_back(pose);
    }
    for (int i = 0; i < kPoints; ++i) objects.push_back(cloudOn({seen(i)}, {}, time(i)));
    writeObjects(path, objects);
  }

  /** How a cloud's text is written. */
  struct Text
  {
    double unit = 1;                      //!< of lengths [m]
    double timeUnit = 1, timeOffset = 0;  //!< of times: less the offset, by the unit [s]
    std::string header = "x,y,z,time\n";
  };
  static void writeCloud(const std::string& path, const Text& text)
  {
    std::ofstream out(path);
    out.precision(17);
    out << text.header;
    for (int i = 0; i < kPoints; ++i)
    {
      const auto p = point(i);
      out << p.x / text.unit << ',' << p.y / text.unit << ',' << p.z / text.unit << ','
          << (1.6e9 + time(i) - text.timeOffset) / text.timeUnit << '\n';
    }
  }
  /** \param closing what follows t x y z in each line */
  static void writeTrajectory(const std::string& path, const std::string& closing,
                              char separator = ' ', double unit = 1)
  {
    std::ofstream out(path);
    out.precision(17);
    for (int t = 0; t <= kPoints * kSpacing; ++t)
    {
      const auto at = sensor(t);
      out << 1.6e9 + t;
      for (const double value : {at.x, at.y, at.z}) out << separator << value / unit;
      for (const char c : closing) out << (c == ' ' ? separator : c);
      out << '\n';
    }
  }
};

}  // namespace mrpt_mapconv::testing
