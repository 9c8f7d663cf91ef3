#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "OctreeFiles.h"
#include "Program.h"
#include "Raster.h"
#include "ScanFiles.h"
#include "StrictJson.h"
#include "support/TempDir.h"

// Values that users have given and that cannot be meant, or had no effect, and maps that hold less
// than a conversion needs (see test_Reports.cpp).
namespace
{
using namespace mrpt_mapconv::testing;

const std::string kShared = MRPT_MAPCONV_SHARED_DIR "/";
const std::string kReports = kShared + "reports/";

class ReportValues : public ::testing::Test
{
 protected:
  std::string write(const std::string& name, const std::string& text)
  {
    std::ofstream(m_dir.path(name)) << text;
    return m_dir.path(name);
  }
  Outcome run(const std::string& command, const std::string& file,
              const std::vector<std::string>& flags = {})
  {
    std::vector<std::string> all{command, file, "-o", m_dir.path("out"), "--json"};
    all.insert(all.end(), flags.begin(), flags.end());
    return mapconv(all);
  }
  Outcome convert(const std::string& file, const std::vector<std::string>& flags = {})
  {
    std::vector<std::string> all{"--max-step", "0.2"};  // without it a warning is due
    all.insert(all.end(), flags.begin(), flags.end());
    return run("convert", file, all);
  }
  std::string handMap()
  {
    HandMap::write(m_dir.path("hand.bt"));
    return m_dir.path("hand.bt");
  }
  static void expectWords(const std::vector<std::string>& words, const std::string& text)
  {
    for (const auto& word : words) EXPECT_TRUE(contains(text, word)) << word << ": " << text;
  }

  TempDir m_dir;
};

class ReportedFiles : public ReportValues
{
 protected:
  void SetUp() override
  {
    if (!std::filesystem::exists(kReports)) GTEST_SKIP() << kReports << " is not there";
  }
};

TEST_F(ReportedFiles, AClampingThresholdBelowOccupancyThresIsAnError)
{
  const auto clamp = run("convert", kReports + "one_scan.rawlog", {"-c", kReports + "clamp.ini"});
  EXPECT_EQ(1, clamp.status);
  expectWords(
      {"error: " + kReports + "clamp.ini", "clampingThresMax = 0.4", "occupancyThres = 0.5"},
      clamp.err);
  EXPECT_FALSE(std::filesystem::exists(m_dir.path("out")));
}

TEST_F(ReportedFiles, OccupancyThresGoesForTheProbabilitiesOfAnOt)
{
  const std::string map = kReports + "thr.ot";
  const auto occupied = [&](const std::string& command, std::vector<std::string> flags)
  {
    if (command == "project") flags.insert(flags.end(), {"--z-min", "0.2", "--z-max", "1"});
    const auto outcome = run(command, map, flags);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_FALSE(contains(outcome.err, "no effect")) << outcome.err;
    return parseJson(outcome.out)["occupied"].number;
  };
  EXPECT_EQ(80, occupied("project", {}));
  EXPECT_EQ(0, occupied("project", {"-c", kReports + "thr.ini"}));
  EXPECT_LT(0, occupied("convert", {}));
  EXPECT_EQ(0, occupied("convert", {"-c", kReports + "thr.ini"}));
  // what plan and lift read is decided as the layers are
  const auto voxels = mrpt_mapconv::voxel::readOctreeFile(m_dir.path("out/voxels.bt"));
  const auto& tree = dynamic_cast<const octomap::OcTree&>(*voxels);
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf)
    EXPECT_TRUE(!tree.isNodeOccupied(*leaf) || leaf.getZ() < 0.1) << leaf.getZ();
}

TEST_F(ReportValues, SensorModelsThatExcludeEachOtherAreErrors)
{
  for (const auto& [keys, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"clampingThresMin = 0.6", {"clampingThresMin = 0.6", "occupancyThres = 0.5"}},
           {"occupancyThres = 0.98", {"clampingThresMax = 0.971", "occupancyThres = 0.98"}},
           {"probHit = 0.99", {"probHit = 0.99", "clampingThresMax = 0.971"}},
           {"probMiss = 0.05", {"probMiss = 0.05", "clampingThresMin = 0.1192"}}})
  {
    const auto ini = write("bad.ini", "[voxelInsertion]\n" + keys + "\n");
    const auto outcome = convert(handMap(), {"-c", ini});
    EXPECT_EQ(1, outcome.status) << keys;
    EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
    expectWords(words, outcome.err);
    expectWords({ini, "section 'voxelInsertion'"}, outcome.err);
  }
}

