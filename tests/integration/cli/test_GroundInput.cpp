#include <gtest/gtest.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <cmath>

#include "GroundRuns.h"
#include "OctreeFiles.h"
#include "ScanFiles.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

// What `mapconv ground` takes, and what it says of what it cannot take.

namespace
{
const std::string kUtm = MRPT_MAPCONV_SHARED_DIR "/reports/utm.rawlog";

class GroundInput : public GroundRuns
{
 protected:
  /** A level floor of 4 x 4 m at z = 0.5 with a table, as points of a scan. */
  static std::vector<mrpt::math::TPoint3Df> room()
  {
    std::vector<mrpt::math::TPoint3Df> points;
    for (float x = 0.125f; x < 4; x += 0.25f)
      for (float y = 0.125f; y < 4; y += 0.25f)
      {
        points.emplace_back(x, y, 0.5f);
        if (x > 1 && x < 2 && y > 1 && y < 2) points.emplace_back(x, y, 1.5f);
      }
    return points;
  }
  /** Expects of a log the floor and the table of room(), `x` m along. */
  void expectRoom(const std::string& file, const std::string& kind, double x = 0) const
  {
    const auto json = mapped(file);
    EXPECT_TRUE(contains(json["inputKind"].text, kind)) << json["inputKind"].text;
    EXPECT_EQ(json["points"].number, 16 * 16 + 4 * 4);
    EXPECT_EQ(json["groundPoints"].number, 16 * 16);
    EXPECT_EQ(json["xMin"].number, x);
    EXPECT_EQ(json["aboveGroundMax"].number, 1);
    for (const double height : cellsOf("ground")) EXPECT_EQ(height, 0.5);
  }
};
}  // namespace

TEST_F(GroundInput, scansGiveTheirPointsInTheMapFrame)
{
  writeObjects(path("a.rawlog"), {robotAt(8, 0), cloudOn(room(), {0, 0, 2}, 0.5), robotAt(8, 1)});
  expectRoom("a.rawlog", "rawlog", 8);
  writeSimpleMap(path("a.simplemap"), {cloudOn(room(), {0, 0, 2}, 0)});
  expectRoom("a.simplemap", "simplemap");
}

TEST_F(GroundInput, scansIn2DAreLeftOutWithAWarning)
{
  writeObjects(path("a.rawlog"), {robotAt(0, 0), scan2D(0.25), cloudOn(room(), {0, 0, 2}, 0.5),
                                  scan2D(0.75), robotAt(0, 1)});
  const auto run = ground("a.rawlog", {"--json"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "2 2D scans are left out: they see no ground")) << run.err;
  EXPECT_EQ(parseJson(run.out)["points"].number, 16 * 16 + 4 * 4);
  writeObjects(path("flat.rawlog"), {robotAt(0, 0), scan2D(0.5), scan2D(0.6), robotAt(0, 1)});
  expectError("flat.rawlog", {}, {"flat.rawlog: none of its scans has a 3D point, 2 are 2D"});
}

TEST_F(GroundInput, voxelMapsGiveTheirOccupiedVoxels)
{
  octomap::OcTree tree(0.25);
  for (const auto& p : room()) tree.updateNode(octomap::point3d(p.x, p.y, p.z + 0.1f), true);
  tree.updateNode(octomap::point3d(1, 1, -3), false);
  writeTree(tree, path("a.bt"));
  auto map = mrpt::maps::COctoMap::Create(0.25);
  for (const auto& p : room()) map->updateVoxel(p.x, p.y, p.z + 0.1f, true);
  writeObjects(path("a.octomap"), {map});
  for (const auto& [file, kind] :
       {std::pair<std::string, std::string>{"a.bt", "OctoMap file (OcTree)"},
        {"a.octomap", "mrpt::maps::COctoMap (OcTree)"}})
  {
    const auto json = mapped(file);
    EXPECT_EQ(json["inputKind"].text, kind + ", 272 occupied voxels");
    EXPECT_EQ(json["groundPoints"].number, 16 * 16);
    for (const double height : cellsOf("ground")) EXPECT_EQ(height, 0.625) << "the voxels' middle";
  }
  octomap::OcTree empty(0.25);
  empty.updateNode(octomap::point3d(1, 1, 1), false);
  writeTree(empty, path("free.bt"));
  expectError("free.bt", {}, {"free.bt: not one of its voxels is occupied"});
}

