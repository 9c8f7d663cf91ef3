#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>
#include <set>

#include "OctreeFiles.h"
#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
/** The hand-worked map, converted once for all tests of this file. */
class Convert : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    s_dir = std::make_unique<TempDir>();
    HandMap::write(s_dir->path("hand.bt"));
    s_outcome = mapconv({"convert", s_dir->path("hand.bt"), "-o", s_dir->path("out"), "--paper",
                         "--slope-window", "1", "--json"});
  }
  static void TearDownTestSuite() { s_dir.reset(); }

  static std::string input() { return s_dir->path("hand.bt"); }
  static std::string output(const std::string& name) { return s_dir->path("out/" + name); }

  static std::unique_ptr<TempDir> s_dir;
  static Outcome s_outcome;
};
std::unique_ptr<TempDir> Convert::s_dir;
Outcome Convert::s_outcome;

std::set<std::string> filesIn(const std::string& dir)
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(dir))
    names.insert(entry.path().filename().string());
  return names;
}

/** Cells of a P5 image of the map's size, by rows from the lowest y. */
std::vector<int> pgmOf(const std::string& path)
{
  const std::string bytes = readBytes(path);
  const std::string header = "P5\n5 3\n255\n";
  EXPECT_EQ(header, bytes.substr(0, header.size()));
  EXPECT_EQ(header.size() + 15, bytes.size());
  std::vector<int> cells;
  for (int row = HandMap::height - 1; row >= 0; --row)
    for (int column = 0; column < HandMap::width; ++column)
      cells.push_back(static_cast<unsigned char>(
          bytes.at(header.size() + static_cast<std::size_t>(row * HandMap::width + column))));
  return cells;
}
}  // namespace

TEST_F(Convert, succeeds)
{
  EXPECT_EQ(0, s_outcome.status) << s_outcome.err;
  // 2 m of step go unnoticed
  EXPECT_EQ(1, warningsIn(s_outcome.err)) << s_outcome.err;
  EXPECT_TRUE(contains(s_outcome.err, "minStep = 2.00 m")) << s_outcome.err;
  EXPECT_TRUE(contains(s_outcome.err, "--max-step")) << s_outcome.err;
}

TEST_F(Convert, writesAllFilesAndNoOther)
{
  const std::set<std::string> expected = {
      "layers.tif", "voxels.bt",   "aerial.gridmap", "ground.gridmap", "aerial.pgm", "aerial.yaml",
      "ground.pgm", "ground.yaml", "floor.png",      "ceiling.png",    "slope.png",  "aerial.png",
      "ground.png", "map.3Dscene", "support.png",    "evidence.png"};
  EXPECT_EQ(expected, filesIn(s_dir->path("out")));
}

TEST_F(Convert, geoTiffHoldsTheHandWorkedLayers)
{
  const Raster raster = readRaster(output("layers.tif"));
  EXPECT_EQ(HandMap::width, raster.width);
  EXPECT_EQ(HandMap::height, raster.height);
  const std::array<double, 6> expected = {HandMap::xMin, 0.5, 0, HandMap::yMax, 0, -0.5};
  EXPECT_EQ(expected, raster.transform);

  const std::vector<std::pair<std::string, const std::vector<double>*>> bands = {
      {"floor", &HandMap::floor},      {"ceiling", &HandMap::ceiling}, {"slope", &HandMap::slope},
      {"aerial", &HandMap::aerial},    {"ground", &HandMap::ground},   {"support", &HandMap::floor},
      {"evidence", &HandMap::evidence}};
  ASSERT_EQ(bands.size(), raster.bands.size());
  for (std::size_t i = 0; i < bands.size(); ++i)
  {
    EXPECT_EQ(bands[i].first, raster.bands[i].name);
    EXPECT_EQ("Float32", raster.bands[i].type);
    EXPECT_TRUE(raster.bands[i].noDataIsNan);
    expectCells(*bands[i].second, raster.bands[i].cells, bands[i].first);
  }
}

