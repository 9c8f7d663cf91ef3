#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "GroundRuns.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
class Ground : public GroundRuns
{
 protected:
  Ground() { writeCloud("hill.csv", Hillside::bareCloud()); }

  std::set<std::string> written() const
  {
    std::set<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(path("out")))
      names.insert(file.path().filename().string());
    return names;
  }
  std::string bytesOf(const std::vector<std::string>& flags) const
  {
    mapped("hill.csv", flags + std::vector<std::string>{"--points", path("points.ply")});
    return readBytes(path("out/ground.tif")) + readBytes(path("points.ply"));
  }
};
}  // namespace

TEST_F(Ground, writesAGeoTiffWithItsBandsAndAPictureOfEach)
{
  mapped("hill.csv");
  EXPECT_EQ(written(),
            (std::set<std::string>{"ground.tif", "ground.png", "evidence.png", "surface.png",
                                   "aboveGround.png", "groundPoints.png", "allPoints.png"}));
  const Raster map = raster();
  EXPECT_EQ(map.width, Hillside::kCells);
  EXPECT_EQ(map.height, Hillside::kCells);
  EXPECT_EQ(map.transform[0], 0);
  EXPECT_EQ(map.transform[3], 20);
  EXPECT_EQ(map.transform[1], 0.25);
  std::string bands;
  for (const auto& band : map.bands) bands += band.name + " ";
  EXPECT_EQ(bands, "ground evidence surface aboveGround groundPoints allPoints ");
}

TEST_F(Ground, cellsHaveTheHeightsOfTheHillsideOfTheHouseAndOfTheCrown)
{
  for (const std::string filter : {"csf", "smrf"})
  {
    mapped("hill.csv", {"--ground-filter", filter});
    const Raster map = raster();
    for (int iy = 0; iy < Hillside::kCells; ++iy)
      for (int ix = 0; ix < Hillside::kCells; ++ix)
      {
        const double x = Hillside::middle(ix), y = Hillside::middle(iy);
        const bool isHouse = Hillside::isHouse(x, y), isCrown = Hillside::isCrown(x, y);
        const auto at = [&](const std::string& band)
        { return bandOf(map, band).cells[static_cast<std::size_t>(iy * Hillside::kCells + ix)]; };
        const double above = isHouse ? 4 : isCrown ? 5 : 0;
        const double inferred = isHouse ? 0.1 : 0;  // [m]
        const std::string where = filter + " at " + std::to_string(x) + ", " + std::to_string(y);
        EXPECT_NEAR(at("ground"), Hillside::ground(x), inferred) << where;
        EXPECT_EQ(at("evidence"), isHouse ? 2 : 1) << where;
        EXPECT_EQ(at("surface"), Hillside::ground(x) + above) << where;
        EXPECT_NEAR(at("aboveGround"), above, inferred) << where;
        EXPECT_EQ(at("groundPoints"), isHouse ? 0 : 1) << where;
        EXPECT_EQ(at("allPoints"), isCrown ? 2 : 1) << where;
      }
  }
}

TEST_F(Ground, tellsWhatItFound)
{
  const auto json = mapped("hill.csv");
  EXPECT_EQ(json["inputKind"].text, "cloud (6464 points)");
  EXPECT_EQ(json["output"].text, path("out"));
  EXPECT_EQ(json["resolution"].number, 0.25);
  EXPECT_EQ(json["points"].number, Hillside::kPoints);
  EXPECT_EQ(json["groundPoints"].number, Hillside::kGround);
  EXPECT_EQ(json["cellsWithGroundPoints"].number, Hillside::kGround);
  EXPECT_EQ(json["cellsWithPoints"].number, Hillside::kCells * Hillside::kCells);
  EXPECT_EQ(json["lowPoints"].number, 0);
  EXPECT_EQ(json["withheldPoints"].number, 0);
  EXPECT_EQ(json["groundMin"].number, Hillside::ground(0.125));
  EXPECT_EQ(json["groundMax"].number, Hillside::ground(19.875));
  EXPECT_EQ(json["aboveGroundMax"].number, 5);
  EXPECT_EQ(json["parameters"]["groundFilter"].text, "csf");
  EXPECT_FALSE(json.has("pointsFile"));

  const auto text = ground("hill.csv", {"--cell-size", "0.5"}).out;
  EXPECT_TRUE(
      contains(text, "ground       6144 of 6464 points (95.0 %), by csf on cells of 0.5 m\n"))
      << text;
  EXPECT_TRUE(contains(text,
                       "measured     1536 cells (96.0 %) with ground points; in the others the "
                       "ground is inferred, below other points in 64 cells (4.0 %)\n"))
      << text;
  EXPECT_TRUE(contains(text, "height       ground 0.02 to 2.45 m, the highest point 5.03 m above "))
      << text;
  EXPECT_TRUE(contains(text, "not default  cellSize = 0.5\n")) << text;
}

