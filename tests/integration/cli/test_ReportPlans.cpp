#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>

#include "OctreeFiles.h"
#include "PathRows.h"
#include "Program.h"
#include "StrictJson.h"
#include "support/TempDir.h"

// plan and lift refuse what a robot cannot do: maps of the reports (../shared/data), and small ones
// like them.
namespace
{
using namespace mrpt_mapconv::testing;

class ReportPlans : public ::testing::Test
{
 protected:
  std::string map() const { return m_dir.path("map"); }
  Outcome convert(const std::string& file, std::vector<std::string> flags = {})
  {
    flags.insert(flags.begin(), {"convert", file, "-o", map(), "--json"});
    return mapconv(flags);
  }
  Outcome plan(const std::string& robot, const std::string& from, const std::string& to,
               const std::string& radius, std::vector<std::string> more = {})
  {
    more.insert(more.begin(), {"plan", map(), "--robot", robot, "--from=" + from, "--to=" + to,
                               "--robot-radius", radius, "-o", m_dir.path("path.csv")});
    return mapconv(more);
  }
  Outcome lift(const std::string& robot, const std::string& csv, std::vector<std::string> more = {})
  {
    std::ofstream(m_dir.path("flat.csv")) << csv;
    more.insert(more.begin(), {"lift", map(), m_dir.path("flat.csv"), "--robot", robot, "-o",
                               m_dir.path("lifted.csv")});
    return mapconv(more);
  }
  std::vector<Row> path() const { return rowsOf(m_dir.path("path.csv")); }

  /** Free columns of 0.1 m, 20 × 12, 3 m high, whose floors lie so many voxels up. */
  template <class FloorOf>
  void convertFloors(const FloorOf& floorOf, std::vector<std::string> flags = {})
  {
    std::vector<std::vector<std::string>> columns(12, std::vector<std::string>(20));
    for (std::size_t y = 0; y < 12; ++y)
      for (std::size_t x = 0; x < 20; ++x)
      {
        const auto floor = static_cast<std::size_t>(floorOf(x, y));
        columns[y][x] = std::string(1 + floor, 'o') + std::string(30 - floor, 'f') + "o";
      }
    writeTree(treeOf(0.1, columns, 0, 0), m_dir.path("floors.bt"));
    ASSERT_EQ(0, convert(m_dir.path("floors.bt"), std::move(flags)).status);
  }

  static void expectWords(const Outcome& run, const std::vector<const char*>& words)
  {
    EXPECT_EQ(1, run.status) << run.out;
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    for (const char* word : words) EXPECT_TRUE(contains(run.err, word)) << word << ": " << run.err;
    EXPECT_FALSE(std::regex_search(run.err, std::regex("[0-9]\\.[0-9]{4}"))) << run.err;
  }

