#include <gtest/gtest.h>

#include "ExperimentFiles.h"

using namespace mrpt_mapconv::testing;

namespace
{
const std::string kIni = kConfig + "experiments/terrain.ini";
const std::vector<std::string> kWorlds = {"stairs", "platforms", "warehouse"};

/** The experiment's file with paths that hold everywhere. */
std::string iniText()
{
  std::string text = readBytes(kIni);
  for (const std::string& world : kWorlds)
    text = replaced(text, "../worlds/" + world, kConfig + "worlds/" + world);
  return text;
}

/** The same of one world alone, at one resolution. */
std::string smallIni()
{
  std::string text = replaced(iniText(), "stairs platforms warehouse", "stairs");
  text = replaced(text, "0.005 0.01 0.02 0.05 0.1 ", "0.1 ");
  text = replaced(text, "24.69 19.17 11.44 6.73", "");
  text = replaced(text, "26.71 21.36 14.16 9.82", "");
  text = replaced(text, "27.84 22.27 14.79 10.27", "");
  for (const char* others : {"[platforms]", "[warehouse]", "[flight.dock]"})
  {
    const auto at = text.find(others), end = text.find("\n\n", at);
    text.erase(at, end - at);
  }
  return text;
}
}  // namespace

TEST(TerrainExperiment, WritesTablesPlotsAndPictures)
{
  const TempDir dir;
  const Outcome outcome = mapconv({"experiment", kIni, "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ("", outcome.err);
  const std::string report = readBytes(dir.path("out/report.md"));
  EXPECT_EQ(report, outcome.out);
  for (const char* part : {"Mapping time", "0.523", "62.7 %", "Stairs", "Real scans", "Voxblox"})
    EXPECT_TRUE(contains(report, part)) << part;
  for (const std::string& world : kWorlds)
    for (const char* picture : {"_height.png", "_plane.png", "_leaves.png"})
      EXPECT_EQ("\x89PNG", readBytes(dir.path("out/" + world + picture)).substr(0, 4)) << world;
  for (const char* plot : {"height_errors.png", "stairs_flight_a.png"})
    EXPECT_EQ("\x89PNG", readBytes(dir.path(std::string("out/") + plot)).substr(0, 4)) << plot;

  const auto times = tableRows(dir.path("out/times.csv"));
  ASSERT_EQ(9u, times.size());  // a header, three worlds and all at two resolutions
  for (const Row& row : times) EXPECT_EQ(10u, row.size());
  // planes and steps of either rule
  EXPECT_EQ(13u, tableRows(dir.path("out/planes.csv")).size());
  EXPECT_EQ(25u, tableRows(dir.path("out/flights.csv")).size());
  EXPECT_EQ(29u, tableRows(dir.path("out/steps.csv")).size());
}

TEST(TerrainExperiment, ErrorsGrowWithTheNoiseOfPoses)
{
  const TempDir dir;
  ASSERT_EQ(0, mapconv({"experiment", kIni, "-o", dir.path("out"), "--quick"}).status);
  const auto errors = tableRows(dir.path("out/height_errors.csv"));
  ASSERT_EQ(19u, errors.size());
  for (const std::string& world : kWorlds)
  {
    const Row exact = rowWith(errors, {world, "0.05", "0"}),
              noisy = rowWith(errors, {world, "0.05", "5"});
    for (std::size_t map = 4; map < 8; ++map)
      EXPECT_LT(number(exact, map), number(noisy, map)) << world << " " << errors[0].at(map);
    EXPECT_LT(number(exact, 4), number(exact, 5)) << "the highest points are too high: " << world;
    EXPECT_TRUE(contains(rowWith(errors, {world, "0.05", "1"}).at(9), "62.7 %")) << world;
    EXPECT_EQ("", exact.at(9)) << "targets are for the world's noise";
  }
  const auto far = tableRows(dir.path("out/height_errors_far_from_jumps.csv"));
  ASSERT_EQ(19u, far.size());
  for (std::size_t i = 1; i < far.size(); ++i) EXPECT_LE(number(far[i], 3), number(errors[i], 3));
}

TEST(TerrainExperiment, LeavesAreFewerThanCells)
{
  const TempDir dir;
  ASSERT_EQ(0, mapconv({"experiment", kIni, "-o", dir.path("out"), "--quick"}).status);
  const auto sizes = tableRows(dir.path("out/sizes.csv"));
  ASSERT_EQ(7u, sizes.size());
  for (std::size_t i = 1; i < sizes.size(); ++i)
  {
    EXPECT_LT(number(sizes[i], 3), number(sizes[i], 2)) << i;
    EXPECT_GE(number(sizes[i], 2), number(sizes[i], 7)) << "the baseline forgets cells " << i;
  }
}

TEST(TerrainExperiment, RealScansMayBeMissing)
{
  const TempDir dir;
  const std::string log = "../../../shared/data/vlp16_3scans.rawlog";
  std::ofstream(dir.path("e.ini")) << replaced(smallIni(), log, "none.rawlog");
  const Outcome outcome =
      mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "Left out: there is no ")) << outcome.out;
  EXPECT_FALSE(std::filesystem::exists(dir.path("out/real_residuals.csv")));
}

