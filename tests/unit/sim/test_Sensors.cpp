#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/sim/Sensors.h>

#include <map>

#include "RoomFixtures.h"

using namespace mrpt_mapconv::sim::fixtures;
using mrpt::DEG2RAD;
using mrpt::config::CConfigFileMemory;
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;
using mrpt::poses::CPose3D;
using mrpt_mapconv::params::StrictSection;
using mrpt_mapconv::sim::RayCaster;
using mrpt_mapconv::sim::Scan;
using mrpt_mapconv::sim::Sensor;
using mrpt_mapconv::sim::World;
using mrpt_mapconv::testing::contains;
using mrpt_mapconv::testing::messageOf;

namespace
{
std::unique_ptr<Sensor> sensorOf(const std::string& text)
{
  const CConfigFileMemory ini(text);
  std::vector<std::string> sections;
  ini.getAllSections(sections);
  StrictSection section(ini, sections.at(0));
  return mrpt_mapconv::sim::readSensor(section);
}

World room() { return World::fromIni(CConfigFileMemory(kRoom), {}); }

const CPose3D kRobot(1, -1.5, 0.1, DEG2RAD(37.0), DEG2RAD(4.0), DEG2RAD(-6.0));

std::vector<TPoint3D> pointsInMap(const Scan& scan, const CPose3D& robot)
{
  const auto seen = mrpt_mapconv::observation::sensorPoints(*scan.observation, robot);
  std::vector<TPoint3D> points;
  for (const auto& p : seen->points) points.push_back(seen->sensorPose.composePoint(TPoint3D(p)));
  return points;
}

/** Every ray returns, from where the closed form says that the room is. */
void expectSeesRoom(const std::string& text)
{
  const World world = room();
  const RayCaster caster(world);
  const auto sensor = sensorOf(text);
  const Scan scan = sensor->scan(caster, kRobot, 1);
  const auto points = pointsInMap(scan, kRobot);
  ASSERT_EQ(points.size(), sensor->rays());
  ASSERT_EQ(scan.truePoints.size(), points.size());
  const TPoint3D origin = (kRobot + sensor->params().pose).translation();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const TPoint3D ray = points[i] - origin;
    EXPECT_NEAR(ray.norm(), rangeInRoom(origin, ray.unitarize()), 1e-4) << "ray " << i;
    EXPECT_LT((TPoint3D(scan.truePoints[i]) - points[i]).norm(), 1.5e-4) << "ray " << i;
  }
}
}  // namespace

TEST(Sensors, LidarSeesTheRoom) { expectSeesRoom(kLidar); }
TEST(Sensors, DepthCameraSeesTheRoom) { expectSeesRoom(kCamera + "minRange = 0"); }
TEST(Sensors, Scanner2DSeesTheRoom) { expectSeesRoom(kScanner); }

TEST(Sensors, LidarRaysGoWhereTheirAnglesSay)
{
  const World world = room();
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.l]\nkind = lidar\nelevations = -45 0 30\nazimuthSteps = 4\nrate = 1\nmaxRange = 20");
  const CPose3D robot(0, 0, 1, 0, 0, 0);
  const auto points = pointsInMap(sensor->scan(caster, robot, 1), robot);
  ASSERT_EQ(points.size(), 12u);
  // ahead: floor at 1 m, wall at 5 m, roof 2 m higher at 2/tan(30°)
  EXPECT_LT((points[0] - TPoint3D(1, 0, 0)).norm(), 1e-5);
  EXPECT_LT((points[1] - TPoint3D(5, 0, 1)).norm(), 1e-5);
  EXPECT_LT((points[2] - TPoint3D(2 * std::sqrt(3.0), 0, 3)).norm(), 1e-5);
  EXPECT_LT((points[4] - TPoint3D(0, 4, 1)).norm(), 1e-5);   // to the left
  EXPECT_LT((points[7] - TPoint3D(-5, 0, 1)).norm(), 1e-5);  // behind
  EXPECT_LT((points[10] - TPoint3D(0, -4, 1)).norm(), 1e-5);
}

TEST(Sensors, Scanner2DHasMrptsLayout)
{
  const World world = room();
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.front]\nkind = scanner2D\npose = 0 0 0.4 0 0 0\nfieldOfView = 180\nrays = 3\n"
      "rate = 1\nmaxRange = 4.5\nrangeNoise = 0");
  const auto scan = sensor->scan(caster, CPose3D(), 1);
  const auto obs = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(scan.observation);
  ASSERT_TRUE(obs);
  EXPECT_FALSE(scan.is3D);
  EXPECT_EQ(obs->sensorLabel, "front");
  EXPECT_NEAR(obs->aperture, M_PI, 1e-6);
  EXPECT_EQ(obs->sensorPose, CPose3D(0, 0, 0.4, 0, 0, 0));
  ASSERT_EQ(obs->getScanSize(), 3u);
  EXPECT_NEAR(obs->getScanRange(0), 4, 1e-5);
  EXPECT_NEAR(obs->getScanRange(2), 4, 1e-5);
  EXPECT_TRUE(obs->getScanRangeValidity(0));
  EXPECT_FALSE(obs->getScanRangeValidity(1)) << "the wall ahead is at 5 m, too far";
  EXPECT_FLOAT_EQ(obs->getScanRange(1), 4.5f);
}

