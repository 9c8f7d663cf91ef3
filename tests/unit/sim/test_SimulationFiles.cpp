#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/files/ObjectFile.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/sim/SimulationFiles.h>

#include <list>
#include <numeric>
#include <sstream>

#include "RoomFixtures.h"

using namespace mrpt_mapconv::sim::fixtures;
using mrpt_mapconv::files::ObjectFile;
using mrpt_mapconv::files::OutputDir;
using mrpt_mapconv::sim::Scenario;
using mrpt_mapconv::sim::SimulationSummary;
using mrpt_mapconv::testing::contains;
using mrpt_mapconv::testing::messageOf;
using mrpt_mapconv::testing::readBytes;
using mrpt_mapconv::testing::TinyDisk;

namespace
{
const char* const kFiles[] = {"scans.rawlog",      "frames.rawlog",   "scans.simplemap",
                              "trajectory.csv",    "truth.tif",       "truth_floor.png",
                              "truth_ceiling.png", "truth_slope.png", "truth_aerial.png",
                              "truth_ground.png",  "truth_inView.png"};

const std::string kSensors = kLidar + kCamera + kScanner;
const std::string kNoise =
    "[noise]\nodometryPerMetre = 0.02\nodometryYawPerMetre = 0.5\nposePosition = 0.01\n";

SimulationSummary simulate(const std::string& text, std::uint64_t seed, const TempDir& dir,
                           const std::function<void(double)>& progress = {})
{
  const Scenario scenario = load(text);
  OutputDir out(dir.path());
  const auto summary = mrpt_mapconv::sim::simulateTo(out, scenario, seed, progress);
  out.commit();
  return summary;
}

/** The farthest that a point of these scans is from the room's surface. */
double farthestOff(const std::vector<mrpt_mapconv::observation::PosedObservation>& scans)
{
  double farthest = 0;
  for (const auto& scan : scans)
  {
    const auto seen = mrpt_mapconv::observation::sensorPoints(*scan.observation, scan.robotPose);
    for (const auto& p : seen->points)
      farthest =
          std::max(farthest, offRoom(seen->sensorPose.composePoint(mrpt::math::TPoint3D(p))));
  }
  return farthest;
}

template <class Class>
std::size_t countOf(const std::string& file)
{
  std::size_t count = 0;
  ObjectFile objects(file);
  while (const auto object = objects.next())
    count += std::dynamic_pointer_cast<Class>(object) ? 1 : 0;
  return count;
}

std::string gunzipped(const std::string& file)
{
  mrpt::io::CFileGZInputStream in(file);
  std::string bytes(1 << 26, '\0');
  bytes.resize(in.Read(bytes.data(), bytes.size()));
  return bytes;
}
}  // namespace

TEST(SimulationFiles, TheSeedDecidesEveryByte)
{
  const std::string noisy =
      kRoom + kSensors + "rangeNoise = 0.01\ndropout = 0.1\n" + kDrive + kNoise;
  const TempDir first, again, other;
  simulate(noisy, 1, first);
  simulate(noisy, 1, again);
  simulate(noisy, 2, other);
  EXPECT_EQ(first.entries(), std::size(kFiles));
  for (const std::string name : kFiles)
  {
    const std::string bytes = readBytes(first.path(name));
    EXPECT_FALSE(bytes.empty()) << name;
    EXPECT_TRUE(bytes == readBytes(again.path(name))) << name;
    const bool isRandom = contains(name, "scans") || contains(name, "frames");
    EXPECT_TRUE(!isRandom || bytes != readBytes(other.path(name))) << name;
  }
}

