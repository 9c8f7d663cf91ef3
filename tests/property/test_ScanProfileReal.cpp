// The inverse sensor model against its brute-force twin where nothing is arranged: real scans, and
// sensors on the border or in the middle of a cell, as at the start of most logs. The twin reports
// ties there (lines that pass a corner closely); these scans agree cell by cell all the same.
#include <gtest/gtest.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <filesystem>
#include <limits>
#include <random>
#include <string>

#include "RandomScan.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt::poses::CPose3D;

void expectAgreement(const RandomScan& scan)
{
  const auto expected =
      oracle::ScanOracle(scan.points, scan.view, scan.resolution, scan.params).profile();
  scan::ScanProfile profile;
  profile.compute(scan.points, scan.view, scan.resolution, scan.params);
  EXPECT_GT(expected.occupied.size(), 50u);
  EXPECT_GT(expected.free.size(), 200u);
  EXPECT_TRUE(keysOf(profile.occupied()) == expected.occupied) << scan.text();
  EXPECT_TRUE(keysOf(profile.free()) == expected.free) << scan.text();
  EXPECT_EQ(profile.statistics().lines, expected.lines);
  EXPECT_EQ(profile.statistics().linesWithWall, expected.linesWithWall);
}

RandomScan roomScan()
{
  RandomScan scan;
  scan.resolution = 0.05;
  scan.params.structureMinZ = 2;
  scan.params.structureMaxZ = 2.8;
  return scan;
}
}  // namespace

TEST(ScanProfile, AgreesWithTheOracleOnRealScans)
{
  const std::string log = std::string(MRPT_MAPCONV_SHARED_DIR) + "/vlp16_3scans.rawlog";
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "there is no " << log;
  for (const auto& posed : observation::readRawlog(log, {true}))
    for (const bool filter : {true, false})
    {
      RandomScan scan = roomScan();
      const auto seen = observation::sensorPoints(*posed.observation, posed.robotPose);
      ASSERT_TRUE(seen);
      scan.points = seen->points;
      scan.view.sensorPose = seen->sensorPose;
      scan.params.objectMaxZ = 2;  // the sensor is 1.8 m above the floor
      scan.params.reflectionFilter = filter;
      expectAgreement(scan);
    }
}

TEST(ScanProfile, AgreesWithTheOracleFromTheBorderAndTheMiddleOfACell)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> along(-3.96f, 3.96f), height(0.1f, 1.4f), up(2.05f, 2.7f);
  for (const double offset : {0.0, 0.025})
  {
    RandomScan scan = roomScan();
    scan.view.sensorPose = CPose3D(offset, offset, 1, 0, 0, 0);
    const auto add = [&](float x, float y, float z)
    {
      scan.points.emplace_back(x - static_cast<float>(offset), y - static_cast<float>(offset),
                               z - 1);
    };
    for (int i = 0; i < 500; ++i)  // a square room of 8 m, and something beyond its walls
    {
      const float a = along(random), b = along(random), wall = 3.97f + 0.03f * (b - a) / 8;
      for (const auto& [x, y] : {std::pair{a, wall}, {a, -wall}, {wall, a}, {-wall, a}})
      {
        add(x, y, height(random));
        add(x, y, up(random));
      }
      add(0.4f * a + 0.013f, 0.3f * b - 1.517f, height(random));
      add(1.7f * a + 0.007f, 6.013f + 0.2f * b, height(random));
    }
    // points that would say something if they were taken for any
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinite, -infinite})
      for (const auto& point : {mrpt::math::TPoint3Df(bad, 1, 0), {1, bad, 0}, {1, 1, bad}})
        scan.points.push_back(point);
    for (const bool filter : {true, false})
    {
      scan.params.reflectionFilter = filter;
      RandomScan clean = scan;
      clean.points.resize(clean.points.size() - 9);
      expectAgreement(clean);
      scan::ScanProfile with, without;
      with.compute(scan.points, scan.view, scan.resolution, scan.params);
      without.compute(clean.points, scan.view, scan.resolution, scan.params);
      EXPECT_TRUE(keysOf(with.occupied()) == keysOf(without.occupied()));
      EXPECT_TRUE(keysOf(with.free()) == keysOf(without.free()));
    }
  }
}
