#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/terrain/ScanInsertion.h>

#include "support/ThrownMessage.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::terrain;
using mrpt::poses::CPose3D;

namespace
{
/** A sensor that looks down from 1 m above a robot at (10, 20, 5), turned by 90 degrees. */
observation::SensorPoints scanOf(const std::vector<mrpt::math::TPoint3Df>& points)
{
  observation::SensorPoints scan;
  scan.robotPose = CPose3D(10, 20, 5, mrpt::DEG2RAD(90.0), 0, 0);
  scan.sensorPose = scan.robotPose + CPose3D(0, 0, 1, 0, 0, 0);
  scan.points = points;
  return scan;
}

PointLimits limitsOf(double maxRange, double minHeight, double maxHeight)
{
  PointLimits limits;
  limits.maxRange = maxRange;
  limits.minHeight = minHeight;
  limits.maxHeight = maxHeight;
  return limits;
}
}  // namespace

TEST(ScanInsertion, KeepsThePointsWithinTheLimits)
{
  const auto scan = scanOf({{1, 0, -1}, {2, 0, -1}, {0, 3, -1.5f}, {0, 1, 1.5f}, {0, 9, 0}});
  EXPECT_EQ(usedPoints(scan, limitsOf(30, -100, 100)).points.size(), 5u);
  const auto used = usedPoints(scan, limitsOf(5, -0.1, 2));  // above the robot, not the sensor
  ASSERT_EQ(used.points.size(), 2u);
  EXPECT_EQ(used.points[0].x, 1);
  EXPECT_EQ(used.points[1].x, 2);
  EXPECT_EQ(used.leftOut, 3u);
  EXPECT_EQ(usedPoints(scan, limitsOf(1.5, -0.1, 2)).points.size(), 1u)
      << "range is from the sensor";
}

TEST(ScanInsertion, SaysWhichCellsTheyFallInto)
{
  const auto used = usedPoints(scanOf({{1, 0, -1}, {0, 2, -1}}), {});  // (10, 21) and (8, 20)
  const grid::GridFrame expected{0.5, 16, 40, 5, 3, -0.5};
  EXPECT_EQ(frameOf(used, TerrainMap(0.5)), expected);
  EXPECT_TRUE(frameOf({}, TerrainMap(0.5)).empty());
}

TEST(ScanInsertion, NamesAPlaceThatIsTooFarForKeys)
{
  auto scan = scanOf({{1, 0, -1}});
  scan.sensorPose.x(1e12);
  const auto message = test::thrownMessage<std::runtime_error>(
      [&] { frameOf(usedPoints(scan, {}), TerrainMap(0.5)); });
  EXPECT_NE(message.find("too far from the origin for cells of 0.5"), std::string::npos) << message;
}

TEST(ScanInsertion, InsertsThemWhereTheyAre)
{
  TerrainMap map(0.5);
  const auto scan = scanOf({{1, 0, -1}, {0, 2, -0.5f}, {0, 2, 5}});
  PointSigmas sigmas;
  const auto inserted =
      insertScan(map, scan, usedPoints(scan, {}), sigmas, sigmas.poseCovariance());
  EXPECT_EQ(inserted.inserted, 2u);
  ASSERT_TRUE(map.cell(20, 42));
  EXPECT_NEAR(map.cell(20, 42)->height, 5, 1e-4);
  ASSERT_TRUE(map.cell(16, 40));
  EXPECT_NEAR(map.cell(16, 40)->height, 5.5, 1e-4);
  EXPECT_EQ(map.cells(), 2u);
}

TEST(ScanInsertion, ASurerPoseGivesSurerHeights)
{
  const auto scan = scanOf({{1, 0, -1}});
  PointSigmas sigmas;
  sigmas.height = 0.5;
  const auto varianceWith = [&](const mrpt::math::CMatrixDouble33& covariance)
  {
    TerrainMap map(0.5);
    insertScan(map, scan, usedPoints(scan, {}), sigmas, covariance);
    return map.cell(20, 42)->variance;
  };
  EXPECT_GT(varianceWith(sigmas.poseCovariance()),
            100 * varianceWith(mrpt::math::CMatrixDouble33::Zero()));
}

TEST(PointLimits, RefuseWhatLeavesNothing)
{
  const auto message = [](const PointLimits& limits)
  { return test::thrownMessage<std::invalid_argument>([&] { limits.check(); }); };
  test::expectNames(message(limitsOf(0, -1, 1)), "maxRange", "0");
  test::expectNames(message(limitsOf(1, 2, 2)), "maxHeight", "2");
  test::expectNames(message(limitsOf(1, -INFINITY, 2)), "minHeight", "-inf");
  EXPECT_NO_THROW(PointLimits().check());
}

TEST(TerrainGridParams, SaysWhichLayersWouldBeTooLarge)
{
  TerrainGridParams params;
  params.maxGridCells = 100;
  EXPECT_NO_THROW(params.checkSize({0.1, 0, 0, 10, 10}));
  const auto message = test::thrownMessage<std::runtime_error>(
      [&] {
        params.checkSize({0.1, 0, 0, 101, 1});
      });
  test::expectNames(message, "maxGridCells", "100");
  test::expectNames(message, "101", "1");
}
