// What bad input gets, section 6.
#include <functional>
#include <limits>
#include <stdexcept>

#include "HandScan.h"
#include "support/ThrownMessage.h"

namespace
{
using namespace mrpt_mapconv;
using scan::UnusableScan;
using test::HandScan;
using test::thrownMessage;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

HandScan goodScan() { return HandScan({"..w....", "S..o..b", ".o....."}); }

/** The number of cells that a profile says something about. */
std::size_t knownCells(const scan::ScanProfile& profile)
{
  return profile.occupied().count() + profile.free().count();
}

TEST(ScanProfileInput, EmptyScanSaysNothing)
{
  scan::ScanProfile profile = goodScan().compute();
  EXPECT_GT(knownCells(profile), 0u);
  const HandScan empty({"S.."});
  profile.compute({}, empty.view, 1.0, empty.params);
  EXPECT_EQ(knownCells(profile), 0u);
  EXPECT_TRUE(profile.bounds().empty());
  EXPECT_EQ(profile.statistics().points, 0u);
  EXPECT_EQ(profile.statistics().linesWithWall, 0);
}

TEST(ScanProfileInput, PointsThatAreNotFiniteAreLeftOut)
{
  const HandScan scan = goodScan();
  const auto good = scan.points();
  auto points = good;
  for (const float bad : {kNaN, kInfinity, -kInfinity})
    for (const auto& point :
         {mrpt::math::TPoint3Df(bad, 1, 0), mrpt::math::TPoint3Df(1, bad, 0),
          mrpt::math::TPoint3Df(1, 1, bad), mrpt::math::TPoint3Df(bad, bad, 1.5),
          mrpt::math::TPoint3Df(bad, bad, bad)})
    {
      points.insert(points.begin(), point);
      points.push_back(point);
    }
  scan::ScanProfile profile, expected;
  for (const auto& pose : {scan.view.sensorPose, mrpt::poses::CPose3D(0.5, 0.5, 1, 0.3, 0.2, -0.1)})
  {
    scan::Viewpoint view = scan.view;
    view.sensorPose = pose;
    expected.compute(good, view, 1.0, scan.params);
    profile.compute(points, view, 1.0, scan.params);
    EXPECT_EQ(profile.statistics().objectPoints, expected.statistics().objectPoints);
    EXPECT_EQ(profile.statistics().structurePoints, expected.statistics().structurePoints);
    EXPECT_EQ(profile.statistics().occupiedCells, expected.statistics().occupiedCells);
    EXPECT_EQ(profile.statistics().freeCells, expected.statistics().freeCells);
    EXPECT_EQ(profile.statistics().linesWithWall, expected.statistics().linesWithWall);
    EXPECT_TRUE(profile.bounds() == expected.bounds());
  }
}

TEST(ScanProfileInput, AScanOfNothingFiniteSaysNothing)
{
  const HandScan scan({"S.."});
  scan::ScanProfile profile;
  profile.compute(std::vector<mrpt::math::TPoint3Df>(100, {kNaN, kNaN, kNaN}), scan.view, 1.0,
                  scan.params);
  EXPECT_EQ(knownCells(profile), 0u);
}

TEST(ScanProfileInput, PointsAsFarAsFloatsReachAreOutOfRange)
{
  const HandScan scan = goodScan();
  const auto expected = scan.profile();
  HandScan far = scan;
  for (const double x : {3e9, 1e15, 3e38, -3e38})
    for (const double z : {HandScan::kObjectHeight, HandScan::kStructureHeight})
      far.point(x, 0.5, z).point(0.5, x, z).point(x, -x, z);
  EXPECT_EQ(far.profile(), expected);
}

TEST(ScanProfileInput, PointsAtTheSensorAreTooNear)
{
  HandScan scan({"S..o"});
  for (int i = 0; i < 10; ++i) scan.object(0.5, 0.5);
  EXPECT_EQ(scan.row(), "...#");
  scan::ScanProfile profile;
  profile.compute(std::vector<mrpt::math::TPoint3Df>(10, {0, 0, 0}), scan.view, 1.0, scan.params);
  EXPECT_EQ(knownCells(profile), 0u);
}

TEST(ScanProfileInput, APointAtTheSensorIsNoWallEither)
{
  HandScan scan({"S..o"});
  scan.sensor(0.5, 0.5, HandScan::kStructureHeight);  // within the structure slice
  scan.point(0.5, 0.5, HandScan::kStructureHeight);
  EXPECT_EQ(scan.row(), "...#");
  scan.point(0.5, 0.5, HandScan::kStructureHeight + 0.125);  // what is above it is one
  EXPECT_EQ(scan.row(), "????");
}

TEST(ScanProfileInput, SensorBelowTheSlicesIsRefusedOneAboveThemIsNot)
{
  const auto compute = [](double z, bool filter)
  {
    HandScan scan({"S..o"});
    scan.params.reflectionFilter = filter;
    if (!filter)
      scan.params.structureMinZ = scan.params.structureMaxZ = scan::ProfileParams::kUnset;
    scan.view.baseZ = 1;
    scan.sensor(0.5, 0.5, 1 + z).compute();
  };
  EXPECT_NO_THROW(compute(0.0625, true));
  EXPECT_NO_THROW(compute(2.6875, true)) << "between the slices' ends";
  for (const double z : {1.4375, 1.53125, 2.5, 2.78125, 20.0})  // on a car's roof
    for (const bool filter : {true, false}) EXPECT_NO_THROW(compute(z, filter)) << z;
  for (const double z : {0.03125, -0.5})
    for (const bool filter : {true, false}) EXPECT_THROW(compute(z, filter), UnusableScan) << z;
  const std::string message = thrownMessage<UnusableScan>([&] { compute(-0.5, true); });
  EXPECT_NE(message.find("-0.5 m above the robot's base"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(ScanProfileInput, SensorBetweenTheSlicesIsGoodWhetherTheFilterIsOnOrOff)
{
  // objects end at 1.5 m, the structure begins at 2.25 m
  for (const double z : {2.0, 5.0})  // and above them
  {
    HandScan scan({"S..o"});
    EXPECT_EQ(scan.sensor(0.5, 0.5, z).row(), "...#");
    scan.params.reflectionFilter = false;
    EXPECT_EQ(scan.row(), "...#");
  }
}

TEST(ScanProfileInput, PoseThatIsNotFiniteIsRefused)
{
  for (int part = 0; part < 3; ++part)
    for (const double bad : {kNoNumber, HUGE_VAL, -HUGE_VAL})
    {
      double at[3] = {0.5, 0.5, 1};
      at[part] = bad;
      HandScan scan({"S..o"});
      const auto points = scan.points();
      scan.sensor(at[0], at[1], at[2]);
      scan::ScanProfile profile;
      EXPECT_THROW(profile.compute(points, scan.view, 1.0, scan.params), UnusableScan)
          << "part " << part << ": " << bad;
    }
  for (int part = 0; part < 3; ++part)
  {
    double angle[3] = {0, 0, 0};
    angle[part] = kNoNumber;
    HandScan scan({"S..o"});
    const auto points = scan.points();
    scan.view.sensorPose = mrpt::poses::CPose3D(0.5, 0.5, 1, angle[0], angle[1], angle[2]);
    scan::ScanProfile profile;
    EXPECT_THROW(profile.compute(points, scan.view, 1.0, scan.params), UnusableScan)
        << "angle " << part;
  }
  HandScan scan({"S..o"});
  scan.view.baseZ = kNoNumber;
  EXPECT_THROW(scan.compute(), UnusableScan);
}

TEST(ScanProfileInput, SensorTooFarFromTheOriginIsRefused)
{
  for (const double x : {1.1e9, -1.1e9, 1e300})
  {
    HandScan scan({"S..o"});
    const auto points = scan.points();
    scan::ScanProfile profile;
    EXPECT_THROW(profile.compute(points, scan.sensor(x, 0).view, 1.0, scan.params), UnusableScan);
    EXPECT_THROW(profile.compute(points, scan.sensor(0, x).view, 1.0, scan.params), UnusableScan);
  }
}

TEST(ScanProfileInput, BadParametersAreRefused)
{
  const auto message = [](const std::function<void(scan::ProfileParams&)>& set)
  {
    HandScan scan({"S..o"});
    set(scan.params);
    return thrownMessage<std::invalid_argument>([&] { scan.compute(); });
  };
  test::expectNames(message([](auto& p) { p.objectMaxZ = 0.03125; }), "objectMaxZ", "0.03125");
  test::expectNames(message([](auto& p) { p.structureMaxZ = 2.125; }), "structureMaxZ", "2.125");
  test::expectNames(message([](auto& p) { p.maxRange = -3; }), "maxRange", "-3");
  test::expectNames(message([](auto& p) { p.minRange = 25; }), "minRange", "25");
  EXPECT_TRUE(
      test::holdsWord(message([](auto& p) { p.structureMinZ = kNoNumber; }), "structureMinZ"));
}

TEST(ScanProfileInput, BadResolutionIsRefused)
{
  const HandScan scan({"S..o"});
  for (const double resolution : {0.0, -0.5, kNoNumber, HUGE_VAL})
  {
    scan::ScanProfile profile;
    const std::string message = thrownMessage<std::invalid_argument>(
        [&] { profile.compute(scan.points(), scan.view, resolution, scan.params); });
    EXPECT_TRUE(test::holdsWord(message, "resolution")) << message;
  }
}

TEST(ScanProfileInput, WorksOnAfterAScanThatWasRefused)
{
  const HandScan good = goodScan();
  scan::ScanProfile profile = good.compute(), expected = good.compute();
  HandScan bad = goodScan();
  bad.view.baseZ = kNoNumber;
  EXPECT_THROW(profile.compute(good.points(), bad.view, 1.0, bad.params), UnusableScan);
  profile.compute(good.points(), good.view, 1.0, good.params);
  EXPECT_EQ(profile.occupied().count(), expected.occupied().count());
  EXPECT_EQ(profile.free().count(), expected.free().count());
  EXPECT_TRUE(profile.bounds() == expected.bounds());
}

}  // namespace
