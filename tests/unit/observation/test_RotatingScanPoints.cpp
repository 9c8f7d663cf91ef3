#include <mrpt_mapconv/observation/RotatingScanPoints.h>

#include <cmath>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::observation
{
using mrpt::math::TPoint3Df;
using mrpt::obs::CObservationRotatingScan;

namespace
{
constexpr double kDeg = M_PI / 180;

CObservationRotatingScan scan(const std::string& model, int rows, int columns)
{
  CObservationRotatingScan out;
  out.lidarModel = model;
  out.rowCount = static_cast<std::uint16_t>(rows);
  out.columnCount = static_cast<std::uint16_t>(columns);
  out.rangeResolution = 0.002;
  out.rangeImage.setZero(rows, columns);
  return out;
}

std::vector<TPoint3Df> pointsOf(const CObservationRotatingScan& s)
{
  SensorPoints out;
  EXPECT_TRUE(rotatingScanPoints(s, out));
  return out.points;
}

void expectNear(const TPoint3Df& p, double x, double y, double z)
{
  EXPECT_NEAR(p.x, x, 1e-4);
  EXPECT_NEAR(p.y, y, 1e-4);
  EXPECT_NEAR(p.z, z, 1e-4);
}
}  // namespace

TEST(RotatingScanPoints, KnowsTheShippedModels)
{
  for (const char* name : {"VLP-16", "VLP16", "vlp_16"})
    EXPECT_EQ(shippedCalibration(name).laser_corrections.size(), 16u) << name;
  for (const char* name : {"HDL-32E", "HDL32"})
    EXPECT_EQ(shippedCalibration(name).laser_corrections.size(), 32u) << name;
  for (const char* name : {"", "Unknown", "VLP-16 Hi-Res", "OS1-16"})
    EXPECT_TRUE(shippedCalibration(name).empty()) << name;
}

TEST(RotatingScanPoints, FirstAndLastColumnLieOnTheSpansEnds)
{
  auto s = scan("VLP-16", 16, 3);
  s.startAzimuth = -M_PI / 2;
  s.azimuthSpan = M_PI;         // counter-clockwise, from right over ahead to left
  s.rangeImage(1, 0) = 1000;    // 2 m, 1° up
  s.rangeImage(0, 1) = 2000;    // 4 m, 15° down
  s.rangeImage(15, 2) = 3000;   // 6 m, 15° up
  s.rangeImage(15, 0) = 499;    // nearer than minRange = 1 m
  s.rangeImage(14, 0) = 65001;  // further than maxRange = 130 m
  const auto p = pointsOf(s);
  ASSERT_EQ(p.size(), 3u);
  expectNear(p[0], 4 * std::cos(15 * kDeg), 0, -4 * std::sin(15 * kDeg));
  expectNear(p[1], 0, -2 * std::cos(kDeg), 2 * std::sin(kDeg));
  expectNear(p[2], 0, 6 * std::cos(15 * kDeg), 6 * std::sin(15 * kDeg));
}

TEST(RotatingScanPoints, ClockwiseSpan)
{
  auto s = scan("VLP-16", 16, 5);
  s.startAzimuth = M_PI;
  s.azimuthSpan = -2 * M_PI;
  s.rangeImage(1, 1) = 1000;
  const auto p = pointsOf(s);
  ASSERT_EQ(p.size(), 1u);
  expectNear(p[0], 0, 2 * std::cos(kDeg), 2 * std::sin(kDeg));
}

TEST(RotatingScanPoints, OfMrptsFromVelodyneColumnsAreFewAndClockwise)
{
  // One packet: 384 columns, of which a VLP-16 fills 24; here they span 90° clockwise.
  auto s = scan("VLP-16", 16, 384);
  s.startAzimuth = 0;
  s.azimuthSpan = M_PI / 2;
  s.rangeImage(0, 16) = 1000;  // 2 m at 60° to the right, 15° down
  s.rangeImage(12, 8) = 1000;  // 2 m at 30° and half a column, since laser 12 of 24 fires later
  auto p = pointsOf(s);
  ASSERT_EQ(p.size(), 2u);
  const double level = 2 * std::cos(15 * kDeg);
  expectNear(p[0], level * std::cos(60 * kDeg), -level * std::sin(60 * kDeg),
             -2 * std::sin(15 * kDeg));
  const double azimuth = (30 + 0.5 * 90.0 / 24) * kDeg, up = 2 * std::cos(3 * kDeg);
  expectNear(p[1], up * std::cos(azimuth), -up * std::sin(azimuth), -2 * std::sin(3 * kDeg));

  // A return further right: such a scan follows the description.
  s.rangeImage(0, 383) = 1000;
  p = pointsOf(s);
  ASSERT_EQ(p.size(), 3u);
  expectNear(p[1], 0, level, -2 * std::sin(15 * kDeg));
}

TEST(RotatingScanPoints, OneRowNeedsNoModel)
{
  auto s = scan("2D_SCAN_", 1, 3);
  s.startAzimuth = 0;
  s.azimuthSpan = M_PI;
  s.rangeImage(0, 1) = 1000;
  s.rangeImage(0, 2) = 100;  // 0.2 m: a laser's minRange is not known
  const auto p = pointsOf(s);
  ASSERT_EQ(p.size(), 2u);
  expectNear(p[0], 0, 2, 0);
  expectNear(p[1], -0.2, 0, 0);
}

TEST(RotatingScanPoints, RowsMustFitTheModel)
{
  SensorPoints out;
  out.points = {{1, 2, 3}};
  EXPECT_FALSE(rotatingScanPoints(scan("VLP-16", 32, 8), out));
  EXPECT_TRUE(out.points.empty());
  EXPECT_FALSE(rotatingScanPoints(scan("Unknown", 16, 8), out));
  EXPECT_TRUE(rotatingScanPoints(CObservationRotatingScan(), out));
  EXPECT_TRUE(out.points.empty());
}

}  // namespace mrpt_mapconv::observation