TEST_F(GroundInput, originAndSystemAreInTheGeoTiffAndHeightsHaveTheOriginsZ)
{
  auto cloud = Hillside::bareCloud();
  cloud.origin = {600000, 5000000, 400};
  writeCloud("a.csv", cloud);
  const auto json = mapped("a.csv", {"--origin", "599990,5000010,380", "--crs", "EPSG:32632"});
  EXPECT_EQ(json["xMin"].number, 600000);
  EXPECT_EQ(json["originZ"].number, 380);
  EXPECT_EQ(json["crs"].text, "EPSG:32632");
  EXPECT_EQ(json["groundMin"].number, 400 + Hillside::ground(0.125));
  EXPECT_TRUE(grid::readGeoReference(path("out/ground.tif")) ==
              (grid::GeoReference{{599990, 5000010, 380}, "EPSG:32632", 1}));
  EXPECT_EQ(raster().transform[0], 600000);
  EXPECT_EQ(raster().transform[3], 5000020);
  EXPECT_NEAR(cellsOf("ground").front(), 20 + Hillside::ground(0.125), 1e-6);
  for (const std::string name : {"ground", "surface"}) EXPECT_EQ(band(name).offset, 380) << name;
  for (const std::string name : {"evidence", "aboveGround", "groundPoints", "allPoints"})
    EXPECT_EQ(band(name).offset, 0) << name;
  const auto text = ground("a.csv").out;
  EXPECT_TRUE(contains(text, "origin       600000, 5000000, 0 m, taken off in pictures\n")) << text;
}

TEST_F(GroundInput, feetBecomeMetresAndTheGeoTiffLiesInFeet)
{
  auto cloud = Hillside::bareCloud();
  cloud.unit = cloud.heightUnit = grid::kFoot;
  writeCloud("feet.csv", cloud);
  const auto json = mapped("feet.csv", {"--unit", "ft"});
  EXPECT_EQ(json["inputKind"].text, "cloud (6464 points in feet)");
  EXPECT_EQ(json["metresPerUnit"].number, 0.3048);
  EXPECT_NEAR(json["groundMax"].number, Hillside::ground(19.875), 1e-6);
  EXPECT_NEAR(raster().transform[1] * 0.3048, 0.25, 1e-9);
  mapped("feet.csv", {"--unit", "ft", "--points", path("back.csv")});
  EXPECT_EQ(readBytes(path("feet.csv")).substr(6, 30), readBytes(path("back.csv")).substr(21, 30))
      << "points are written in the units of the cloud";
}

TEST_F(GroundInput, aLogInUtmLiesWhereTheRobotWas)
{
  if (!std::filesystem::exists(kUtm)) GTEST_SKIP() << kUtm << " is not there";
  const auto run = mapconv({"ground", kUtm, "-o", path("out"), "--json"});
  ASSERT_EQ(0, run.status) << run.err;
  const auto json = parseJson(run.out);
  EXPECT_EQ(json["originX"].number, 448258);
  EXPECT_NEAR(json["xMin"].number, 448257, 0.3);
  EXPECT_NEAR(json["xMax"].number, 448267.2, 0.3);
  EXPECT_NEAR(raster().transform[0], json["xMin"].number, 1e-6);
}

TEST_F(GroundInput, optionsThatHaveNoEffectAreNamed)
{
  writeSimpleMap(path("a.simplemap"), {cloudOn(room(), {0, 0, 2}, 0)});
  writeCloud("a.pcd", Hillside::bareCloud());
  const auto log = ground("a.simplemap", {"--unit", "ft", "--columns", "x,y,z"});
  EXPECT_TRUE(contains(log.err, "--columns, --unit have no effect: " + path("a.simplemap") +
                                    " is no cloud of points"))
      << log.err;
  const auto cloud = ground("a.pcd", {"--static", "--columns", "x,y,z"});
  EXPECT_EQ(0, cloud.status);
  EXPECT_TRUE(contains(cloud.err, "--static has no effect")) << cloud.err;
  EXPECT_TRUE(contains(cloud.err, "--columns has no effect")) << cloud.err;
}

