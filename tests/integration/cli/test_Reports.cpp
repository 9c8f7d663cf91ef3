#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "Program.h"
#include "Raster.h"
#include "StrictJson.h"
#include "support/TempDir.h"

// Inputs that reproduce what users of mapping programs have reported (../shared/data/reports): what
// is right was computed independently of this program. The rooms measure 10.2 x 8.2 m.
namespace
{
using namespace mrpt_mapconv::testing;

class Reports : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    if (!std::filesystem::exists(kReports)) GTEST_SKIP() << kReports << " is not there";
  }

  Outcome convert(const std::string& file, std::vector<std::string> flags = {})
  {
    flags.insert(flags.begin(), {"convert", kReports + file, "-o", m_dir.path("out"), "--json",
                                 "--min-clearance", "0.5", "--max-step", "0.15"});
    return mapconv(flags);
  }
  static void expectRoom(const Outcome& run)
  {
    ASSERT_EQ(0, run.status) << run.err;
    const JsonValue json = parseJson(run.out);
    EXPECT_NEAR(10.2, json["xMax"].number - json["xMin"].number, 1e-6);
    EXPECT_NEAR(8.2, json["yMax"].number - json["yMin"].number, 1e-6);
  }

  const std::string kReports = MRPT_MAPCONV_SHARED_DIR "/reports/";
  TempDir m_dir;
};

TEST_F(Reports, ScansInAGapOfThePosesAreLeftOut)
{
  const auto run = convert("pose_gap.rawlog");
  expectRoom(run);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  for (const char* words : {"23 of 29 scans", "23 in gaps", "60.0 s"})
    EXPECT_TRUE(contains(run.err, words)) << run.err;
  const auto inserted = mapconv({"insert", kReports + "pose_gap.rawlog", "-o", m_dir.path("map"),
                                 "--json", "--structure", "2.2", "2.6"});
  expectRoom(inserted);
  EXPECT_TRUE(contains(inserted.err, "23 of 29 scans")) << inserted.err;
}

TEST_F(Reports, WithAllPosesNoScanIsLeftOut)
{
  const auto run = convert("pose_gap_all_poses.rawlog");
  expectRoom(run);
  EXPECT_EQ(0, warningsIn(run.err)) << run.err;
}

TEST_F(Reports, WhatARobotPoseIsOfIsTakenOff)
{
  const auto with = convert("pose_sensor_offset.rawlog");
  const auto without = convert("pose_sensor_offset_none.rawlog");
  expectRoom(with);
  expectRoom(without);
  for (const char* count : {"free", "occupied", "unknown", "steep"})
    EXPECT_NEAR(parseJson(with.out)[count].number, parseJson(without.out)[count].number,
                0.01 * parseJson(with.out)["cells"].number)
        << count;
}

TEST_F(Reports, ACeilingInTheStructureSliceIsNoWall)
{
  const std::string log = kReports + "ceiling_2.45m.rawlog";
  const auto run = mapconv({"insert", log, "-o", m_dir.path("map"), "--structure", "2.2", "2.6"});
  EXPECT_EQ(1, run.status);
  EXPECT_FALSE(std::filesystem::exists(m_dir.path("map")));
  for (const char* words : {"ceiling_2.45m.rawlog", "11 of its 3D scans", "the ceiling, 2.45 m",
                            "2.2 to 2.6 m", "structureMinZ = 2.1", "structureMaxZ = 2.35"})
    EXPECT_TRUE(contains(run.err, words)) << words << " in " << run.err;
  const auto below =
      mapconv({"insert", log, "-o", m_dir.path("map"), "--json", "--structure", "2.1", "2.35"});
  expectRoom(below);
  EXPECT_EQ("", below.err);
  EXPECT_GT(parseJson(below.out)["free"].number, 0.93 * parseJson(below.out)["cells"].number);
}

TEST_F(Reports, InALogWorkThatTakesLongSaysSo)
{
  const auto run = runProgram({"sh", "-c", "(sleep 11; cat \"$1\") | \"$0\" convert - -o \"$2\"",
                               MAPCONV_PROGRAM, kReports + "fence09.bt", m_dir.path("out")});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ("mapconv: progress: reading stdin (10 s)\n", run.progress);
}

/** Whether a robot of this radius gets from one place to another on a map with evidence. */
bool isWay(const std::string& map, const std::string& from, const std::string& to,
           const std::string& radius, const std::string& csv)
{
  const auto run = mapconv({"plan", map, "--robot", "ground", "--from=" + from, "--to=" + to,
                            "--robot-radius", radius, "-o", csv});
  EXPECT_TRUE(run.status == 0 || contains(run.err, "no path")) << run.err;
  return run.status == 0;
}

/** Calls visit(x, y, value) for the cells of a layer, by their centres [m]. */
template <class Visit>
void forEachCell(const std::string& map, const std::string& layer, const Visit& visit)
{
  const Raster raster = readRaster(map + "/layers.tif");
  const double res = raster.transform[1], yMin = raster.transform[3] - raster.height * res;
  for (const auto& band : raster.bands)
    for (int i = 0; band.name == layer && i < raster.width * raster.height; ++i)
      visit(raster.transform[0] + (i % raster.width + 0.5) * res,
            yMin + (i / raster.width + 0.5) * res, band.cells.at(static_cast<std::size_t>(i)));
}