TEST_F(Ground, anyNumberOfThreadsWritesTheSameBytes)
{
  const std::string one = bytesOf({"--threads", "1"});
  EXPECT_TRUE(one == bytesOf({"--threads", "2"}));
  EXPECT_TRUE(one == bytesOf({"--threads", "7"}));
}

TEST_F(Ground, iniFilesSetParametersAndFlagsWin)
{
  const auto ini = write("my.ini", "[ground]\ncellSize = 0.5\nrigidness = 2\n");
  const auto json = mapped("hill.csv", {"-c", ini, "--rigidness", "1"});
  EXPECT_EQ(json["resolution"].number, 0.5);
  EXPECT_EQ(json["parameters"]["rigidness"].number, 1);
}

TEST_F(Ground, slopeSmoothingIsTrueOrFalse)
{
  EXPECT_FALSE(
      mapped("hill.csv", {"--slope-smoothing", "false"})["parameters"]["slopeSmoothing"].truth);
  EXPECT_TRUE(
      mapped("hill.csv", {"--slope-smoothing", "true"})["parameters"]["slopeSmoothing"].truth);
  const auto run = ground("hill.csv", {"--slope-smoothing", "perhaps"});
  EXPECT_EQ(2, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "--slope-smoothing")) << run.err;
  EXPECT_TRUE(contains(run.err, "perhaps")) << run.err;
}

TEST_F(Ground, theIniFileInConfigChangesNothing)
{
  const auto run = ground("hill.csv", {"-c", MRPT_MAPCONV_SOURCE_DIR "/config/aerial/ground.ini"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ("", run.err);
  EXPECT_FALSE(contains(run.out, "not default")) << run.out;
}

TEST_F(Ground, unknownKeysAndSectionsGetAWarningEach)
{
  const auto ini = write("my.ini", "[ground]\ncellSizes = 0.5\n[cloth]\na = 1\n");
  const auto run = ground("hill.csv", {"-c", ini});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ(2, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, ini + ": [ground] unknown key 'cellSizes' has no effect"))
      << run.err;
  EXPECT_TRUE(contains(run.err, "[cloth]")) << run.err;
}

TEST_F(Ground, wrongValuesAreNamedWithWhatWouldBeRight)
{
  expectError("hill.csv", {"-c", write("a.ini", "[ground]\nrigidness = 0\n")},
              {"a.ini: ", "rigidness = 0", "within 1 and 15"});
  expectError("hill.csv", {"-c", write("b.ini", "[ground]\ngroundFilter = pmf\n")},
              {"b.ini: ", "groundFilter", "'pmf'", "csf", "smrf"});
  expectError("hill.csv", {"-c", write("c.ini", "[ground]\ncellSize = wide\n")},
              {"c.ini: ", "cellSize", "wide"});
  // valid alone, but not together
  expectError("hill.csv", {"--smrf-cell", "20"}, {"smrfWindow = 18", "1 and 200 times smrfCell"});
  const auto usage = ground("hill.csv", {"--cell-size", "1000"});
  EXPECT_EQ(2, usage.status);
  EXPECT_TRUE(isOneError(usage.err)) << usage.err;
  EXPECT_TRUE(contains(usage.err, "cellSize = 1000")) << usage.err;
}

TEST_F(Ground, whatCannotBeWrittenIsSaidBeforeAnyWork)
{
  write("file", "");
  const auto run = mapconv({"ground", path("none.csv"), "-o", path("file/out")});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(contains(run.err, path("file/out"))) << run.err;
}