TEST(Sensors, DepthCameraWritesDepthsAlongItsAxis)
{
  const World world = room();
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.c]\nkind = depthCamera\npose = 3 0 1.5 0 0 0\nwidth = 21\nheight = 11\n"
      "fieldOfView = 60\nrate = 1\nmaxRange = 6");
  const auto scan = sensor->scan(caster, CPose3D(), 1);
  const auto obs = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(scan.observation);
  ASSERT_TRUE(obs);
  EXPECT_TRUE(obs->range_is_depth);
  for (int row = 0; row < 11; ++row)
    for (int column = 0; column < 21; ++column)
      EXPECT_NEAR(obs->rangeImage(row, column) * obs->rangeUnits, 2, 1e-4);  // all on the wall
}

TEST(Sensors, RangesEndAtTheLimits)
{
  const World world = room();
  const RayCaster caster(world);
  const std::string head = "[sensor.l]\nkind = lidar\nelevations = 0\nazimuthSteps = 4\nrate = 1\n";
  const CPose3D robot(0, 0, 1, 0, 0, 0);  // walls at 5, 4, 5 and 4 m
  EXPECT_EQ(pointsInMap(sensorOf(head + "maxRange = 4.9")->scan(caster, robot, 1), robot).size(),
            2u);
  const auto far = sensorOf(head + "maxRange = 20\nminRange = 4.2")->scan(caster, robot, 1);
  for (const auto& p : pointsInMap(far, robot)) EXPECT_GE(p.norm(), 4.2);
}

TEST(Sensors, NoiseAndMissingReturnsAreAsAskedFor)
{
  const World world = room();
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.l]\nkind = lidar\nelevations = -40 -20 0 20 40\nazimuthSteps = 4000\nrate = 1\n"
      "maxRange = 20\nrangeNoise = 0.03\ndropout = 0.2");
  const CPose3D robot(0.5, 0.5, 1.2, 0, 0, 0);
  const Scan scan = sensor->scan(caster, robot, 12345);
  const auto points = pointsInMap(scan, robot);
  ASSERT_EQ(points.size(), scan.truePoints.size());
  const double rays = 20000;
  EXPECT_NEAR(static_cast<double>(points.size()) / rays, 0.8, 4 * std::sqrt(0.2 * 0.8 / rays));
  std::vector<double> errors, products;
  const TPoint3D origin = robot.translation();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    errors.push_back((points[i] - origin).norm() - (TPoint3D(scan.truePoints[i]) - origin).norm());
    EXPECT_LT(offRoom(TPoint3D(scan.truePoints[i])), 1e-4);
    if (i > 0) products.push_back(errors[i] * errors[i - 1] / (0.03 * 0.03));
  }
  expectNormal(errors, 0.03, "range noise, key 12345");
  // neighbours are not correlated: their products have mean 0 and standard deviation 1
  EXPECT_NEAR(statisticsOf(products).mean, 0, 4 / std::sqrt(16000.0));
}

TEST(Sensors, TheKeyDecidesWhatIsRandom)
{
  const World world = room();
  const RayCaster caster(world);
  const auto sensor = sensorOf(kLidar + "rangeNoise = 0.02\ndropout = 0.1");
  const auto bytes = [&](std::uint64_t key)
  {
    std::vector<std::uint8_t> out;
    mrpt::serialization::ObjectToOctetVector(sensor->scan(caster, kRobot, key).observation.get(),
                                             out);
    return out;
  };
  EXPECT_EQ(bytes(7), bytes(7));
  EXPECT_NE(bytes(7), bytes(8));
}

