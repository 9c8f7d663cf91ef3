#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/CloudFile.h>

#include <filesystem>

#include "Golden.h"
#include "Program.h"
#include "ScanFiles.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

// What --json prints, with its keys, their order, and every number that is no time: scripts read
// it. Of the ini files only the sections [conversion] and [map] are used.

namespace
{
const std::string kVelodyne = MRPT_MAPCONV_SHARED_DIR "/vlp16_3scans.rawlog";
const std::string kStreams = MRPT_MAPCONV_SOURCE_DIR "/tests/stored_streams/v0.1/";
const std::string kNewStreams = MRPT_MAPCONV_SOURCE_DIR "/tests/stored_streams/v0.3/";
const std::vector<std::string> kSlice{"--structure", "1", "2"};

std::vector<std::string> operator+(std::vector<std::string> words,
                                   const std::vector<std::string>& more)
{
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class GoldenJson : public ::testing::Test
{
 protected:
  std::string path(const std::string& name) const { return m_dir.path(name); }
  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
    return path(name);
  }

  /** The sample map with coarse voxels. */
  std::string building() const
  {
    const auto run =
        mapconv({"sample-map", "building", "-o", path("building.bt"), "--resolution", "0.2"});
    EXPECT_EQ(0, run.status) << run.err;
    return path("building.bt");
  }

  /** The folder of the converted sample map. */
  std::string buildingMaps() const
  {
    const auto run = mapconv(
        {"convert", building(), "-o", path("maps"), "--min-clearance", "0.6", "--max-step", "0.2"});
    EXPECT_EQ(0, run.status) << run.err;
    return path("maps");
  }

  void expectJson(const std::string& name, const std::vector<std::string>& arguments) const
  {
    const auto run = mapconv(arguments + std::vector<std::string>{"--json"});
    ASSERT_EQ(0, run.status) << name << ": " << run.err;
    expectGolden(name + ".json",
                 withoutTimes(withPlaceholders(run.out, {{m_dir.path(), "DIR"},
                                                         {MRPT_MAPCONV_SHARED_DIR, "SHARED"},
                                                         {MRPT_MAPCONV_SOURCE_DIR, "SOURCE"}})));
  }

  TempDir m_dir;
};

/** Three points far away, with all that a cloud can have. */
cloud::PointCloud smallCloud()
{
  cloud::PointCloud cloud;
  cloud.origin = {600000, 5000000, 400};
  cloud.x = {0.25, 100.125, -3};
  cloud.y = {0.5, -7.375, 2000};
  cloud.z = {0, 12.5, -0.75};
  cloud.time = {1234567.125, 1234567.25, 1234568};
  cloud.intensity = {0, 7, 65535};
  cloud.returnNumber = {1, 2, 3};
  cloud.numberOfReturns = {3, 3, 3};
  cloud.classification = {2, 2, 200};
  cloud.withheld = {0, 1, 0};
  cloud.coordinateSystem = "EPSG:32632";
  return cloud;
}

/** Tests of the real scans. Their sensor is 1.8 m high, so a slice of walls has to be named even
 * without the filter: a sensor outside of all slices sees nothing. */
class GoldenJsonVelodyne : public GoldenJson
{
 protected:
  void SetUp() override
  {
    if (!std::filesystem::exists(kVelodyne)) GTEST_SKIP() << kVelodyne << " is not there";
  }
  void expectInsertJson(const std::string& name, const std::vector<std::string>& flags) const
  {
    expectJson(
        name, std::vector<std::string>{"insert", kVelodyne, "-o", path("out"), "--static"} + flags);
  }
};
}  // namespace

TEST_F(GoldenJson, convert) { expectJson("convert", {"convert", building(), "-o", path("out")}); }

TEST_F(GoldenJson, convertWithFlags)
{
  expectJson("convert_flags", {"convert", building(), "-o", path("out"), "--min-clearance", "0.6",
                               "--min-occupancy", "0.25", "--slope-window", "1", "--max-slope",
                               "0.75", "--max-step", "0.2", "--threads", "2"});
}

TEST_F(GoldenJson, convertWithIniFile)
{
  const auto ini = write("my.ini",
                         "[conversion]\nrobot = aerial\nminClearance = 1.5\nminOccupancy = 0.75\n"
                         "slopeWindow = 3\nmaxSlope = 1.25\nmaxStep = 0.4\n");
  expectJson("convert_ini",
             {"convert", building(), "-o", path("out"), "-c", ini, "--max-step", "0"});
}

TEST_F(GoldenJson, project)
{
  expectJson("project",
             {"project", building(), "-o", path("out"), "--z-min", "0.1", "--z-max", "1.8"});
}

TEST_F(GoldenJson, projectWithoutALimit)
{
  expectJson("project_inf",
             {"project", building(), "-o", path("out"), "--z-min", "-1", "--z-max", "inf"});
}

TEST_F(GoldenJson, plan)
{
  const auto maps = buildingMaps();
  expectJson("plan_ground", {"plan", maps, "--robot", "ground", "--from", "-3,1.5", "--to", "7,4",
                             "--robot-radius", "0.25", "-o", path("ground.csv")});
  expectJson("plan_aerial", {"plan", maps, "--robot", "aerial", "--from", "-3,1.5", "--to", "7,4",
                             "--robot-radius", "0.25", "--safety-radius", "0.2", "--height-offset",
                             "0.4", "--lookahead", "1", "-o", path("aerial.csv")});
}