TEST_F(Convert, jsonIsOneObjectWithTheHandWorkedCounts)
{
  const JsonValue json = parseJson(s_outcome.out);
  EXPECT_EQ(HandMap::resolution, json["resolution"].number);
  EXPECT_EQ(HandMap::width, json["width"].number);
  EXPECT_EQ(HandMap::height, json["height"].number);
  EXPECT_EQ(HandMap::free, json["free"].number);
  EXPECT_EQ(HandMap::occupied, json["occupied"].number);
  EXPECT_EQ(HandMap::unknown, json["unknown"].number);
  EXPECT_EQ(HandMap::steep, json["steep"].number);
  EXPECT_EQ(HandMap::slopeUnknown, json["slopeUnknown"].number);
  EXPECT_DOUBLE_EQ(HandMap::minStep, json["minStep"].number);
  EXPECT_EQ(HandMap::xMin, json["xMin"].number);
  EXPECT_EQ(HandMap::yMax, json["yMax"].number);
  EXPECT_EQ(input(), json["input"].text);
  EXPECT_EQ(1, json["parameters"]["slopeWindow"].number);
  for (const char* stage : {"load", "convert", "write"})
  {
    EXPECT_GT(json["seconds"][stage].number, 0) << stage;
    EXPECT_LT(json["seconds"][stage].number, 60) << stage;
  }
}

TEST_F(Convert, gridMapsAreMrptsOwn)
{
  for (const std::string name : {"aerial", "ground"})
  {
    mrpt::io::CFileGZInputStream stream(output(name + ".gridmap"));
    auto archive = mrpt::serialization::archiveFrom(stream);
    const auto object = archive.ReadObject();
    ASSERT_STREQ("mrpt::maps::COccupancyGridMap2D", object->GetRuntimeClass()->className);
    const auto map = std::dynamic_pointer_cast<mrpt::maps::COccupancyGridMap2D>(object);
    ASSERT_EQ(5u, map->getSizeX());
    ASSERT_EQ(3u, map->getSizeY());
    EXPECT_FLOAT_EQ(-1.0F, map->getXMin());
    EXPECT_FLOAT_EQ(0.5F, map->getYMin());
    const auto& layer = name == "aerial" ? HandMap::aerial : HandMap::ground;
    for (int i = 0; i < 15; ++i)
    {
      const float pFree = map->getCell(i % 5, i / 5);
      const double value = layer[static_cast<std::size_t>(i)];
      const float expected = value == 0 ? 1.0F : value > 0 ? 0.0F : 0.5F;  // 0.75 below
      if (value == 0.75)
        EXPECT_LT(pFree, 0.5F) << name << i;
      else
        EXPECT_NEAR(expected, pFree, 0.02F) << name << i;
    }
  }
}

TEST_F(Convert, rosMapsAreTrinary)
{
  for (const std::string name : {"aerial", "ground"})
  {
    const auto& layer = name == "aerial" ? HandMap::aerial : HandMap::ground;
    const auto pixels = pgmOf(output(name + ".pgm"));
    for (std::size_t i = 0; i < layer.size(); ++i)
      EXPECT_EQ(layer[i] == 0 ? 254 : layer[i] > 0 ? 0 : 205, pixels[i]) << name << i;
    const std::string yaml = readBytes(output(name + ".yaml"));
    EXPECT_TRUE(contains(yaml, "image: " + name + ".pgm")) << yaml;
    EXPECT_TRUE(contains(yaml, "resolution: 0.5")) << yaml;
    EXPECT_TRUE(contains(yaml, "origin: [-1")) << yaml;
    EXPECT_TRUE(contains(yaml, "occupied_thresh: 0.65")) << yaml;
    EXPECT_TRUE(contains(yaml, "free_thresh: 0.196")) << yaml;
  }
}

TEST_F(Convert, picturesAreWholePngs)
{
  for (const std::string name : {"floor", "ceiling", "slope", "aerial", "ground"})
  {
    const std::string bytes = readBytes(output(name + ".png"));
    EXPECT_EQ("\x89PNG", bytes.substr(0, 4)) << name;
    EXPECT_TRUE(contains(bytes.substr(bytes.size() - 12), "IEND")) << name;
  }
}

TEST_F(Convert, sceneHoldsFloorOccupancyAndGrid)
{
  mrpt::opengl::COpenGLScene scene;
  ASSERT_TRUE(scene.loadFromFile(output("map.3Dscene")));
  EXPECT_TRUE(scene.getByName("floor"));
  EXPECT_TRUE(scene.getByName("occupancy"));
  EXPECT_TRUE(scene.getByClass<mrpt::opengl::CGridPlaneXY>());
}