TEST(TerrainExperiment, RealScansHavePlanes)
{
  const std::string log = MRPT_MAPCONV_SHARED_DIR "/vlp16_3scans.rawlog";
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "no vlp16_3scans.rawlog";
  const TempDir dir;
  std::ofstream(dir.path("e.ini"))
      << replaced(smallIni(), "../../../shared/data/vlp16_3scans.rawlog", log);
  ASSERT_EQ(0, mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out"), "--quick"}).status);
  const auto rows = tableRows(dir.path("out/real_residuals.csv"));
  ASSERT_GT(rows.size(), 2u);
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    EXPECT_GE(number(rows[i], 3), 12) << i;
    EXPECT_LT(number(rows[i], 4), 30) << "fused heights of a plane lie within its tolerance " << i;
  }
}

TEST(TerrainExperiment, BadFilesAreNamed)
{
  const TempDir dir;
  const std::string good = iniText();
  const auto error = [&](const std::string& from, const std::string& to)
  { return experimentError(dir, replaced(good, from, to)); };
  EXPECT_TRUE(contains(error("worlds      = ", "; "), "worlds = NAME"));
  EXPECT_TRUE(contains(error("stairs platforms", "stairs stairs"), "each world once"));
  EXPECT_TRUE(contains(error("stairs platforms", "stairs cellar"), "'cellar'"));
  EXPECT_TRUE(contains(error("worlds/stairs.ini", "worlds/none.ini"), "none.ini"));
  EXPECT_TRUE(contains(error("0.005 0.01", "0.01 0.005"), "resolutions = '0.01 0.005"));
  EXPECT_TRUE(contains(error("resolutions = 0.005", "; "), "resolutions = M"));
  EXPECT_TRUE(contains(error("0 1 5", "0 5"), "section 'experiment': poseNoise = '0 5'"));
  EXPECT_TRUE(contains(error("repetitions = 2", "repetitions = 0"), "repetitions = '0'"));
  EXPECT_TRUE(contains(error("maxScans    = 0", "maxScans = -1"), "maxScans = '-1'"));
  EXPECT_TRUE(contains(error("overlap     = 0.8", "overlap = 0.5"), "overlap = '0.5'"));
  EXPECT_TRUE(contains(error("[terrain] ", "[terrain]\nplaneTolerance = 0\n;"),
                       "section 'terrain': planeTolerance = 0"));
  EXPECT_TRUE(contains(error("[terrain] ", "[terrain]\nheightRule = fused\n;"),
                       "section 'terrain': heightRule"));
  EXPECT_TRUE(contains(error("24.69 ", ""), "section 'paper': theirs"));
  EXPECT_TRUE(contains(error("world = stairs", "world = cave"), "section 'flight.a': world"));
  EXPECT_TRUE(contains(error("1.2 0.8  3.4 0.8", "1.2 0.8 1.2 0.8"), "section 'flight.a': line"));
  EXPECT_TRUE(contains(error("[real]", "[reel]"), "section 'reel'"));
  EXPECT_TRUE(contains(error("staticSensor = true", "maxRange = -1"), "section 'real': maxRange"));
}