TEST_F(Reports, NobodyIsSentOverACliffButByThePapersParameters)
{
  const std::string csv = m_dir.path("way.csv");
  for (const bool paper : {false, true})
  {
    const std::string map = m_dir.path(paper ? "paper" : "default");
    std::vector<std::string> words{"convert", kReports + "cliff.bt", "-o", map, "--json"};
    if (paper) words.emplace_back("--paper");
    const auto run = mapconv(words);
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_EQ(paper, isWay(map, "-5,0", "8,0", "0.3", csv));
    if (paper) continue;
    EXPECT_GT(parseJson(run.out)["frontier"].number, 3000) << "nobody saw what is under the edge";
    const auto isOverTheHole = [](double x) { return x > 0.96 && x < 5.6; };  // 0.95 is its edge
    int inTheAir = 0, over = 0;
    forEachCell(map, "ground",
                [&](double x, double, double cell)
                { over += isOverTheHole(x), inTheAir += isOverTheHole(x) && cell == 0; });
    forEachCell(map, "evidence",
                [&](double x, double, double cell) { inTheAir += isOverTheHole(x) && cell == 2; });
    EXPECT_EQ(0, inTheAir) << "cells that are free or inferred";
    EXPECT_GT(over, 3000);
  }
}

TEST_F(Reports, AFenceIsOccupiedButByThePapersParameters)
{
  const std::string csv = m_dir.path("way.csv");
  for (const bool paper : {false, true})
  {
    const std::string map = m_dir.path(paper ? "paper" : "default");
    std::vector<std::string> words{"convert", kReports + "fence09.bt", "-o", map};
    if (paper) words.emplace_back("--paper");
    ASSERT_EQ(0, mapconv(words).status);
    int free = 0, cells = 0;
    forEachCell(map, "ground",
                [&](double x, double y, double cell)
                {
                  if (std::abs(x - 0.05) > 0.01 || std::abs(y) > 2) return;
                  ++cells;
                  free += cell == 0;
                });
    EXPECT_GE(cells, 40);
    EXPECT_EQ(paper ? cells : 0, free);
    EXPECT_FALSE(isWay(map, "-3,0", "3,0", "0.3", csv)) << "plan looks for steps in any case";
  }
}

/** Shares of the ground cells whose centres lie in geb079's corridor, in percent. */
struct Shares
{
  double occupied = 0, free = 0;
};

Shares corridorOf(const std::string& map)
{
  Shares shares;
  double cells = 0;
  forEachCell(map, "ground",
              [&](double x, double y, double cell)
              {
                if (x < -5.5 || x > 27 || std::abs(y) > 1) return;
                ++cells;
                shares.occupied += cell > 0;
                shares.free += cell == 0;
              });
  return {100 * shares.occupied / cells, 100 * shares.free / cells};
}

TEST_F(Reports, WithEvidenceACorridorIsFreeWhereItsFloorIsBetweenTheLidarsRings)
{
  const std::string file = MRPT_MAPCONV_SHARED_DIR "/geb079.bt";
  for (const std::string floorFrom : {"lowestFree", "seen"})
  {
    const std::string map = m_dir.path(floorFrom), csv = m_dir.path("way.csv");
    std::vector<std::string> words{"convert", file, "-o", map, "--max-step", "0.16"};
    if (floorFrom != "seen") words.insert(words.end(), {"--floor-from", floorFrom});
    ASSERT_EQ(0, mapconv(words).status);
    // the figures in share/doc/mapconv.md
    const Shares shares = corridorOf(map);
    EXPECT_NEAR(floorFrom == "seen" ? 5.6 : 20.1, shares.occupied, 0.05) << floorFrom;
    EXPECT_NEAR(floorFrom == "seen" ? 93.0 : 78.6, shares.free, 0.05) << floorFrom;
    EXPECT_EQ(floorFrom == "seen", isWay(map, "13,-0.6", "25,0.6", "0.3", csv)) << floorFrom;
    EXPECT_EQ(floorFrom == "seen", isWay(map, "-5,-0.7", "2,-0.7", "0.35", csv)) << floorFrom;
  }
}

TEST_F(Reports, AnIniFileMayBeginWithAByteOrderMark)
{
  const auto run =
      mapconv({"convert", MRPT_MAPCONV_SHARED_DIR "/geb079.bt", "-o", m_dir.path("out"), "--json",
               "-c", kReports + "bom.ini", "--max-step", "0.16"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ("", run.err);
  EXPECT_EQ(0.5, parseJson(run.out)["parameters"]["minClearance"].number);
}

TEST_F(Reports, AYamlHoldsNoNumberThatYamlTakesForAString)
{
  const auto run = mapconv({"convert", kReports + "res_1e-4.bt", "-o", m_dir.path("out"), "--json",
                            "--min-clearance", "0.0002"});
  ASSERT_EQ(0, run.status) << run.err;
  const std::string yaml = readBytes(m_dir.path("out/ground.yaml"));
  EXPECT_TRUE(contains(yaml, "resolution: 0.0001\n")) << yaml;
}

TEST_F(Reports, APoseSourceThatIsNotThereIsNamedWithThoseThatAre)
{
  const auto run = convert("pose_gap.rawlog", {"--pose-source", "gps"});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  for (const char* words : {"pose_gap.rawlog", "no poses are labelled 'gps'", "there are: '"})
    EXPECT_TRUE(contains(run.err, words)) << run.err;
  const auto noLog = mapconv({"convert", MRPT_MAPCONV_SHARED_DIR "/geb079.bt", "-o",
                              m_dir.path("bt"), "--pose-source", "gps", "--max-step", "0.1"});
  EXPECT_EQ(0, noLog.status) << noLog.err;
  EXPECT_TRUE(contains(noLog.err, "--pose-source has no effect")) << noLog.err;
}

}  // namespace
