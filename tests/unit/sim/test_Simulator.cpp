#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/sim/Simulator.h>

#include <map>

#include "RoomFixtures.h"

using namespace mrpt_mapconv::sim::fixtures;
using mrpt_mapconv::sim::Moment;
using mrpt_mapconv::sim::Schedule;
using mrpt_mapconv::sim::Simulator;

namespace
{
std::string tinyScanner(const std::string& rate)
{
  return "[sensor.front]\nkind = scanner2D\npose = 0 0 1 0 0 0\nfieldOfView = 90\nrays = 2\n"
         "maxRange = 20\nrate = " +
         rate + "\n";
}

std::vector<Moment> all(const mrpt_mapconv::sim::Scenario& scenario, std::uint64_t seed)
{
  std::vector<Moment> moments;
  Simulator simulator(scenario, seed);
  while (auto moment = simulator.next()) moments.push_back(std::move(*moment));
  return moments;
}
}  // namespace

// 10 s: front at 10 Hz is due 101 times, lidar at 2 Hz 21 times, camera at 3 Hz 31 times. At whole
// seconds all three meet (11 times), at half seconds lidar and front (10 times); the other 20 times
// of the camera (k/3 s) are its own.
TEST(Schedule, SensorsAreDueAtMultiplesOfTheirPeriod)
{
  auto camera = kCamera;
  camera.replace(camera.find("rate = 1"), 8, "rate = 3");
  const auto scenario =
      load(kRoom + kScanner + kLidar + camera + kDrive + "[log]\nkeyFrameEvery=4");
  Schedule schedule(scenario);
  std::size_t slots = 0, keyFrames = 0;
  std::map<std::size_t, std::size_t> scans, together;
  std::int64_t last = -1;
  while (const auto slot = schedule.next())
  {
    ++slots;
    keyFrames += slot->keyFrame ? 1 : 0;
    ++together[slot->sensors.size()];
    for (std::size_t i = 0; i < slot->sensors.size(); ++i)
      EXPECT_EQ(slot->scanIndex[i], scans[slot->sensors[i]]++);
    EXPECT_GT(slot->ticks, last);
    last = slot->ticks;
  }
  EXPECT_EQ(last, 100'000'000);  // of 100 ns
  EXPECT_EQ(slots, 121u);
  EXPECT_EQ(scans[0], 31u);  // camera, front, lidar
  EXPECT_EQ(scans[1], 101u);
  EXPECT_EQ(scans[2], 21u);
  EXPECT_EQ(together[3], 11u);
  EXPECT_EQ(together[2], 10u);
  // a 3D sensor is due 20 + 21 times: every fourth of these, from the first
  EXPECT_EQ(keyFrames, 11u);
}

TEST(Simulator, OdometryWithoutNoiseIsTheTruth)
{
  const auto moments = all(load(kRoom + kScanner + kDrive), 1);
  ASSERT_EQ(moments.size(), 101u);
  for (const auto& m : moments)
  {
    EXPECT_LT((m.odometry - mrpt::poses::CPose2D(m.pose)).norm(), 1e-9) << m.seconds;
    EXPECT_NEAR(std::sin(m.odometry.phi() - m.pose.yaw()), 0, 1e-9) << m.seconds;
    EXPECT_EQ(m.estimatedPose, m.pose);
    EXPECT_EQ(m.scans.at(0).observation->timestamp, m.time);
  }
  EXPECT_EQ(mrpt::Clock::toDouble(moments[0].time), 1735689600.0);
  EXPECT_NEAR(mrpt::Clock::toDouble(moments[7].time), 1735689600.7, 1e-6);
}

// Over 4 m straight ahead the variances of four metres add up, whatever the rate of the log.
TEST(Simulator, OdometryNoiseGrowsWithTheWayNotWithTheRate)
{
  for (const char* rate : {"0.5", "5"})
  {
    const auto scenario = load(kRoom + tinyScanner(rate) +
                               "[trajectory]\nwaypoints = [-2 0 0] [2 0 0]\nspeed = 0.5\n[noise]\n"
                               "odometryPerMetre = 0.02\n");
    std::vector<double> x, y;
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
      const auto end = all(scenario, seed).back();
      EXPECT_EQ(end.seconds, 8);
      x.push_back(end.odometry.x() - 2);
      y.push_back(end.odometry.y());
    }
    expectNormal(x, 0.04, std::string("x, seeds 1 to 400, rate ") + rate);
    expectNormal(y, 0.04, std::string("y, seeds 1 to 400, rate ") + rate);
  }
}