TEST_F(Convert, summaryIsForPeople)
{
  const TempDir dir;
  const auto run =
      mapconv({"convert", input(), "-o", dir.path("out"), "--paper", "--slope-window", "1"});
  ASSERT_EQ(0, run.status) << run.err;
  for (const char* part : {"15 (5 x 3)", "2.50 x 1.50 m", "10 free", "2 occupied", "3 unknown",
                           "of the free cells of aerial 1 are too steep", "minStep", "2.00 m",
                           "load", "convert", "write"})
    EXPECT_TRUE(contains(run.out, part)) << part << " in\n" << run.out;
}

TEST_F(Convert, maxStepMarksTheLedgeAndWhatLiesBelowIt)
{
  const TempDir dir;
  const auto run = mapconv({"convert", input(), "-o", dir.path("out"), "--slope-window", "1",
                            "--max-step", "0.9", "--json"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(HandMap::steepWithMaxStep09, parseJson(run.out)["steep"].number);
}

TEST_F(Convert, aLowMaxStepNeedsNoWarning)
{
  const TempDir dir;
  const auto run = mapconv({"convert", input(), "-o", dir.path("out"), "--max-step", "0.3"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ("", run.err);
}

TEST_F(Convert, otFilesAndAnyExtensionAreRead)
{
  const TempDir dir;
  ASSERT_TRUE(HandMap::tree().write(dir.path("hand.ot")));
  std::filesystem::copy(input(), dir.path("hand.map"));
  for (const std::string name : {"hand.ot", "hand.map"})
  {
    const auto run = mapconv({"convert", dir.path(name), "-o", dir.path("out"), "--json"});
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_EQ(HandMap::free, parseJson(run.out)["free"].number) << name;
  }
}

TEST_F(Convert, oneThreadOrManyMakeNoDifference)
{
  const TempDir dir;
  for (const std::string threads : {"1", "2"})
    ASSERT_EQ(0, mapconv({"convert", input(), "-o", dir.path(threads), "--paper", "--slope-window",
                          "1", "--threads", threads})
                     .status);
  for (const std::string name : {"layers.tif", "aerial.pgm", "ground.pgm"})
    EXPECT_EQ(readBytes(output(name)), readBytes(dir.path("1/" + name))) << name;
  EXPECT_EQ(readBytes(dir.path("1/layers.tif")), readBytes(dir.path("2/layers.tif")));
}

TEST_F(Convert, replacesItsFilesAndLeavesOthersAlone)
{
  const TempDir dir;
  std::filesystem::create_directory(dir.path("out"));
  std::ofstream(dir.path("out/notes.txt")) << "mine";
  std::ofstream(dir.path("out/aerial.pgm")) << "old";
  ASSERT_EQ(0, mapconv({"convert", input(), "-o", dir.path("out")}).status);
  EXPECT_EQ("mine", readBytes(dir.path("out/notes.txt")));
  EXPECT_EQ(readBytes(output("aerial.pgm")), readBytes(dir.path("out/aerial.pgm")));
  EXPECT_EQ(17u, filesIn(dir.path("out")).size());
}

TEST_F(Convert, clearanceThatIsNowhereGivesUnknownLayersAndAWarning)
{
  const TempDir dir;
  const auto run = mapconv({"convert", input(), "-o", dir.path("out"), "--min-clearance", "7.25",
                            "--max-step", "0.1", "--json"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "minClearance = 7.25")) << run.err;
  EXPECT_EQ(15, parseJson(run.out)["unknown"].number);
  for (const int pixel : pgmOf(dir.path("out/aerial.pgm"))) EXPECT_EQ(205, pixel);
}

TEST_F(Convert, optionsForScansAreNamedAsUselessForAnOctree)
{
  const TempDir dir;
  const auto run = mapconv({"convert", input(), "-o", dir.path("out"), "--max-step", "0.1",
                            "--resolution", "0.25", "--static"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "--resolution 0.25")) << run.err;
  EXPECT_TRUE(contains(run.err, "hand.bt")) << run.err;
  EXPECT_TRUE(contains(run.err, "--static")) << run.err;
}