  const std::string kShared = MRPT_MAPCONV_SHARED_DIR "/";
  TempDir m_dir;
};

TEST_F(ReportPlans, CasoplonIsCrossedOnTheLevel)
{
  if (!std::filesystem::exists(kShared + "real")) GTEST_SKIP() << kShared << "real is not there";
  ASSERT_EQ(0, convert(kShared + "real/casoplon.bt").status);
  const Outcome run = plan("ground", "3,3", "10,7", "0.2", {"--json"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_NEAR(8.3, parseJson(run.out)["length"].number, 0.2);
  for (const Row& row : path()) EXPECT_NEAR(0.8, row.z, 1e-6);
}

TEST_F(ReportPlans, AFenceThatTheSlopeTestMissesIsNoWay)
{
  if (!std::filesystem::exists(kShared + "reports"))
    GTEST_SKIP() << kShared << "reports is not there";
  ASSERT_EQ(0, convert(kShared + "reports/fence09.bt", {"--paper"}).status);
  expectWords(plan("ground", "-3,0", "3,0", "0.3"),
              {"no path", "at (0.0", "from 0.00 m to 0.90 m",
               "; for a robot that climbs 0.9 m: a map converted with --max-step 0.9\n"});
  EXPECT_FALSE(std::filesystem::exists(m_dir.path("path.csv")));
  expectWords(lift("ground", "-3,0\n3,0\n"),
              {"flat.csv: point 30 at (0.0", "from 0.00 m to 0.90 m", "nothing written"});
  EXPECT_FALSE(std::filesystem::exists(m_dir.path("lifted.csv")));
  EXPECT_EQ(0, lift("ground", "-3,0\n-1,0.5\n").status);
}

TEST_F(ReportPlans, FlightsThatAreMissedSayWhatWouldHelp)
{
  if (!std::filesystem::exists(kShared + "real")) GTEST_SKIP() << kShared << "real is not there";
  ASSERT_EQ(0, convert(kShared + "real/casoplon.bt").status);
  const Outcome run = plan("aerial", "7.3,8.1", "5.5,9.1", "0.3");
  expectWords(run, {"no path", "there is one with --height-offset "});
  const std::string offset = run.err.substr(run.err.find("--height-offset ") + 16, 3);
  EXPECT_EQ(0, plan("aerial", "7.3,8.1", "5.5,9.1", "0.3", {"--height-offset", offset}).status);
}

TEST_F(ReportPlans, AKerbIsGoneAroundWhereItIsLow)
{
  // 0.6 m high but for a ramp at y > 0.9 m
  convertFloors([](std::size_t x, std::size_t y)
                { return x < 8   ? 0
                         : y < 9 ? 6
                                 : std::min<std::size_t>(x - 7, 6); },
                {"--slope-window", "8"});
  const Outcome run = plan("ground", "0.35,0.35", "1.65,0.35", "0");
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_NEAR(0.7, path().back().z, 1e-6);
  double before = 0;
  for (const Row& row : path())
  {
    EXPECT_LE(std::abs(row.z - before), 0.2 + 1e-6) << row.x << ", " << row.y;
    before = row.z;
  }
}

TEST_F(ReportPlans, WhatIsPlannedOverAStepCanBeLifted)
{
  // two voxels, the most that the slope allows from cell to cell, and seen half a metre ahead: from
  // 0.05 m before the start on to just behind it
  convertFloors([](std::size_t x, std::size_t) { return x < 10 ? 0 : 2; });
  for (const char* start : {"0.501,0.52", "0.53,0.52", "0.555,0.52", "0.35,0.35", "0.999,0.75"})
  {
    const Outcome planned = plan("ground", start, "1.7,0.53", "0");
    ASSERT_EQ(0, planned.status) << start << planned.err;
    const Outcome lifted = mapconv({"lift", map(), m_dir.path("path.csv"), "--robot", "ground",
                                    "-o", m_dir.path("lifted.csv")});
    EXPECT_EQ(0, lifted.status) << start << lifted.err;
    const Outcome straight = lift("ground", start + std::string("\n1.7,0.53\n"));
    EXPECT_EQ(0, straight.status) << start << straight.err;
  }
}

TEST_F(ReportPlans, LengthsAreGivenIn3DAndIn2D)
{
  // a ramp of 45 degrees, 1 m long
  convertFloors([](std::size_t x, std::size_t)
                { return x < 5 ? 0 : std::min<std::size_t>(x - 4, 10); });
  const Outcome run = plan("ground", "0.05,0.55", "1.95,0.55", "0", {"--json", "--lookahead", "0"});
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue json = parseJson(run.out);
  EXPECT_NEAR(0.9 + std::sqrt(2.0), json["length"].number, 1e-6);
  EXPECT_NEAR(1.9, json["length2D"].number, 1e-6);
  const Outcome text = lift("ground", "0.05,0.55\n1.95,0.55\n", {"--lookahead", "0"});
  EXPECT_TRUE(contains(text.out, "length       2.31 m, 1.90 m in 2D\n")) << text.out << text.err;
}

TEST_F(ReportPlans, APieceThatCutsAWallsCornerIsRefused)
{
  std::vector<std::vector<std::string>> columns(6, std::vector<std::string>(6, "offffo"));
  columns[2][2] = "oooooo";
  writeTree(treeOf(0.5, columns, 0, 0), m_dir.path("wall.bt"));
  ASSERT_EQ(0, convert(m_dir.path("wall.bt"), {"--min-clearance", "1.5"}).status);
  const std::string cut = "0.95,1.2\n1.2,0.95\n";  // both beside the wall's corner at (1, 1)
  expectWords(lift("ground", cut),
              {"flat.csv: point 1 at (1.0", "something occupied", "nothing written"});
  expectWords(lift("aerial", cut, {"--safety-radius", "0.01"}),
              {"flat.csv: point 1 at (1.0", "something occupied"});
  EXPECT_EQ(0, lift("ground", "0.7,1.2\n1.2,0.7\n").status);
  std::filesystem::remove(map() + "/voxels.bt");
  const Outcome layersOnly = lift("ground", cut);
  EXPECT_EQ(1, layersOnly.status);
  EXPECT_TRUE(contains(layersOnly.err, "something occupied")) << layersOnly.err;
}

TEST_F(ReportPlans, ASmallerRobotIsNamedWhereADoorIsNarrow)
{
  std::vector<std::vector<std::string>> columns(21, std::vector<std::string>(20, "offffffffffo"));
  for (std::size_t y = 0; y < 21; ++y)
    if (y < 7 || y > 13) columns[y][10] = "oooooooooooo";  // leaves 7 cells
  writeTree(treeOf(0.1, columns, 0, 0), m_dir.path("door.bt"));
  ASSERT_EQ(0, convert(m_dir.path("door.bt")).status);
  expectWords(plan("ground", "0.45,1.05", "1.55,1.05", "0.35"),
              {"no path", "--robot-radius 0.3\n"});
  EXPECT_EQ(0, plan("ground", "0.45,1.05", "1.55,1.05", "0.3").status);
}

TEST_F(ReportPlans, AStartThatIsNotFreeSaysWhy)
{
  convertFloors([](std::size_t x, std::size_t) { return x < 10 ? 0 : 9; });
  expectWords(plan("ground", "0.95,0.55", "0.35,0.55", "0"),
              {"start (0.95, 0.55) m is in an occupied cell: the slope there", "maxSlope = 2"});
}

TEST_F(ReportPlans, NumbersInMessagesAreRounded)
{
  // a slope of 1 in x and 1/3 in y; behind it a ledge
  convertFloors([](std::size_t x, std::size_t y)
                { return std::min<std::size_t>(x, 8) + y / 3 + (x > 14 ? 9 : 0); },
                {"--max-slope", "1.5"});
  expectWords(plan("ground", "1.551234,0.35", "0.351234,0.55", "0"),
              {"start (1.551, 0.35) m is in an occupied cell: the slope there, 2.717, is above"});
  expectWords(plan("ground", "0.65,0.35", "0.351234,0.55", "5"), {"comes within 0.3 m of"});
  // the gap to a corner is none of whole cells
  convertFloors([](std::size_t x, std::size_t y) { return x == 10 && y == 8 ? 25 : 0; });
  expectWords(plan("ground", "0.75,0.55", "0.55,0.35", "0.3"), {"comes within 0.283 m of"});
}

TEST_F(ReportPlans, WithoutAVoxelMapPlanSaysWhatItCannotTell)
{
  convertFloors([](std::size_t x, std::size_t) { return x == 10 ? 9 : 0; });
  std::filesystem::remove(map() + "/voxels.bt");
  const Outcome run = plan("ground", "0.35,0.55", "1.65,0.55", "0");
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(contains(run.err,
                       "; whether a map converted with a higher --max-step would help cannot be "
                       "told without voxels.bt\n"))
      << run.err;
}

TEST_F(ReportPlans, TheSummaryNamesTheLowestStepAndTheLowestThinWall)
{
  convertFloors([](std::size_t, std::size_t) { return 0; });
  const Outcome json = convert(m_dir.path("floors.bt"));
  EXPECT_NEAR(2.0 / 3, parseJson(json.out)["minStep"].number, 1e-9);
  EXPECT_NEAR(1.0, parseJson(json.out)["minThinWall"].number, 1e-9);
  const Outcome text = mapconv({"convert", m_dir.path("floors.bt"), "-o", map(), "--paper"});
  for (const char* words : {"minStep      0.67 m", "minThinWall  1.00 m"})
    EXPECT_TRUE(contains(text.out, words)) << text.out;
  EXPECT_TRUE(contains(text.err, "minThinWall = 1.00 m")) << text.err;
}

TEST_F(ReportPlans, HelpSaysHowClearanceIsMeasured)
{
  const Outcome help = mapconv({"plan", "--help"});
  for (const char* words : {"square of every cell that is not free", "2 radius/resolution + 1"})
    EXPECT_TRUE(contains(help.out, words)) << help.out;
}

}  // namespace
