#include <gtest/gtest.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <filesystem>
#include <fstream>

#include "PathRows.h"
#include "Program.h"
#include "Raster.h"
#include "ScanFiles.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
constexpr double kX = 448258, kY = 5411929;
const std::string kUtm = MRPT_MAPCONV_SHARED_DIR "/reports/utm.rawlog";

std::vector<std::string> operator+(std::vector<std::string> words,
                                   const std::vector<std::string>& more)
{
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/** The commands that make maps of logs, and their GeoTIFFs. */
struct Maker
{
  std::string command, tiff, yaml;
  std::vector<std::string> flags;
};
const std::vector<Maker> kMakers = {
    {"convert", "layers.tif", "ground.yaml", {}},
    {"project", "projection.tif", "projection.yaml", {"--z-min", "0.2", "--z-max", "1.5"}},
    {"insert", "map.tif", "map.yaml", {"--no-reflection-filter"}},
    {"terrain", "layers.tif", "traversability.yaml", {}}};

class FarCoordinates : public ::testing::Test
{
 protected:
  std::string path(const std::string& name) const { return m_dir.path(name); }
  Outcome make(const Maker& maker, const std::string& log,
               const std::vector<std::string>& flags = {}) const
  {
    return mapconv(std::vector<std::string>{maker.command, log, "-o", path(maker.command)} +
                   maker.flags + flags);
  }
  /** A hall of 6 x 4 m around a robot at (x, y, 200), as a keyframe: floor, and a wall at its end.
   */
  void writeHall(const std::string& name, double x = kX, double y = kY) const
  {
    std::vector<mrpt::math::TPoint3Df> points;
    for (float along = -2.95f; along < 3; along += 0.1f)
      for (float across = -1.95f; across < 2; across += 0.1f)
        points.emplace_back(along, across, 0.05f);
    for (float across = -1.95f; across < 2; across += 0.1f)
      for (float height = 0.15f; height < 2; height += 0.1f)
        points.emplace_back(2.95f, across, height);
    mrpt::maps::CSimpleMap map;
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(cloudOn(points, {0, 0, 2}, 0));
    mrpt::poses::CPose3DPDFGaussian pose(mrpt::poses::CPose3D(x, y, 200, 0, 0, 0));
    map.insert(pose, *frame);
    ASSERT_TRUE(map.saveToFile(path(name)));
  }
  /** The hall, converted. */
  std::string hall(const std::vector<std::string>& flags = {}) const
  {
    writeHall("hall.simplemap");
    const auto run =
        mapconv(std::vector<std::string>{"convert", path("hall.simplemap"), "-o", path("hall"),
                                         "--resolution", "0.1", "--min-clearance", "0.5"} +
                flags);
    EXPECT_EQ(0, run.status) << run.err;
    return path("hall");
  }
  Outcome plan(const std::string& map, const std::string& from, const std::string& to,
               const std::vector<std::string>& flags = {}) const
  {
    return mapconv(std::vector<std::string>{"plan", map, "--robot", "ground", "--from", from,
                                            "--to", to, "--robot-radius", "0.2", "-o",
                                            path("way.csv")} +
                   flags);
  }
  Outcome lift(const std::string& map, const std::string& points) const
  {
    std::ofstream(path("flat.csv")) << points;
    return mapconv({"lift", map, path("flat.csv"), "--robot", "ground", "-o", path("way.csv")});
  }
  /** One error that holds these words. */
  static void expectError(const Outcome& run, const std::string& words)
  {
    EXPECT_EQ(1, run.status);
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    EXPECT_TRUE(contains(run.err, words)) << words << " in: " << run.err;
  }

  TempDir m_dir;
};
}  // namespace

TEST_F(FarCoordinates, everyMapOfALogInUtmLiesWhereTheRobotWas)
{
  if (!std::filesystem::exists(kUtm)) GTEST_SKIP() << kUtm << " is not there";
  for (const auto& maker : kMakers)
  {
    const auto run = make(maker, kUtm, {"--json", "--crs", "EPSG:32633"});
    ASSERT_EQ(0, run.status) << maker.command << run.err;
    const auto json = parseJson(run.out);
    EXPECT_NEAR(json["xMax"].number - json["xMin"].number, 10.2, 0.11) << maker.command;
    EXPECT_NEAR(json["yMax"].number - json["yMin"].number, 8.2, 0.11) << maker.command;
    EXPECT_EQ(json["originX"].number, kX);
    EXPECT_EQ(json["originY"].number, kY);
    EXPECT_EQ(json["originZ"].number, 0);
    EXPECT_EQ(json["crs"].text, "EPSG:32633");

    const std::string tiff = path(maker.command) + "/" + maker.tiff;
    const grid::GeoReference reference = grid::readGeoReference(tiff);
    EXPECT_TRUE(reference == (grid::GeoReference{{kX, kY, 0}, "EPSG:32633", 1}));
    const auto transform = readRaster(tiff).transform;
    EXPECT_NEAR(transform[0], json["xMin"].number, 1e-6) << maker.command;
    EXPECT_NEAR(transform[3], json["yMax"].number, 1e-6) << maker.command;
    EXPECT_TRUE(contains(readBytes(path(maker.command) + "/" + maker.yaml), "origin: [44825"));
  }
}