// 101 moments, see the schedule's test: 101 scans of front, 21 of lidar, 11 of camera
TEST(SimulationFiles, ReadBackTheyShowTheRoom)
{
  const TempDir dir;
  const auto summary = simulate(kRoom + kSensors + kDrive, 1, dir);
  EXPECT_EQ(summary.moments, 101u);
  EXPECT_EQ(summary.scans, 133u);
  EXPECT_EQ(summary.keyFrames, 21u);
  EXPECT_DOUBLE_EQ(summary.way, 4);
  EXPECT_DOUBLE_EQ(summary.seconds, 10);
  EXPECT_EQ(countOf<mrpt::obs::CObservationOdometry>(dir.path("scans.rawlog")), 101u);
  EXPECT_EQ(countOf<mrpt::obs::CObservationRobotPose>(dir.path("scans.rawlog")), 0u);
  EXPECT_EQ(countOf<mrpt::obs::CActionCollection>(dir.path("frames.rawlog")), 101u);
  EXPECT_EQ(countOf<mrpt::obs::CSensoryFrame>(dir.path("frames.rawlog")), 101u);

  const auto scans = mrpt_mapconv::observation::readRawlog(dir.path("scans.rawlog"));
  EXPECT_EQ(scans.size(), 133u);
  EXPECT_LT(farthestOff(scans), 2e-4);
  const auto frames = mrpt_mapconv::observation::readRawlog(dir.path("frames.rawlog"));
  EXPECT_EQ(frames.size(), 133u);
  EXPECT_LT(farthestOff(frames), 2e-4);
  const auto keyFrames = mrpt_mapconv::observation::readSimpleMap(dir.path("scans.simplemap"));
  EXPECT_EQ(keyFrames.size(), 21u + 21u + 11u);  // front is due whenever lidar or camera is
  EXPECT_LT(farthestOff(keyFrames), 2e-4);
}

TEST(SimulationFiles, PosesAreLoggedWhereAskedFor)
{
  const TempDir dir;
  const std::string spatial =
      "[trajectory]\nposes = [0 0 0 0.5 0 0 0] [4 1 1 1 40 10 5]\n[log]\nposes = true\n";
  simulate(kRoom + kLidar + spatial, 1, dir);
  EXPECT_EQ(countOf<mrpt::obs::CObservationRobotPose>(dir.path("scans.rawlog")), 9u);
  const auto scans = mrpt_mapconv::observation::readRawlog(dir.path("scans.rawlog"));
  EXPECT_EQ(scans.size(), 9u);
  EXPECT_LT(farthestOff(scans), 2e-4);
}

// 10 Hz, 0.05 m a step: 0.02·√0.05 m and 0.5·√0.05°; no less than 1 mm and 0.02° while it turns
TEST(SimulationFiles, ActionsAreAsUncertainAsTheOdometry)
{
  const TempDir dir;
  simulate(kRoom + kScanner + kDrive + kNoise, 1, dir);
  ObjectFile file(dir.path("frames.rawlog"));
  std::vector<mrpt::math::CMatrixDouble33> covariances;
  mrpt::poses::CPose2D sum;
  while (const auto object = file.next())
    if (const auto actions = std::dynamic_pointer_cast<mrpt::obs::CActionCollection>(object))
    {
      const auto move = actions->getActionByClass<mrpt::obs::CActionRobotMovement2D>();
      ASSERT_TRUE(move);
      covariances.push_back(move->poseChange->getCovariance());
      sum = sum + move->rawOdometryIncrementReading;
    }
  ASSERT_EQ(covariances.size(), 101u);
  const double step = std::sqrt(0.05);
  // the step is itself noisy, by some per cent
  EXPECT_NEAR(std::sqrt(covariances[10](0, 0)), 0.02 * step, 0.1 * 0.02 * step);
  EXPECT_NEAR(std::sqrt(covariances[10](2, 2)), mrpt::DEG2RAD(0.5 * step), 0.1 * 0.01 * step);
  EXPECT_NEAR(std::sqrt(covariances[50](0, 0)), 0.001, 1e-5);
  EXPECT_NEAR(std::sqrt(covariances[50](2, 2)), mrpt::DEG2RAD(0.02), 1e-6);
  EXPECT_LT((sum.asTPose() - mrpt::math::TPose2D(2, 2, M_PI / 2)).norm(), 0.3);
}