// Three of ten rays end on the pane, all on the face towards the sensor.
TEST(Sensors, LooksThroughGlass)
{
  const World world = World::fromIni(
      CConfigFileMemory(kRoom + "[pane.window]\nfrom = 2 -3.9\nto = 2 3.9\nbottom = 0\ntop = 3\n"
                                "thickness = 0.02\ntransparency = 0.7\n"),
      {});
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.s]\nkind = scanner2D\nfieldOfView = 20\nrays = 10000\nrate = 1\nmaxRange = 20");
  for (const CPose3D& robot : {CPose3D(0, 0, 1, 0, 0, 0), CPose3D(0.5, -1, 1, 0.4, 0, 0)})
  {
    std::map<long, double> shares;  // by x [mm]
    for (const auto& p : sensor->scan(caster, robot, 99).truePoints)
      shares[std::lround(p.x * 1000)] += 1e-4;
    ASSERT_EQ(shares.size(), 2u);
    EXPECT_NEAR(shares[1990], 0.3, 4 * 0.0046) << "key 99";
    EXPECT_NEAR(shares[5000], 0.7, 4 * 0.0046) << "key 99";
  }
}

// Each of two panes by itself: 0.5, then a half of the rest.
TEST(Sensors, EachPaneIsDecidedByItself)
{
  std::string text = kRoom;
  for (const std::string x : {"2", "3"})
    text += "[pane.p" + x + "]\nfrom = " + x + " -3.9\nto = " + x +
            " 3.9\nbottom = 0\ntop = 3\nthickness = 0.02\ntransparency = 0.5\n";
  const World world = World::fromIni(CConfigFileMemory(text), {});
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.s]\nkind = scanner2D\nfieldOfView = 20\nrays = 10000\nrate = 1\nmaxRange = 20");
  std::map<long, double> shares;  // by x [mm]
  for (const auto& p : sensor->scan(caster, CPose3D(0, 0, 1, 0, 0, 0), 5).truePoints)
    shares[std::lround(p.x * 1000)] += 1e-4;
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_NEAR(shares[1990], 0.5, 4 * 0.005) << "key 5";
  EXPECT_NEAR(shares[2990], 0.25, 4 * 0.0044) << "key 5";
  EXPECT_NEAR(shares[5000], 0.25, 4 * 0.0044) << "key 5";
}

// Of ten perfectly clear panes a ray passes eight.
TEST(Sensors, LooksThroughEightPanesAtMost)
{
  std::string text = kRoom;
  for (int i = 1; i <= 10; ++i)
  {
    const auto x = std::to_string(i * 0.4);
    text += "[pane.p" + std::to_string(i) + "]\nfrom = " + x + " -3\nto = " + x +
            " 3\nbottom = 0\ntop = 3\nthickness = 0.1\ntransparency = 1\n";
  }
  const World world = World::fromIni(CConfigFileMemory(text), {});
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.l]\nkind = lidar\nelevations = 0\nazimuthSteps = 2\nrate = 1\nmaxRange = 20");
  const auto scan = sensor->scan(caster, CPose3D(0, 0, 1, 0, 0, 0), 1);
  ASSERT_EQ(scan.truePoints.size(), 2u);
  EXPECT_NEAR(scan.truePoints[0].x, 3.55, 1e-4);  // the ninth's near face
  EXPECT_NEAR(scan.truePoints[1].x, -5, 1e-4);
}

// At 9000 m the next number of single precision is 1 mm away.
TEST(Sensors, LooksThroughGlassThatIsFar)
{
  const World world = World::fromIni(
      CConfigFileMemory("[world]\nbounds = -1 -9 -9 9999 9 9\n[pane.p]\nfrom = 9000 -9\n"
                        "to = 9000 9\nbottom = -9\ntop = 9\ntransparency = 1\n"
                        "[box.wall]\nmin = 9500 -9 -9\nmax = 9501 9 9\n"),
      {});
  const RayCaster caster(world);
  const auto sensor = sensorOf(
      "[sensor.l]\nkind = lidar\nelevations = 0\nazimuthSteps = 2\nrate = 1\nmaxRange = 10000");
  const auto scan = sensor->scan(caster, CPose3D(), 1);
  ASSERT_EQ(scan.truePoints.size(), 1u);
  EXPECT_NEAR(scan.truePoints[0].x, 9500, 0.01);
}

namespace
{
/** A room with panes 0.1 m around (0, 0), 3 m high. */
World cabin(const std::string& transparency)
{
  std::string text = kRoom;
  const std::pair<std::string, std::string> ends[] = {
      {"0.11 -0.12", "0.11 0.12"},
      {"-0.11 -0.12", "-0.11 0.12"},
      {"-0.12 0.11", "0.12 0.11"},
      {"-0.12 -0.11", "0.12 -0.11"},
  };
  for (const auto& [from, to] : ends)
    text += "[pane.p" + std::to_string(text.size()) + "]\nfrom = " + from + "\nto = " + to +
            "\nbottom = 0\ntop = 3\nthickness = 0.02\ntransparency = " + transparency + "\n";
  return World::fromIni(CConfigFileMemory(text), {});
}
}  // namespace

