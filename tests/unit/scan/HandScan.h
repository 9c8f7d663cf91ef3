#pragma once

#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <cmath>
#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
/** A scan drawn in cells of 1 m, north up; the south-west cell has the key (0, 0).
 *
 * 'S' is the sensor's cell, 'o' holds a point of an object, 'w' one of the structure, 'b' both; the
 * points and the sensor are in the middle of their cells. Heights: base 0 m, sensor and objects
 * 1 m, structure 2.5 m. Four lines unless the parameters say otherwise. */
class HandScan
{
 public:
  explicit HandScan(const std::vector<std::string>& northUp)
      : m_width(static_cast<int>(northUp.front().size())),
        m_height(static_cast<int>(northUp.size()))
  {
    params.sectors = 4;
    params.structureMinZ = 2.25;
    params.structureMaxZ = 2.75;
    for (int ky = 0; ky < m_height; ++ky)
      for (int kx = 0; kx < m_width; ++kx)
        draw(kx, ky,
             northUp.at(static_cast<std::size_t>(m_height - 1 - ky))
                 .at(static_cast<std::size_t>(kx)));
  }

  scan::ProfileParams params;
  scan::Viewpoint view;

  /** Moves the sensor to a place in the map [m]. */
  HandScan& sensor(double x, double y, double z = kSensorHeight)
  {
    view.sensorPose = mrpt::poses::CPose3D(x, y, z, 0, 0, 0);
    return *this;
  }
  /** A point of the map [m]. */
  HandScan& point(double x, double y, double z)
  {
    m_points.emplace_back(x, y, z);
    return *this;
  }
  HandScan& object(double x, double y) { return point(x, y, kObjectHeight); }
  HandScan& structure(double x, double y) { return point(x, y, kStructureHeight); }

  /** The points as the sensor gives them. */
  std::vector<mrpt::math::TPoint3Df> points() const
  {
    std::vector<mrpt::math::TPoint3Df> result;
    for (const auto& inMap : m_points)
      result.emplace_back(view.sensorPose.inverseComposePoint(inMap));
    return result;
  }
  scan::ScanProfile compute() const
  {
    scan::ScanProfile profile;
    profile.compute(points(), view, 1.0, params);
    return profile;
  }
  /** Drawn likewise: '#' is an occupied cell, '.' a free one, '?' one that nothing is said about.
   * All cells that something is said about must be on the drawing. */
  std::vector<std::string> profile() const
  {
    const scan::ScanProfile profile = compute();
    std::vector<std::string> northUp;
    std::size_t known = 0;
    for (int ky = m_height - 1; ky >= 0; --ky)
    {
      northUp.emplace_back();
      for (int kx = 0; kx < m_width; ++kx)
      {
        const bool occupied = profile.occupied().containsKey(kx, ky);
        const bool free = profile.free().containsKey(kx, ky);
        EXPECT_FALSE(occupied && free) << "cell (" << kx << ", " << ky << ")";
        northUp.back() += occupied ? '#' : free ? '.' : '?';
        known += occupied || free ? 1 : 0;
      }
    }
    EXPECT_EQ(profile.occupied().count() + profile.free().count(), known) << "beside the drawing";
    return northUp;
  }
  /** A drawing of one row. */
  std::string row() const { return profile().at(0); }

  static constexpr double kSensorHeight = 1, kObjectHeight = 1, kStructureHeight = 2.5;

 private:
  void draw(int kx, int ky, char c)
  {
    const double x = kx + 0.5, y = ky + 0.5;
    if (c == 'S') sensor(x, y);
    if (c == 'o' || c == 'b') object(x, y);
    if (c == 'w' || c == 'b') structure(x, y);
  }

  int m_width, m_height;
  std::vector<mrpt::math::TPoint3D> m_points;
};

using Drawing = std::vector<std::string>;

constexpr double radians(double degrees) { return degrees * 3.14159265358979323846 / 180; }

}  // namespace mrpt_mapconv::test