TEST_F(GoldenJson, lift)
{
  const auto maps = buildingMaps();
  const auto way = write("way.csv", "x,y\n-3,1.5\n-2,1.5\n");
  expectJson("lift_ground", {"lift", maps, way, "--robot", "ground", "-o", path("ground.csv")});
  expectJson("lift_aerial",
             {"lift", maps, way, "--robot", "aerial", "--safety-radius", "0.1", "--height-offset",
              "0.3", "--unknown-is-passable", "-o", path("aerial.csv")});
}

TEST_F(GoldenJson, simulate)
{
  expectJson("simulate", {"simulate", goldenPath("world.ini"), "-o", path("out"), "--seed", "7"});
}

TEST_F(GoldenJson, infoOfMaps)
{
  const auto maps = buildingMaps();
  expectJson("info_bt", {"info", maps + "/voxels.bt"});
  expectJson("info_gridmap", {"info", maps + "/ground.gridmap"});
  expectJson("info_freespace", {"info", kStreams + "freespace_scans.bin"});
  expectJson("info_scanshape", {"info", kStreams + "scanshape_scans.bin"});
  expectJson("info_terrain", {"info", kNewStreams + "terrain_scans.bin"});
}

TEST_F(GoldenJson, infoOfLogs)
{
  writeObjects(path("a.rawlog"), {robotAt(0, 0), lookDown(0.5), scan2D(1), robotAt(1, 2.5)});
  writeSimpleMap(path("a.simplemap"), {0, 1, 2}, false);
  expectJson("info_rawlog", {"info", path("a.rawlog")});
  expectJson("info_simplemap", {"info", path("a.simplemap")});
}

TEST_F(GoldenJson, infoOfClouds)
{
  writeCloudFile(path("a.las"), smallCloud());
  writeCloudFile(path("a.pcd"), smallCloud());
  write("a.xyz", "1 2 3 red\n4 5 nan green\n-1.5 7 8 blue\n");
  expectJson("info_las", {"info", path("a.las")});
  expectJson("info_pcd", {"info", path("a.pcd")});
  expectJson("info_xyz", {"info", path("a.xyz")});
  expectJson("info_xyz_columns", {"info", path("a.xyz"), "--columns", "z,x,y"});
}

TEST_F(GoldenJson, infoOfARealCloud)
{
  const std::string file = MRPT_MAPCONV_SHARED_DIR "/real/autzen-thin.las";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  expectJson("info_autzen", {"info", file});
}

TEST_F(GoldenJson, ground)
{
  const std::string file = MRPT_MAPCONV_SHARED_DIR "/real/isprs_samp31.pcd";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  expectJson("ground", {"ground", file, "-o", path("out"), "--points", path("points.csv")});
  const auto ini = write("my.ini", "[ground]\ngroundFilter = smrf\nsmrfWindow = 10\n");
  expectJson("ground_flags", {"ground", file, "-o", path("out"), "-c", ini, "--cell-size", "1",
                              "--crs", "EPSG:32632", "--low-point-radius", "0"});
}

TEST_F(GoldenJson, scansOfARobotThatMoves)
{
  writeObjects(path("a.rawlog"),
               {robotAt(0, 0), lookDown(0.5), scan2D(1), robotAt(0.4, 1), robotAt(1, 2.5)});
  expectJson("convert_rawlog",
             {"convert", path("a.rawlog"), "-o", path("out"), "--resolution", "0.2"});
  expectJson("insert_2d", {"insert", path("a.rawlog"), "-o", path("out2"), "--structure", "2",
                           "2.4", "--resolution", "0.1"});
}

TEST_F(GoldenJsonVelodyne, info) { expectJson("info_velodyne", {"info", kVelodyne}); }

TEST_F(GoldenJsonVelodyne, insert)
{
  expectInsertJson("insert", kSlice);
  expectInsertJson("insert_no_filter", kSlice + std::vector<std::string>{"--no-reflection-filter"});
  expectInsertJson("insert_flags",
                   kSlice + std::vector<std::string>{"--model", "closestPoint", "--resolution",
                                                     "0.2", "--no-2d"});
}

TEST_F(GoldenJsonVelodyne, insertWithIniFile)
{
  const auto ini = write("my.ini", "[map]\nresolution = 0.125\nmaxGridCells = 5e6\n");
  expectInsertJson("insert_ini", kSlice + std::vector<std::string>{"-c", ini});
}

TEST_F(GoldenJsonVelodyne, terrain)
{
  expectJson("terrain", {"terrain", kVelodyne, "-o", path("out"), "--static"});
  const auto ini =
      write("my.ini", "[terrainInsertion]\nrangeSigma = 0.03\n[terrain]\nhypotheses = 8\n");
  expectJson("terrain_flags",
             {"terrain", kVelodyne, "-o", path("out"), "--static", "-c", ini, "--resolution", "0.1",
              "--max-height", "3", "--height-rule", "maximum"});
}

TEST_F(GoldenJsonVelodyne, convert)
{
  const auto ini = write("my.ini", "[conversion]\nminClearance = 0.4\n");
  expectJson("convert_velodyne", {"convert", kVelodyne, "-o", path("out"), "--static",
                                  "--resolution", "0.4", "-c", ini});
}