// 4 m (2·0.5°) and a quarter turn (0.5·2°): √(1² + 1²)°
TEST(Simulator, HeadingNoiseGrowsWithWayAndTurning)
{
  const auto scenario = load(kRoom + tinyScanner("5") + kDrive +
                             "[noise]\nodometryYawPerMetre = 0.5\nodometryYawPerTurn = 2\n");
  std::vector<double> yaw;
  for (std::uint64_t seed = 1; seed <= 400; ++seed)
    yaw.push_back(mrpt::RAD2DEG(all(scenario, seed).back().odometry.phi()) - 90);
  expectNormal(yaw, std::sqrt(2.0), "yaw, seeds 1 to 400");
}

TEST(Simulator, DriftIsSystematic)
{
  const auto scenario = load(kRoom + tinyScanner("5") + kDrive + "[noise]\nodometryDrift = 1.5\n");
  EXPECT_NEAR(mrpt::RAD2DEG(all(scenario, 1).back().odometry.phi()), 90 + 4 * 1.5, 1e-6);
}

TEST(Simulator, PoseEstimatesHaveTheStatedSpread)
{
  const auto scenario =
      load(kRoom + tinyScanner("100") + kDrive + "[noise]\nposePosition = 0.05\nposeAngle = 0.7\n");
  std::vector<double> position, angle;
  for (const auto& m : all(scenario, 3))
  {
    for (int i = 0; i < 3; ++i) position.push_back(m.estimatedPose[i] - m.pose[i]);
    for (int i = 3; i < 6; ++i)
      angle.push_back(mrpt::RAD2DEG(mrpt::math::wrapToPi(m.estimatedPose[i] - m.pose[i])));
  }
  ASSERT_EQ(position.size(), 3003u);
  expectNormal(position, 0.05, "position, seed 3");
  expectNormal(angle, 0.7, "angle, seed 3");
}

TEST(Simulator, PoseEstimatesMayBeWrongInHeightAndTiltOnly)
{
  const auto scenario =
      load(kRoom + tinyScanner("100") + kDrive + "[noise]\nposeHeight = 0.002\nposeTilt = 0.05\n");
  std::vector<double> height, tilt;
  for (const auto& m : all(scenario, 3))
  {
    for (const int exact : {0, 1, 3}) ASSERT_EQ(m.estimatedPose[exact], m.pose[exact]);
    height.push_back(m.estimatedPose.z() - m.pose.z());
    for (const int angle : {4, 5})
      tilt.push_back(mrpt::RAD2DEG(m.estimatedPose[angle] - m.pose[angle]));
  }
  ASSERT_EQ(height.size(), 1001u);
  expectNormal(height, 0.002, "z, seed 3");
  expectNormal(tilt, 0.05, "pitch and roll, seed 3");
}

TEST(Simulator, NoiseOfHeightAndTiltIsAddedToThatOfAllCoordinates)
{
  const std::string both =
      kRoom + tinyScanner("1") + kDrive + "[noise]\nposePosition = 0.05\nposeAngle = 0.7\n";
  const auto without = all(load(both), 3);
  const auto with = all(load(both + "poseHeight = 0.002\nposeTilt = 0.05\n"), 3);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i)
  {
    const auto &a = without[i].estimatedPose, &b = with[i].estimatedPose;
    for (const int same : {0, 1, 3}) EXPECT_EQ(a[same], b[same]);
    EXPECT_NE(a.z(), b.z());
    EXPECT_NEAR(a.z(), b.z(), 6 * 0.002);
    for (const int angle : {4, 5})
    {
      EXPECT_NE(a[angle], b[angle]);
      EXPECT_NEAR(a[angle], b[angle], 6 * mrpt::DEG2RAD(0.05));
    }
  }
}

// What one sensor draws does not depend on which others there are.
TEST(Simulator, SensorsDoNotDisturbEachOther)
{
  const std::string noisy = kLidar + "rangeNoise = 0.02\ndropout = 0.1\n";
  const auto alone = all(load(kRoom + noisy + kDrive), 5);
  std::vector<mrpt_mapconv::sim::Scan> among;
  for (auto& m : all(load(kRoom + kScanner + noisy + kDrive), 5))
    for (auto& scan : m.scans)
      if (scan.is3D) among.push_back(scan);
  ASSERT_EQ(among.size(), alone.size());
  for (std::size_t i = 0; i < among.size(); ++i)
    EXPECT_EQ(among[i].truePoints, alone[i].scans.at(0).truePoints);
}
