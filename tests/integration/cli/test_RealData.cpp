#include <gtest/gtest.h>

#include <filesystem>

#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
const std::string kShared = MRPT_MAPCONV_SHARED_DIR "/";
const std::string kMrpt = "/usr/share/mrpt/datasets/";

bool isThere(const std::string& file) { return std::filesystem::exists(file); }
}  // namespace

// Sizes and leaves as the data's README gives them, from OctoMap's own tools.
TEST(RealData, corridor)
{
  const std::string file = kShared + "geb079.bt";
  if (!isThere(file)) GTEST_SKIP() << file << " is not there";
  const TempDir dir;
  const auto run = mapconv({"convert", file, "-o", dir.path("out"), "--json"});
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue json = parseJson(run.out);
  EXPECT_EQ(0.08, json["resolution"].number);
  EXPECT_EQ(487, json["width"].number);   // −8 … 30.96 m
  EXPECT_EQ(187, json["height"].number);  // −7.52 … 7.44 m
  EXPECT_NEAR(-8, json["xMin"].number, 1e-9);
  EXPECT_NEAR(7.44, json["yMax"].number, 1e-9);
  EXPECT_GT(json["free"].number, 25000);
  EXPECT_GT(json["occupied"].number, 0);
  EXPECT_EQ(487 * 187, json["free"].number + json["occupied"].number + json["unknown"].number);
  EXPECT_EQ(7u, readRaster(dir.path("out/layers.tif")).bands.size());

  const JsonValue info = parseJson(mapconv({"info", file, "--json"}).out);
  EXPECT_EQ(428144, info["leaves"].number);
  EXPECT_EQ(143729, info["occupiedLeaves"].number);
  EXPECT_NEAR(-0.32, info["zMin"].number, 1e-9);
  EXPECT_NEAR(2.8, info["zMax"].number, 1e-9);
}

TEST(RealData, standingVelodyne)
{
  const std::string file = kShared + "vlp16_3scans.rawlog";
  if (!isThere(file)) GTEST_SKIP() << file << " is not there";
  const TempDir dir;
  EXPECT_EQ(1, mapconv({"convert", file, "-o", dir.path("out")}).status);
  EXPECT_EQ(0u, dir.entries());
  const auto run = mapconv({"convert", file, "-o", dir.path("out"), "--static", "--json",
                            "--resolution", "0.2", "--min-clearance", "0.4"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_GT(parseJson(run.out)["free"].number, 0);
  const JsonValue info = parseJson(mapconv({"info", file, "--json"}).out);
  EXPECT_EQ(3, info["observations"]["mrpt::obs::CObservationVelodyneScan"].number);
  EXPECT_EQ(2, info["observations"]["mrpt::obs::CObservationGPS"].number);
  EXPECT_EQ("none", info["poses"].text);
}

TEST(RealData, bothVoxelEnginesGiveTheSameFiles)
{
  const std::string file = kShared + "vlp16_3scans.rawlog";
  if (!isThere(file)) GTEST_SKIP() << file << " is not there";
  const TempDir dir;
  for (const std::string engine : {"octomap", "blocks"})
  {
    std::ofstream(dir.path(engine + ".ini"))
        << "[voxelInsertion]\nvoxelEngine = " << engine << "\n";
    const auto run = mapconv({"convert", file, "-o", dir.path(engine), "--static", "--resolution",
                              "0.1", "-c", dir.path(engine + ".ini")});
    ASSERT_EQ(0, run.status) << run.err;
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(dir.path("octomap")))
  {
    const std::string name = entry.path().filename().string();
    if (name == "layers.tif") continue;  // its metadata say which engine it was
    ++files;
    EXPECT_TRUE(readBytes(entry.path().string()) == readBytes(dir.path("blocks/" + name))) << name;
  }
  EXPECT_GT(files, 5u);
  const Raster octomap = readRaster(dir.path("octomap/layers.tif")),
               blocks = readRaster(dir.path("blocks/layers.tif"));
  ASSERT_EQ(octomap.bands.size(), blocks.bands.size());
  for (std::size_t i = 0; i < blocks.bands.size(); ++i)
    expectCells(octomap.bands[i].cells, blocks.bands[i].cells, octomap.bands[i].name);
}

TEST(RealData, mrptsOwnLogs)
{
  for (const std::string name : {"test_velodyne_VLP16", "tests_rgbd"})
  {
    const std::string file = kMrpt + name + ".rawlog";  // of mrpt-common, which setup.sh installs
    ASSERT_TRUE(isThere(file)) << file;
    const TempDir dir;
    const auto run = mapconv({"convert", file, "-o", dir.path("out"), "--json", "--resolution",
                              "0.2", "--min-clearance", "0.4"});
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_GT(parseJson(run.out)["free"].number, 0) << name;
  }
}

TEST(RealData, logsOf2DScansAreRead)
{
  const std::string file = kMrpt + "localization_demo.rawlog";
  ASSERT_TRUE(isThere(file)) << file;
  const TempDir dir;
  const auto run =
      mapconv({"convert", file, "-o", dir.path("out"), "--json", "--min-clearance", "0.1"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_TRUE(contains(run.err, "all of its scans are 2D")) << run.err;
  EXPECT_GT(parseJson(run.out)["free"].number, 10000);
}

TEST(RealData, logsWithoutScansAreRefused)
{
  const std::string file = kMrpt + "kf-slam_demo.rawlog";
  ASSERT_TRUE(isThere(file)) << file;
  const TempDir dir;
  const auto run = mapconv({"convert", file, "-o", dir.path("out")});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "no scans (")) << run.err;
}