TEST(Sensors, WhatIsNearerThanMinRangeHidesTheRest)
{
  const World opaque = cabin("0"), clear = cabin("1"), half = cabin("0.5");
  const CPose3D robot(0, 0, 1.5, 0, 0, 0);
  for (const std::string noise : {"0", "0.2"})
  {
    const auto sensor = sensorOf(
        "[sensor.l]\nkind = lidar\nelevations = -20 0 20\nazimuthSteps = 4000\nrate = 1\n"
        "maxRange = 20\nminRange = 0.3\nrangeNoise = " +
        noise);
    const auto returns = [&](const World& world)
    {
      const RayCaster caster(world);
      const auto scan = sensor->scan(caster, robot, 3);
      EXPECT_EQ(pointsInMap(scan, robot).size(), scan.truePoints.size());
      for (const auto& p : scan.truePoints) EXPECT_LT(offRoom(TPoint3D(p)), 1e-4);
      return static_cast<double>(scan.truePoints.size());
    };
    EXPECT_EQ(returns(opaque), 0) << "noise " << noise;
    EXPECT_EQ(returns(clear), 12000) << "noise " << noise;
    // a few rays lead through the corner, where two panes overlap
    EXPECT_GT(returns(half), 6000 - 4 * 55 - 12000 * 0.1) << "noise " << noise;
    EXPECT_LT(returns(half), 6000 + 4 * 55) << "noise " << noise;
  }
}

TEST(Sensors, ObservationsSurviveBeingStored)
{
  const World world = room();
  const RayCaster caster(world);
  for (const auto& text : {kLidar, kCamera, kScanner})
  {
    Scan scan = sensorOf(text)->scan(caster, kRobot, 1);
    std::vector<std::uint8_t> bytes;
    mrpt::serialization::ObjectToOctetVector(scan.observation.get(), bytes);
    mrpt::serialization::CSerializable::Ptr back;
    mrpt::serialization::OctetVectorToObject(bytes, back);
    Scan stored = scan;
    stored.observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(back);
    ASSERT_TRUE(stored.observation) << text;
    EXPECT_EQ(stored.observation->sensorLabel, scan.observation->sensorLabel);
    EXPECT_EQ(pointsInMap(stored, kRobot), pointsInMap(scan, kRobot)) << text;
  }
}

TEST(Sensors, NamesWhatIsWrong)
{
  const std::string base = "[sensor.s]\nrate = 1\nmaxRange = 10\n";
  const std::string lidar = base + "kind = lidar\nazimuthSteps = 8\n";
  const std::string camera = base + "kind = depthCamera\nwidth = 8\nheight = 8\n";
  const std::vector<std::pair<std::string, std::string>> bad{
      {base, "kind = '' is not valid: it must be lidar or depthCamera or scanner2D"},
      {base + "kind = sonar", "kind = 'sonar'"},
      {lidar, "beams = ''"},
      {lidar + "elevations = 0 95", "elevations = '0 95'"},
      {lidar + "elevations = 0 5\nbeams = 3", "beams = '3'"},
      {lidar + "beams = 3\nelevationMin = 10\nelevationMax = 5", "elevationMax = '5'"},
      {lidar + "elevations = 0\nwidth = 5", "'width' is not a key of a lidar"},
      {lidar + "elevations = 0\npose = 1 2 3", "pose = '1 2 3'"},
      {lidar + "elevations = 0\nrangeNoise = -1", "rangeNoise = '-1'"},
      {lidar + "elevations = 0\ndropout = 1.5",
       "dropout = '1.5' is not valid: it must be a number from 0 to below 1"},
      {lidar + "elevations = 0\ndropout = 1", "dropout = '1' is not valid"},
      {lidar + "elevations = 0\ndropout = -0.1", "dropout = '-0.1' is not valid"},
      {lidar + "elevations = 0\nminRange = 11", "minRange = '11'"},
      {"[sensor.s]\nkind = lidar\nmaxRange = 5", "rate = ''"},
      {"[sensor.s]\nkind = lidar\nrate = 5\nmaxRange = -2", "maxRange = '-2'"},
      {camera + "fieldOfView = 180", "fieldOfView = '180'"},
      {camera, "fieldOfView = ''"},
      {base + "kind = scanner2D\nfieldOfView = 270\nrays = 1", "rays = '1'"},
  };
  for (const auto& [text, part] : bad)
  {
    const auto message = messageOf([&, t = text] { sensorOf(t); });
    EXPECT_TRUE(contains(message, "section 'sensor.s': ")) << message;
    EXPECT_TRUE(contains(message, part)) << message << "\nfor:\n" << text;
    EXPECT_FALSE(contains(message, "\n")) << message;
  }
}