/** Standard deviations of x, y, z [mm], yaw, pitch, roll [0.01°]. */
std::vector<double> sigmasOf(const mrpt::math::CMatrixDouble66& covariance)
{
  std::vector<double> sigmas;
  for (int i = 0; i < 6; ++i)
  {
    const double sigma = std::sqrt(covariance(i, i));
    sigmas.push_back(i < 3 ? 1e3 * sigma : 100 * mrpt::RAD2DEG(sigma));
  }
  return sigmas;
}

/** Asserts that the poses of both files are that uncertain: x, y, z [mm], yaw, pitch, roll [0.01°].
 */
void expectSigmas(const std::string& noise, const std::vector<double>& expected)
{
  const TempDir dir;
  simulate(kRoom + kLidar + kDrive + "[log]\nposes = true\n[noise]\n" + noise, 1, dir);
  ObjectFile log(dir.path("scans.rawlog")), simpleMap(dir.path("scans.simplemap"));
  std::size_t poses = 0;
  const auto check = [&](const mrpt::math::CMatrixDouble66& covariance)
  {
    ++poses;
    const auto sigmas = sigmasOf(covariance);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(sigmas[i], expected[i], 1e-6) << noise << i;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < i; ++j) EXPECT_EQ(covariance(i, j), 0);
  };
  while (const auto object = log.next())
    if (const auto pose = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(object))
      check(pose->pose.cov);
  const auto map = std::dynamic_pointer_cast<mrpt::maps::CSimpleMap>(simpleMap.next());
  ASSERT_TRUE(map);
  for (const auto& frame : *map)
    check(dynamic_cast<const mrpt::poses::CPose3DPDFGaussian&>(*frame.pose).cov);
  EXPECT_EQ(poses, 42u);
}

TEST(SimulationFiles, PosesAreAsUncertainAsTheirNoise)
{
  expectSigmas("posePosition = 0.01\nposeAngle = 0.2\n", {10, 10, 10, 20, 20, 20});
  expectSigmas("poseHeight = 0.002\nposeTilt = 0.05\n", {1, 1, 2, 1, 5, 5});
  expectSigmas("posePosition = 0.003\nposeHeight = 0.004\nposeAngle = 0.05\nposeTilt = 0.12\n",
               {3, 3, 5, 5, 13, 13});
  expectSigmas("", {1, 1, 1, 1, 1, 1});
}

// MRPT reads it, and would have written the same.
TEST(SimulationFiles, TheSimpleMapIsMrptsToTheByte)
{
  const TempDir dir;
  simulate(kRoom + kSensors + kDrive + kNoise + "[log]\nkeyFrameEvery = 5\n", 1, dir);
  ObjectFile file(dir.path("scans.simplemap"));
  const auto map = std::dynamic_pointer_cast<mrpt::maps::CSimpleMap>(file.next());
  ASSERT_TRUE(map);
  EXPECT_EQ(map->size(), 5u);
  EXPECT_FALSE(file.next());
  std::vector<std::uint8_t> bytes;
  mrpt::serialization::ObjectToOctetVector(map.get(), bytes);
  const std::string written = gunzipped(dir.path("scans.simplemap"));
  EXPECT_TRUE(written == std::string(bytes.begin(), bytes.end()));
}

TEST(SimulationFiles, TheTrajectoryIsTrue)
{
  const TempDir dir;
  simulate(kRoom + kScanner + kDrive + kNoise, 1, dir);
  std::istringstream lines(readBytes(dir.path("trajectory.csv")));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "t,x,y,z,yaw,pitch,roll");
  std::getline(lines, line);
  EXPECT_EQ(line, "0,0,0,0,0,0,0");
  for (int i = 1; i <= 20; ++i) std::getline(lines, line);
  EXPECT_EQ(line, "2,1,0,0,0,0,0");
  std::size_t rest = 0;
  while (std::getline(lines, line)) ++rest;
  EXPECT_EQ(rest, 80u);
}

