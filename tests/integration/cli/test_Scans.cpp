#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/COctoMap.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "Program.h"
#include "Raster.h"
#include "ScanFiles.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
/** Converts a file and expects one row of cells, known where the robot stood (cell numbers). */
void expectColumns(const TempDir& dir, const std::string& file, const std::vector<int>& known,
                   std::vector<std::string> more = {})
{
  std::vector<std::string> arguments = {"convert", dir.path(file), "-o", dir.path("out"),
                                        "--json",  "--max-step",   "0.1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto run = mapconv(arguments);
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue json = parseJson(run.out);
  EXPECT_EQ(0.1, json["resolution"].number);
  EXPECT_EQ(1, json["height"].number);
  EXPECT_EQ(static_cast<double>(known.size()), json["free"].number);

  const Raster raster = readRaster(dir.path("out/layers.tif"));
  ASSERT_EQ(known.back() + 1, raster.width);
  EXPECT_DOUBLE_EQ(0, raster.transform[0]);
  std::vector<double> floor(static_cast<std::size_t>(raster.width), std::nan(""));
  std::vector<double> ceiling = floor;
  for (const int cell : known)
  {
    floor[static_cast<std::size_t>(cell)] = 0.1;
    ceiling[static_cast<std::size_t>(cell)] = 2.1;
  }
  expectCells(floor, raster.bands[0].cells, "floor");
  expectCells(ceiling, raster.bands[1].cells, "ceiling");
}
}  // namespace

TEST(Scans, rawlogPosesAreInterpolatedToTheScansTime)
{
  const TempDir dir;
  writeObjects(dir.path("drive.rawlog"),
               {robotAt(0, 0), lookDown(0), lookDown(0.5), robotAt(1, 1)});
  expectColumns(dir, "drive.rawlog", {0, 5});
}

TEST(Scans, odometryServesWhereThereAreNoPoses)
{
  const TempDir dir;
  writeObjects(dir.path("drive.rawlog"),
               {odometryAt(0, 0), lookDown(0), lookDown(0.2), odometryAt(1, 1)}, true);
  expectColumns(dir, "drive.rawlog", {0, 2});
}

TEST(Scans, aLogMayHaveAnyName)
{
  const TempDir dir;
  writeObjects(dir.path("drive.log"), {robotAt(0, 0), lookDown(0)});
  expectColumns(dir, "drive.log", {0});
}

TEST(Scans, oneScanNeedsNoPose)
{
  const TempDir dir;
  writeObjects(dir.path("one.rawlog"), {lookDown(0)});
  expectColumns(dir, "one.rawlog", {0});
}

TEST(Scans, severalScansWithoutPosesNeedStatic)
{
  const TempDir dir;
  writeObjects(dir.path("two.rawlog"), {lookDown(0), lookDown(1)});
  const auto run = mapconv({"convert", dir.path("two.rawlog"), "-o", dir.path("out")});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "two.rawlog")) << run.err;
  EXPECT_TRUE(contains(run.err, "static")) << run.err;
  EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
  expectColumns(dir, "two.rawlog", {0}, {"--static"});
}

TEST(Scans, simplemapsAreReadPlainAndGzipped)
{
  const TempDir dir;
  writeSimpleMap(dir.path("a.simplemap"), {0, 0.3}, false);
  expectColumns(dir, "a.simplemap", {0, 3});
  writeSimpleMap(dir.path("b.simplemap.gz"), {0, 0.4}, true);
  expectColumns(dir, "b.simplemap.gz", {0, 4});
  writeSimpleMap(dir.path("c.map"), {0, 0.5}, true);
  expectColumns(dir, "c.map", {0, 5});
}

TEST(Scans, resolutionIsThatOfTheVoxelMap)
{
  const TempDir dir;
  writeObjects(dir.path("one.rawlog"), {lookDown(0)});
  const auto run = mapconv({"convert", dir.path("one.rawlog"), "-o", dir.path("out"), "--json",
                            "--resolution", "0.5", "--max-step", "0.1"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(0.5, parseJson(run.out)["resolution"].number);
  // ground in voxel 0, sensor in voxel 4
  const Raster raster = readRaster(dir.path("out/layers.tif"));
  expectCells({0.5}, raster.bands[0].cells, "floor");
  expectCells({2.5}, raster.bands[1].cells, "ceiling");
}

TEST(Scans, insertionOptionsComeFromTheIniFile)
{
  const TempDir dir;
  writeObjects(dir.path("one.rawlog"), {lookDown(0)});
  std::ofstream(dir.path("near.ini")) << "[voxelInsertion]\nmaxrange = 1.5\n";
  const auto run = mapconv({"convert", dir.path("one.rawlog"), "-o", dir.path("out"), "-c",
                            dir.path("near.ini"), "--json", "--max-step", "0.1"});
  ASSERT_EQ(0, run.status) << run.err;
  // The beam ends in the air 1.5 m below the sensor, in the voxel at 0.5 m, free as all above.
  const Raster raster = readRaster(dir.path("out/layers.tif"));
  ASSERT_EQ(1u, raster.bands[0].cells.size());
  EXPECT_NEAR(0.55, raster.bands[0].cells[0], 0.051);
  EXPECT_NEAR(2.1, raster.bands[1].cells[0], 1e-6);
}

TEST(Scans, badPointsAreLeftOutWithAWarning)
{
  const TempDir dir;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  writeObjects(dir.path("nan.rawlog"), {lookDown(0), badPoint(nan, 1), badPoint(inf, 2)});
  expectColumns(dir, "nan.rawlog", {0}, {"--static"});
  const auto run = mapconv(
      {"convert", dir.path("nan.rawlog"), "-o", dir.path("out"), "--static", "--max-step", "0.1"});
  EXPECT_GE(warningsIn(run.err), 1) << run.err;
  EXPECT_TRUE(contains(run.err, "NaN")) << run.err;
}

TEST(Scans, onlyBadPointsAreAnError)
{
  const TempDir dir;
  writeObjects(dir.path("nan.rawlog"), {badPoint(std::numeric_limits<float>::quiet_NaN(), 0)});
  const auto run = mapconv({"convert", dir.path("nan.rawlog"), "-o", dir.path("out")});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(contains(run.err, "mapconv: error: ")) << run.err;
  EXPECT_TRUE(contains(run.err, "nan.rawlog")) << run.err;
  EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
}

TEST(Scans, anOctomapInsideASerializedMapIsRead)
{
  const TempDir dir;
  auto map = mrpt::maps::COctoMap::Create(0.1);
  for (int z = 0; z < 21; ++z) map->updateVoxel(0.05, 0.05, 0.1 * z + 0.05, z == 0);
  writeObjects(dir.path("octo.map"), {mrpt::maps::COccupancyGridMap2D::Create(), map});
  expectColumns(dir, "octo.map", {0});
}

TEST(Scans, aMapWithoutOctomapIsNamed)
{
  const TempDir dir;
  writeObjects(dir.path("grid.gridmap"), {mrpt::maps::COccupancyGridMap2D::Create()}, true);
  const auto run = mapconv({"convert", dir.path("grid.gridmap"), "-o", dir.path("out")});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "COccupancyGridMap2D")) << run.err;
}