TEST_F(ReportValues, WhatHasNoEffectOnABtIsNamedInOneWarning)
{
  const auto ini =
      write("my.ini", "[voxelInsertion]\nmaxrange = 5\nprobHit = 0.8\noccupancyThres = 0.6\n");
  const auto outcome =
      convert(handMap(), {"-c", ini, "--resolution", "0.2", "--static", "--pose-source", "x"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ(1, warningsIn(outcome.err)) << outcome.err;
  expectWords({"--resolution 0.2 has no effect", "hand.bt has voxels of 0.5 m",
               "--static, --pose-source have no effect", "is no rawlog",
               "maxrange, probHit of " + ini + " have no effect", "holds voxels and no scans",
               "occupancyThres of " + ini + " has no effect", "an .ot of the same map would"},
              outcome.err);
}

TEST_F(ReportValues, WhatHasAnEffectIsNotNamed)
{
  const auto ini = write("my.ini", "[voxelInsertion]\nmaxrange = 5\nprobHit = 0.8\n");
  writeSimpleMap(m_dir.path("m.simplemap"), {0.0}, false);
  const auto scans = convert(m_dir.path("m.simplemap"), {"-c", ini});
  ASSERT_EQ(0, scans.status) << scans.err;
  EXPECT_EQ("", scans.err);
  // a file that shows all defaults asks for nothing
  const auto defaults =
      convert(handMap(), {"-c", MRPT_MAPCONV_SOURCE_DIR "/config/freeSpaceGrid/convert.ini"});
  ASSERT_EQ(0, defaults.status) << defaults.err;
  EXPECT_EQ("", defaults.err);
}

TEST_F(ReportValues, AProjectionSaysWhichKeysOfAConversionItLooksAt)
{
  const auto ini = write("my.ini",
                         "[conversion]\nminClearance = 2\nmaxStep = 0.2\n"
                         "unknown = free\n[voxelInsertion]\nmaxrange = 5\n");
  const auto outcome = run("project", handMap(), {"--z-min", "0.5", "--z-max", "1", "-c", ini});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ(1, warningsIn(outcome.err)) << outcome.err;
  expectWords({"minClearance, maxStep of " + ini + " have no effect", "maxrange of " + ini},
              outcome.err);
  EXPECT_FALSE(contains(outcome.err, "unknown")) << outcome.err;
}

/** A hall of columns "o" at the height of a ramp: one voxel up for each in x; at its far end a
 * post whose top is the highest voxel of the map, z key 29. */
std::string rampTree(const std::string& path)
{
  octomap::OcTree tree(0.1);
  const auto mark = [&tree](int x, int y, int z)
  {
    tree.updateNode(octomap::OcTreeKey(static_cast<octomap::key_type>(32768 + x),
                                       static_cast<octomap::key_type>(32768 + y),
                                       static_cast<octomap::key_type>(32768 + z)),
                    true);
  };
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 12; ++x) mark(x, y, x);
  for (int z = 0; z < 30; ++z) mark(11, 5, z);
  writeTree(tree, path);
  return path;
}

TEST_F(ReportValues, AMapWithoutFreeSpaceIsAnErrorThatSaysWhatHelps)
{
  const auto map = rampTree(m_dir.path("ramp.bt"));
  const auto outcome = convert(map);
  EXPECT_EQ(1, outcome.status);
  EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
  expectWords({map, "no voxel of the map is free", "--unknown free"}, outcome.err);
  EXPECT_FALSE(std::filesystem::exists(m_dir.path("out")));

  const auto info = mapconv({"info", map});
  expectWords({"no voxel of the map is free", "--unknown free"}, info.out);
  const auto projected = run("project", map, {"--z-min", "0", "--z-max", "1"});
  EXPECT_EQ(0, projected.status) << projected.err;
  EXPECT_EQ(1, warningsIn(projected.err)) << projected.err;
  expectWords({"no voxel of the map is free", "--unknown free"}, projected.err);
}

TEST_F(ReportValues, WithUnknownFreeTheFloorFollowsASlope)
{
  const auto outcome = convert(rampTree(m_dir.path("ramp.bt")), {"--unknown", "free"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ("", outcome.err);
  const auto json = parseJson(outcome.out);
  EXPECT_EQ(71, json["free"].number);
  EXPECT_EQ(0, json["steep"].number);
  EXPECT_EQ("free", json["parameters"]["unknown"].text);
  std::vector<double> floor, ceiling;
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 12; ++x)
    {
      const bool post = x == 11 && y == 5;
      floor.push_back(post ? NAN : 0.1 * (x + 1));
      ceiling.push_back(post ? NAN : 3.0);
    }
  const Raster layers = readRaster(m_dir.path("out/layers.tif"));
  for (const auto& band : layers.bands)
    if (band.name == "floor" || band.name == "ceiling")
      expectCells(band.name == "floor" ? floor : ceiling, band.cells, band.name);
}

TEST_F(ReportValues, UnknownFreeWorksFromAnIniAndWithAnyNumberOfThreads)
{
  const auto map = rampTree(m_dir.path("ramp.bt"));
  const auto ini = write("free.ini", "[conversion]\nunknown = free\n");
  for (const char* threads : {"1", "2", "5"})
  {
    const auto outcome = convert(map, {"-c", ini, "--threads", threads});
    ASSERT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ(71, parseJson(outcome.out)["free"].number);
  }
  const auto projected =
      run("project", map, {"--z-min", "1.5", "--z-max", "2", "--unknown", "free"});
  ASSERT_EQ(0, projected.status) << projected.err;
  EXPECT_EQ("", projected.err);
  EXPECT_EQ(71, parseJson(projected.out)["free"].number);
}

TEST_F(ReportValues, PlanAndLiftReadTheVoxelsAsTheConversionDid)
{
  ASSERT_EQ(0, convert(rampTree(m_dir.path("ramp.bt")), {"--unknown", "free"}).status);
  for (const char* robot : {"ground", "aerial"})
  {
    const auto outcome = mapconv({"plan", m_dir.path("out"), "--robot", robot, "--from",
                                  "0.35,0.35", "--to", "0.85,0.35", "--robot-radius", "0.15", "-o",
                                  m_dir.path(std::string(robot) + ".csv")});
    EXPECT_EQ(0, outcome.status) << outcome.err;
  }
}

TEST_F(ReportValues, UnknownIsOneOfTwoWords)
{
  const auto outcome = convert(handMap(), {"--unknown", "occupied"});
  EXPECT_EQ(2, outcome.status);
  expectWords({"--unknown", "unknown", "free"}, outcome.err);
}

TEST_F(ReportedFiles, ALabyrinthWithoutFreeSpaceIsConvertedWithUnknownFree)
{
  const std::string map = kShared + "real/laberynth.bt";
  if (!std::filesystem::exists(map)) GTEST_SKIP() << map << " is not there";
  const auto refused = convert(map);
  EXPECT_EQ(1, refused.status);
  expectWords({map, "--unknown free"}, refused.err);
  const auto outcome = convert(map, {"--unknown", "free"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  const auto json = parseJson(outcome.out);
  EXPECT_EQ(32768, json["cells"].number);
  EXPECT_EQ(6145, json["free"].number);
  EXPECT_EQ(2987, json["occupied"].number);
}

/** A robot at the origin whose scan saw what `scan` says. */
std::string logOf(const std::string& path, const mrpt::obs::CObservation::Ptr& scan)
{
  scan->timestamp = robotAt(0, 0)->timestamp;
  writeObjects(path, {robotAt(0, 0), scan, robotAt(0, 0.5)});
  return path;
}

TEST_F(ReportValues, ADepthImageMakesNoWallAtItsMaxRange)
{
  auto camera = mrpt::obs::CObservation3DRangeScan::Create();
  camera->cameraParams.ncols = 3;
  camera->cameraParams.nrows = 1;
  camera->cameraParams.setIntrinsicParamsFromValues(1, 1, 1, 0);
  camera->hasRangeImage = true;
  camera->maxRange = 5;
  camera->rangeImage.setZero(1, 3);
  camera->rangeImage(0, 0) = 2050;  // [mm], to the left
  camera->rangeImage(0, 1) = 5000;  // ahead: no return; to the right the pixel is invalid
  camera->setSensorPose(mrpt::poses::CPose3D(0.05, 0.05, 0.05));
  const auto outcome = run("project", logOf(m_dir.path("camera.rawlog"), camera),
                           {"--z-min", "-0.5", "--z-max", "0.5"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  const auto json = parseJson(outcome.out);
  EXPECT_EQ(1, json["occupied"].number);
  EXPECT_NEAR(5.0, json["xMax"].number, 0.11);
  EXPECT_GE(json["free"].number, 50 + 20);
  EXPECT_NEAR(0.0, json["yMin"].number, 1e-6) << "the invalid pixel has freed something";
}

TEST_F(ReportValues, A2DScanMakesNoWallAtItsMaxRange)
{
  auto scan = mrpt::obs::CObservation2DRangeScan::Create();
  scan->aperture = static_cast<float>(M_PI);
  scan->maxRange = 5;
  scan->resizeScanAndAssign(3, 5, true);  // right, ahead, left
  scan->setScanRange(1, 2);
  scan->setScanRangeValidity(0, false);
  scan->setSensorPose(mrpt::poses::CPose3D(0.05, 0.05, 0.05));
  writeSimpleMap(m_dir.path("scan.simplemap"), {scan});
  const auto outcome =
      run("project", m_dir.path("scan.simplemap"), {"--z-min", "-0.5", "--z-max", "0.5"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  const auto json = parseJson(outcome.out);
  EXPECT_EQ(1, json["occupied"].number);
  EXPECT_NEAR(2.1, json["xMax"].number, 0.11);
  EXPECT_NEAR(5.0, json["yMax"].number, 0.11);
  EXPECT_NEAR(0.0, json["yMin"].number, 1e-6);
}

}  // namespace