TEST(SimulationFiles, InViewCountsTheReturnsOfThe3DScans)
{
  const TempDir dir;
  const auto summary = simulate(kRoom + kLidar + kScanner + kDrive, 1, dir);
  const auto band = [&](const char* name)
  { return mrpt_mapconv::grid::readGeoTiffBand(dir.path("truth.tif"), name); };
  const auto inView = band("inView");
  const auto& cells = inView.cells();
  EXPECT_EQ(std::accumulate(cells.begin(), cells.end(), 0.0),
            static_cast<double>(summary.returns3D));
  EXPECT_EQ(summary.returns3D, 21u * 16 * 90);
  const auto at = [](const auto& layer, double x, double y)
  {
    const auto& f = layer.frame();
    return layer.at(static_cast<int>(std::floor(x / f.resolution)) - f.x0,
                    static_cast<int>(std::floor(y / f.resolution)) - f.y0);
  };
  EXPECT_EQ(at(inView, 5.35, 0.05), 0);  // within the wall
  EXPECT_FLOAT_EQ(at(band("floor"), 0.05, 0.05), 0);
  EXPECT_FLOAT_EQ(at(band("ceiling"), 0.05, 0.05), 3);
  EXPECT_FLOAT_EQ(at(band("slope"), 0.05, 0.05), 0);
  EXPECT_EQ(at(band("ground"), 0.05, 0.05), 0);
  EXPECT_EQ(at(band("aerial"), 5.35, 0.05), 1);
}

// The pictures are of the truth's bands and say so; that of the ground knows nothing of the aerial
// one, whose legend would blame slopes and steps for what has no headroom.
TEST(SimulationFiles, PicturesSayWhatTheyAre)
{
  using mrpt_mapconv::grid::LayerKind;
  const TempDir dir;
  simulate(kRoom + kLidar + kDrive, 1, dir);
  std::vector<mrpt_mapconv::grid::StyledLayer> pictures{
      {"floor", nullptr, "Truth: bottom of the lowest gap", "m", LayerKind::Height},
      {"ceiling", nullptr, "Truth: top of the highest gap", "m", LayerKind::Height},
      {"slope", nullptr, "Truth: slope of the ground", "m/m", LayerKind::Slope},
      {"aerial", nullptr, "Truth: occupancy for an aerial robot", "", LayerKind::Occupancy},
      {"ground", nullptr, "Truth: occupancy for a ground robot", "", LayerKind::Occupancy},
      {"inView", nullptr, "In view: 3D returns per cell (log10)", "log10(returns)",
       LayerKind::Height}};
  std::list<mrpt_mapconv::grid::Layer<float>> layers;
  for (auto& picture : pictures)
  {
    layers.push_back(mrpt_mapconv::grid::readGeoTiffBand(dir.path("truth.tif"), picture.name));
    picture.layer = &layers.back();
  }
  for (float& cell : layers.back().cells()) cell = cell > 0 ? std::log10(cell) : std::nanf("");
  const auto shown = mrpt_mapconv::grid::shownFrame(pictures);
  for (const auto& picture : pictures)
  {
    const std::string expected = dir.path("expected.png");
    mrpt_mapconv::grid::writeLayerPng(expected, picture, {}, shown);
    EXPECT_TRUE(readBytes(expected) == readBytes(dir.path("truth_" + picture.name + ".png")))
        << picture.name;
  }
}

TEST(SimulationFiles, ProgressGoesFrom0To1)
{
  const TempDir dir;
  std::vector<double> shares;
  simulate(kRoom + kScanner + kDrive, 1, dir, [&](double share) { shares.push_back(share); });
  ASSERT_GT(shares.size(), 100u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
}

TEST(SimulationFiles, AFullDiskIsNoticed)
{
  for (const int kilobytes : {16, 64, 200, 400})
  {
    const TinyDisk disk(kilobytes);
    if (!disk.mounted()) GTEST_SKIP() << "not allowed to mount";
    const Scenario scenario = load(kRoom + kSensors + kDrive);
    const auto message = messageOf(
        [&]
        {
          OutputDir out(disk.path("out"));
          mrpt_mapconv::sim::simulateTo(out, scenario, 1);
          out.commit();
        });
    EXPECT_TRUE(contains(message, "No space left on device")) << kilobytes << " kB: " << message;
  }
}