TEST_F(GroundInput, pointsThatAreNotFiniteAreCountedOnce)
{
  write("a.csv", "x,y,z\n0.1,0.1,1\nnan,0,0\n0.1,0.9,1\n0.9,inf,1\n0.9,0.1,1\n0.9,0.9,1\n");
  const auto run = ground("a.csv", {"--json"});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_TRUE(contains(
      run.err, "2 points of " + path("a.csv") + " left out: a coordinate is NaN or infinite"))
      << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_EQ(parseJson(run.out)["points"].number, 4);
}

TEST_F(GroundInput, onePointIsGroundAndSoIsALineOfThem)
{
  write("one.csv", "x,y,z\n1.1,2.1,3\n");
  const auto one = mapped("one.csv");
  EXPECT_EQ(one["groundPoints"].number, 1);
  EXPECT_EQ(one["cells"].number, 1);
  EXPECT_EQ(one["groundMin"].number, 3);
  std::string line = "x,y,z\n";
  for (int i = 0; i < 40; ++i) line += std::to_string(0.125 + 0.25 * i) + ",0.1,1\n";
  write("line.csv", line);
  const auto json = mapped("line.csv");
  EXPECT_EQ(json["groundPoints"].number, 40);
  EXPECT_EQ(json["height"].number, 1);
}

TEST_F(GroundInput, badCloudsAreAnErrorInOneLine)
{
  write("empty.csv", "x,y,z\n");
  expectError("empty.csv", {}, {"empty.csv"});
  write("nan.csv", "x,y,z\nnan,1,1\n");
  expectError("nan.csv", {}, {"nan.csv: holds no usable point"});
  auto withheld = Hillside::bareCloud();
  withheld.withheld.assign(withheld.size(), 1);
  writeCloud("withheld.las", withheld);
  expectError("withheld.las", {}, {"withheld.las: ", "all points are withheld"});
  write("wide.csv", "x,y,z\n0,0,0\n9000,9000,1\n0,9000,1\n");
  expectError("wide.csv", {},
              {"wide.csv: the cloud spans 9000 x 9000 m, too much for cellSize = 0.25 m",
               "0.99 m would do"});
  expectError("wide.csv", {"--cell-size", "10"}, {"too much for clothResolution = 0.5 m"});
  write("text.csv", "x,y,z\n1,2\n");
  expectError("text.csv", {}, {"text.csv: line 2: has 2 columns"});
  expectError("none.csv", {}, {"none.csv"});
}

TEST_F(GroundInput, aClothThatDoesNotComeToRestGetsAWarning)
{
  writeCloud("a.csv", Hillside::bareCloud());
  const auto run = ground("a.csv", {"--max-iterations", "1"});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "did not come to rest in maxIterations = 1 steps")) << run.err;
}

TEST_F(GroundInput, anOriginThatWouldTakePrecisionIsRefusedWithOneThatWouldDo)
{
  write("a.csv", "x,y,z\n10,20,300.125\n11,21,301\n");
  expectError("a.csv", {"--origin", "0,0,1e9"},
              {"a.csv: its z of 300.125 to 301 is more than 100000 from the origin's 1000000000",
               "--origin 0,0,300 would do"});
  expectError(
      "a.csv", {"--origin", "1e9,0,0"},
      {"x of 10 to 11 is more than", "the origin's 1000000000", "--origin 10,0,0 would do"});
  write("high.csv", "x,y,z\n448258.5,5411929,2000300.5\n448259,5411930,2000301\n");
  expectError("high.csv", {}, {"from the origin's 0", "--origin 448258,5411929,2000300 would do"});
  const auto json = mapped("high.csv", {"--origin", "448258,5411929,2000300", "--cell-size", "1"});
  EXPECT_EQ(json["groundMin"].number, 2000300.5);
  write("deep.csv", "x,y,z\n0,0,0\n1,0,1\n0,1,1e10\n");
  expectError("deep.csv", {}, {"no --origin would do"});
}

TEST_F(GroundInput, aSparseCloudGetsAWarningWithAFittingClothOrCell)
{
  write("a.csv", "x,y,z\n0.1,0.1,1\n10.1,0.1,1\n10.1,10.1,1\n0.1,10.1,1\n");
  const auto run = ground("a.csv");
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "the points are 5 m apart, the cloth's particles 0.5 m"))
      << run.err;
  EXPECT_TRUE(contains(run.err, "--cloth-resolution 1.7 is stiffer")) << run.err;
  EXPECT_TRUE(contains(ground("a.csv", {"--cloth-resolution", "2"}).err,
                       "--cell-size 5.1 would give each cell about one"));
}