TEST_F(FarCoordinates, anOriginIsTakenAsGiven)
{
  if (!std::filesystem::exists(kUtm)) GTEST_SKIP() << kUtm << " is not there";
  for (const auto& maker : kMakers)
  {
    const auto own = parseJson(make(maker, kUtm, {"--json"}).out);
    const auto run = make(maker, kUtm, {"--json", "--origin", "448250,5411920,-3"});
    ASSERT_EQ(0, run.status) << maker.command << run.err;
    const auto given = parseJson(run.out);
    EXPECT_EQ(given["originX"].number, 448250);
    EXPECT_EQ(given["originZ"].number, -3);
    for (const char* edge : {"xMin", "xMax", "yMin", "yMax"})
      EXPECT_NEAR(given[edge].number, own[edge].number, 0.2) << maker.command << edge;
    const auto text = make(maker, kUtm, {"--origin", "448250,5411920,-3"}).out;
    EXPECT_TRUE(contains(text, "origin       448250, 5411920, -3 m, taken off in ")) << text;
  }
}

TEST_F(FarCoordinates, anOriginThatWouldTakePrecisionIsRefused)
{
  writeHall("hall.simplemap");
  for (const auto& maker : kMakers)
    for (const std::string origin : {"448258,5411929,1e9", "1e9,5411929,200"})
    {
      const auto run = make(maker, path("hall.simplemap"), {"--origin", origin});
      EXPECT_EQ(1, run.status) << maker.command;
      EXPECT_TRUE(isOneError(run.err)) << run.err;
      EXPECT_TRUE(contains(run.err, "hall.simplemap: its ")) << run.err;
      EXPECT_TRUE(contains(run.err, "--origin 448258,5411929,200 would do")) << run.err;
    }
}

TEST_F(FarCoordinates, posesOfSimplemapsGetAnOriginByThemselves)
{
  writeHall("hall.simplemap");
  for (const auto& maker : kMakers)
  {
    const auto run = make(maker, path("hall.simplemap"), {"--json"});
    if (maker.command == "project") continue;  // its heights are those of the coordinates
    ASSERT_EQ(0, run.status) << maker.command << run.err;
    EXPECT_EQ(parseJson(run.out)["originX"].number, kX) << maker.command;
    EXPECT_EQ(parseJson(run.out)["originY"].number, kY) << maker.command;
  }
}

TEST_F(FarCoordinates, mapsNearByHaveNoOrigin)
{
  writeHall("near.simplemap", 9000, -9000);
  const auto run = mapconv({"terrain", path("near.simplemap"), "-o", path("near"), "--json"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_FALSE(parseJson(run.out).has("originX"));
}

TEST_F(FarCoordinates, anOctreeHasAFrameOfItsOwn)
{
  const auto map = hall();
  const auto run = mapconv({"convert", map + "/voxels.bt", "-o", path("again"), "--origin", "1,2,3",
                            "--min-clearance", "0.5"});
  EXPECT_TRUE(contains(run.err, "--origin has no effect: ")) << run.err;
}

TEST_F(FarCoordinates, pathsAreInTheUsersCoordinates)
{
  for (const auto& flags : {std::vector<std::string>{}, {"--origin", "448250,5411920,190"}})
  {
    const auto map = hall(flags);
    const auto run = plan(map, "448257.05,5411928.55", "448259.05,5411929.45", {"--json"});
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_NEAR(parseJson(run.out)["zMin"].number, 200.1, 1e-4);
    auto rows = rowsOf(path("way.csv"));
    EXPECT_EQ(rows.front().x, 448257.05);
    EXPECT_EQ(rows.back().y, 5411929.45);
    EXPECT_NEAR(rows.front().z, 200.1, 1e-4);

    const auto lifted = lift(map, "448257.05,5411928.55\n448259.05,5411929.45\n");
    ASSERT_EQ(0, lifted.status) << lifted.err;
    EXPECT_TRUE(contains(lifted.out, "z from 200.10 to 200.10 m")) << lifted.out;
    rows = rowsOf(path("way.csv"));
    EXPECT_EQ(rows.front().x, 448257.05);
    EXPECT_NEAR(rows.back().z, 200.1, 1e-4);
  }
}

TEST_F(FarCoordinates, messagesTellPlacesInTheUsersCoordinates)
{
  const auto map = hall();
  expectError(plan(map, "448200,5411929", "448258,5411929"),
              "start (448200, 5411929) m is outside the map, which covers x from 448255 to 448261 "
              "m and y from 5411927 to 5411931 m");
  expectError(plan(map, "448258.05,5411929.05", "448260.95,5411929.05"),
              "goal (448260.95, 5411929.05) m is in an occupied cell");
  expectError(lift(map, "448258.05,5411929.05\n448260.95,5411929.05\n"),
              "at (448260.95, 5411929.05): ");
  expectError(lift(map, "8.05,9.05\n"), "point 0 at (8.05, 9.05): it lies outside the map");
}
