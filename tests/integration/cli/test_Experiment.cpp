#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ExperimentFiles.h"

using namespace mrpt_mapconv::testing;

namespace
{
const std::string kIni = kConfig + "experiments/freespace.ini";
const std::string kScanShapeIni = kConfig + "experiments/scan_shape.ini";
}  // namespace

TEST(Experiment, FreespaceWritesTablesPlotsAndPictures)
{
  const TempDir dir;
  const Outcome outcome = mapconv({"experiment", kIni, "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ("", outcome.err);
  const std::string report = readBytes(dir.path("out/report.md"));
  EXPECT_EQ(report, outcome.out);
  for (const char* part : {"Table II", "Table III", "paper 2.4", "<= 2", "RMSE", "start–goal"})
    EXPECT_TRUE(contains(report, part)) << part;
  for (const char* name :
       {"updates.png", "updates_by_columns.png", "cave_ground_strict.png", "outdoor_truth.png"})
    EXPECT_EQ("\x89PNG", readBytes(dir.path(std::string("out/") + name)).substr(0, 4)) << name;

  const auto full = tableRows(dir.path("out/table2_full.csv"));
  ASSERT_EQ(11u, full.size());  // a header, five methods in two worlds
  for (std::size_t i = 1; i < full.size(); ++i) EXPECT_GT(std::stod(full[i].at(2)), 0) << i;
  const auto sizes = tableRows(dir.path("out/table3_sizes.csv"));
  EXPECT_EQ(7u, sizes.size());
  const auto quality = tableRows(dir.path("out/quality.csv"));
  ASSERT_EQ(17u, quality.size());
  // what the aerial map of either world calls free is free
  EXPECT_GT(std::stod(quality[1].at(3)), 97) << quality[1].at(0);
  EXPECT_GT(std::stod(quality[9].at(3)), 97) << quality[9].at(0);
  EXPECT_EQ(15u, tableRows(dir.path("out/paths.csv")).size());
  EXPECT_EQ(11u, tableRows(dir.path("out/ground_cells.csv")).size());  // two maps in five worlds
}

TEST(Experiment, FreespaceComparesGroundThatWasSeen)
{
  const TempDir dir;
  const std::vector<std::string> worlds = {"building", "drops", "drops_narrow"};
  std::string ini = replaced(readBytes(kIni), "building cave outdoor", "building");
  for (const char* file : {"building.ini", "drops.ini", "drops.ini"})
    ini = replaced(ini, std::string("../worlds/") + file, kConfig + "worlds/" + file);
  std::ofstream(dir.path("e.ini")) << ini;
  ASSERT_EQ(0, mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out"), "--quick"}).status);
  const auto cells = tableRows(dir.path("out/ground_cells.csv"));
  EXPECT_EQ(1 + 2 * worlds.size(), cells.size());
  for (const std::string& world : worlds)
  {
    const Row strict = rowWith(cells, {world, "strict"}), seen = rowWith(cells, {world, "seen"});
    EXPECT_LE(3 * number(seen, 7), number(strict, 7)) << "false obstacles away from all: " << world;
    EXPECT_LE(number(seen, 7), number(seen, 6)) << world;
    EXPECT_EQ(0, number(strict, 9)) << "frontier cells: " << world;
    EXPECT_GT(number(seen, 9), number(seen, 10)) << world;
    EXPECT_EQ("\x89PNG", readBytes(dir.path("out/" + world + "_ground_seen.png")).substr(0, 4));
  }
  EXPECT_EQ(1 + 2 * worlds.size(), tableRows(dir.path("out/ground_pairs.csv")).size());
  EXPECT_TRUE(contains(readBytes(dir.path("out/ground_targets.csv")), "at most a third: met"));

  // one scenario, two lidars
  const auto edges = tableRows(dir.path("out/drop_edges.csv"));
  ASSERT_EQ(5u, edges.size());
  EXPECT_NE(rowWith(edges, {"drops", "seen"}).at(4),
            rowWith(edges, {"drops_narrow", "seen"}).at(4));
  EXPECT_EQ("0.30", edges[1].at(2));
  const std::string ramp = readBytes(dir.path("out/drops_and_ramp.csv"));
  EXPECT_TRUE(contains(ramp, "at most 30")) << ramp;
}

TEST(Experiment, FreespaceWorldsMayHaveTheirOwnStrictParameters)
{
  const TempDir dir;
  const std::string world = "[a]\nfile = " + kConfig + "worlds/building.ini\n";
  std::ofstream(dir.path("e.ini"))
      << "[experiment]\nkind = freespace\nworlds = a b\n"
      << "[strictConversion]\nfloorFrom = lowestFree\nmaxSlope = 0.5\nmaxStep = 0.2\n"
      << world << replaced(world, "[a]", "[b]") << "maxStep = 1.5\nmaxSlope = 5\n";
  ASSERT_EQ(0, mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out"), "--quick"}).status);
  const auto cells = tableRows(dir.path("out/ground_cells.csv"));
  for (const std::string map : {"strict", "seen"})
    EXPECT_LT(number(rowWith(cells, {"b", map}), 6), number(rowWith(cells, {"a", map}), 6)) << map;
  EXPECT_FALSE(std::filesystem::exists(dir.path("out/quality.csv"))) << "no world of the paper";
  EXPECT_FALSE(std::filesystem::exists(dir.path("out/drop_edges.csv"))) << "no world of drops";
}

TEST(Experiment, BadFilesAreNamed)
{
  const TempDir dir;
  const auto error = [&](const std::string& text) { return experimentError(dir, text); };
  EXPECT_TRUE(contains(error(""), "kind"));
  EXPECT_TRUE(contains(error(""), "freespace | scanShape | terrain"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = cooking\n"), "cooking"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\n"), "worlds"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\n"), "'a'"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\npairs = -1\n[a]\n"),
                       "pairs = '-1'"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\n[a]\nfile = none.ini\n"),
                       "none.ini"));
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a\n[a]\nfile = w.ini\n"
                             "colour = red\n"),
                       "colour"));
  const std::string world = "[a]\nfile = w.ini\n";
  EXPECT_TRUE(contains(error("[experiment]\nkind = freespace\nworlds = a a\n" + world), "once"));
  EXPECT_TRUE(contains(
      error("[experiment]\nkind = freespace\nworlds = a\n" + world + "safetyRadius = 0.9\n"),
      "section 'a': safetyRadius = '0.9'"));
  const std::string begin = "[experiment]\nkind = freespace\nworlds = a\n" + world;
  EXPECT_TRUE(contains(error(begin + "[conversion]\nminClearance = -1\n"),
                       "section 'conversion': minClearance = -1"));
  EXPECT_TRUE(contains(error(begin + "maxStep = -1\n"), "section 'a': maxStep = -1"));
  EXPECT_TRUE(contains(error(begin + "floorFrom = seen\n"), "section 'a': floorFrom = 'seen'"));
  EXPECT_TRUE(contains(error(begin + "[strictConversion]\nfloorFrom = seen\n"),
                       "section 'strictConversion': floorFrom = 'seen'"));
  EXPECT_TRUE(contains(error(begin + "paperSizes = 1 2\n"), "section 'a': paperSizes"));
  EXPECT_TRUE(contains(error(begin + "ramp = r\n"), "section 'a': rampWay"));
  const std::string drops = replaced(begin, "w.ini", kConfig + "worlds/drops.ini");
  EXPECT_TRUE(contains(error(drops + "ramp = slide\nrampWay = 1 2 3 4\n"), "'slide'"));
}

TEST(Experiment, SensorsAreThoseOfTheWorld)
{
  const TempDir dir;
  std::ofstream(dir.path("e.ini"))
      << "[experiment]\nkind = freespace\nworlds = a\n[a]\nfile = " << kConfig
      << "worlds/drops.ini\nsensors = wide\n";
  const Outcome outcome = mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out")});
  EXPECT_EQ(1, outcome.status);
  EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
  for (const char* part : {"drops.ini", "'wide'", "'narrow'"})
    EXPECT_TRUE(contains(outcome.err, part)) << outcome.err;
}

TEST(Experiment, ScanShapeWritesTablesAndPictures)
{
  const TempDir dir;
  const Outcome outcome = mapconv({"experiment", kScanShapeIni, "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ("", outcome.err);
  const std::string report = readBytes(dir.path("out/report.md"));
  EXPECT_EQ(report, outcome.out);
  for (const char* part : {"Table I", "0.937", "Seed 1: 8 3D scans", "MRPT refused 0"})
    EXPECT_TRUE(contains(report, part)) << part;
  for (const char* name :
       {"truth", "scanner_2d", "closest_point", "counts", "whole_shape_uncut", "whole_shape_cut"})
    EXPECT_EQ("\x89PNG", readBytes(dir.path(std::string("out/") + name + ".png")).substr(0, 4))
        << name;

  const auto scores = tableRows(dir.path("out/table1_seeds.csv"));
  ASSERT_EQ(6u, scores.size());  // a header, five methods of one drive
  for (std::size_t i = 1; i < scores.size(); ++i)
  {
    const double precision = number(scores[i], 2), recall = number(scores[i], 3);
    EXPECT_TRUE(precision > 0.5 && precision <= 1) << scores[i].at(1);
    EXPECT_TRUE(recall > 0.1 && recall < 1) << scores[i].at(1);
    EXPECT_NEAR(2 * precision * recall / (precision + recall), number(scores[i], 4), 2e-3);
    EXPECT_EQ(scores[i].at(4),
              rowWith(tableRows(dir.path("out/table1.csv")), {scores[i][1]}).at(3));
  }
}

TEST(Experiment, ScanShapeShowsGhostsAndPeople)
{
  const TempDir dir;
  ASSERT_EQ(0, mapconv({"experiment", kScanShapeIni, "-o", dir.path("out"), "--quick"}).status);
  const auto cut = tableRows(dir.path("out/cut.csv"));
  ASSERT_EQ(2u, cut.size());
  EXPECT_GT(number(cut[1], 3), 0.05);  // the gain of precision
  EXPECT_GT(number(cut[1], 5), 500);   // real ghosts on the map without the cut
  EXPECT_LT(number(cut[1], 7), number(cut[1], 5) / 2);

  const Row people = rowWith(tableRows(dir.path("out/people.csv")), {"all"});
  EXPECT_GT(number(people, 1), 100);
  EXPECT_EQ(0, number(people, 5));
  for (std::size_t i = 2; i <= 5; ++i) EXPECT_LE(number(people, i), number(people, i - 1)) << i;
}

TEST(Experiment, ScanShapeLooksIntoRoomsFromOutside)
{
  const TempDir dir;
  ASSERT_EQ(0, mapconv({"experiment", kScanShapeIni, "-o", dir.path("out"), "--quick"}).status);
  const auto whole = tableRows(dir.path("out/regions.csv"));
  const auto outside = tableRows(dir.path("out/regions_outside.csv"));
  ASSERT_EQ(9u, whole.size());
  ASSERT_EQ(17u, outside.size());
  for (std::size_t i = 1; i < whole.size(); ++i)
  {
    EXPECT_GT(number(whole[i], 2), 1) << "truly free area of " << whole[i].at(0);
    const Row row = rowWith(outside, {whole[i].at(0), whole[i].at(1), "0.00"});
    EXPECT_EQ("8.0", row.at(3)) << "the drive begins in the hall";
    EXPECT_EQ(Row(whole[i].begin() + 3, whole[i].begin() + 5),
              Row(row.begin() + 5, row.begin() + 7));
  }
  const Row meeting = rowWith(outside, {"door_8", "lintelDoor", "1.20"});
  EXPECT_LT(number(meeting, 3), 8) << "it begins near the glass";
  const Row store = rowWith(outside, {"door_3", "lintelDoor", "1.20"});
  EXPECT_EQ("8.0", store.at(3));
  EXPECT_GT(number(store, 4), 5) << "it is really seen through its door";
  EXPECT_GT(number(store, 5), 2 * number(store, 4)) << "most of that is made up by ghosts";
  EXPECT_EQ(0, number(store, 6)) << "its lintel should hide it, from where the drive begins";
}

TEST(Experiment, ScanShapeLeavesOutScansFromInsideTheRoom)
{
  const TempDir dir;
  std::string text =
      replaced(readBytes(kScanShapeIni), "../worlds/office.ini", kConfig + "worlds/office.ini");
  // the hall, where the drive begins, as the room of door 8
  text = replaced(text, "room = 5.47 9.27 12.33 16.02", "room = 0.02 6.74 24.07 9.39");
  std::ofstream(dir.path("e.ini")) << text;
  ASSERT_EQ(0, mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out"), "--quick"}).status);
  const Row row = rowWith(tableRows(dir.path("out/regions_outside.csv")), {"door_8"});
  EXPECT_EQ("0.0", row.at(3));
  for (std::size_t i = 4; i < row.size(); ++i) EXPECT_EQ(0, number(row, i)) << i;
}

TEST(Experiment, ScanShapeTriesItsDefaultsThreeTimes)
{
  const TempDir dir;
  const Outcome outcome = mapconv({"experiment", kScanShapeIni, "-o", dir.path("out"), "--quick"});
  ASSERT_EQ(0, outcome.status);
  EXPECT_TRUE(contains(outcome.out, "The drive of seed 11,"));
  const auto increments = tableRows(dir.path("out/increments.csv"));
  EXPECT_EQ(31u, increments.size());
  const Row defaults = rowWith(increments, {"0.70", "0.45"});
  EXPECT_EQ("14/3", defaults.at(2));
  EXPECT_EQ("19", defaults.at(9));
  EXPECT_EQ("10", rowWith(increments, {"0.90", "0.40"}).at(9));
  EXPECT_EQ("12", rowWith(increments, {"0.90", "0.42"}).at(9));
  EXPECT_EQ("6", rowWith(increments, {"0.90", "0.35"}).at(9));
  const auto parameters = tableRows(dir.path("out/parameters.csv"));
  EXPECT_EQ(7u, parameters.size());
  const Row scores(defaults.begin() + 3, defaults.begin() + 9);
  for (const Row& begin : {Row{"structureTolerance [m]", "0.05"}, Row{"sectors", "2516"}})
  {
    const Row row = rowWith(parameters, begin);
    ASSERT_EQ(8u, row.size());
    EXPECT_EQ(scores, Row(row.begin() + 2, row.end())) << begin.front();
  }
}

TEST(Experiment, BadScanShapeFilesAreNamed)
{
  const TempDir dir;
  const std::string good =
      replaced(readBytes(kScanShapeIni), "../worlds/office.ini", kConfig + "worlds/office.ini");
  const auto error = [&](const std::string& from, const std::string& to)
  { return experimentError(dir, replaced(good, from, to)); };
  EXPECT_TRUE(contains(error("file ", "; file "), "file = FILE is missing"));
  EXPECT_TRUE(contains(error("office.ini", "none.ini"), "none.ini"));
  EXPECT_TRUE(contains(error("office.ini", "cave.ini"), "cave.ini: this experiment needs"));
  EXPECT_TRUE(contains(error("seeds  ", "; seeds "), "seeds = NUMBER"));
  EXPECT_TRUE(contains(error("1 2 3 4 5", "1 2 2"), "section 'experiment': seeds = '1 2 2'"));
  EXPECT_TRUE(contains(error("1 2 3 4 5", "0.5"), "seeds = '0.5'"));
  EXPECT_TRUE(contains(error("resolution = 0.05", "resolution = 0"), "resolution = '0'"));
  EXPECT_TRUE(contains(error("maxScans   = 0", "maxScans = -1"), "maxScans = '-1'"));
  EXPECT_TRUE(contains(error("structureMaxZ = 2.6", ""), "section 'wholeShapeCut': structureMaxZ"));
  EXPECT_TRUE(contains(error("structureMaxZ = 2.6", "structureMaxZ = 2.6\nmodel = closestPoint"),
                       "model = 'closestPoint'"));
  EXPECT_TRUE(contains(error("structureMaxZ = 2.6", "structureMaxZ = 2.6\ncolour = red"),
                       "section 'wholeShapeCut': 'colour'"));
  EXPECT_TRUE(contains(error("horizontalTolerance = 2", "horizontalTolerance = -2"),
                       "section 'scanner2D': horizontalTolerance = '-2'"));
  EXPECT_TRUE(contains(error("0.913 0.610 0.731", "0.913"), "section 'paper': closestPoint"));
  EXPECT_TRUE(contains(error("0.8 0.9 0.97", "0.8 0.4"), "section 'sweep': pHit = 0.4"));
  EXPECT_TRUE(contains(error("1258 2516", "12.5 2516"), "section 'sweep': sectors"));
  EXPECT_TRUE(contains(error("= 11 12", "= 11 3"), "section 'sweep': seeds = '11 3'"));
  EXPECT_TRUE(contains(error("structureTolerance = 0 ", "structureTolerance = -3 "),
                       "section 'sweep': structureTolerance = -3"));
  EXPECT_TRUE(contains(error("3.63 4.42 6.31", "6.31 4.42 3.63"), "section 'region.door_1': area"));
  EXPECT_TRUE(
      contains(error("margins = 0 1.2", "margins = 0 -1"), "section 'regions': margins = '0 -1'"));
  EXPECT_TRUE(contains(error("room = 0.02 0.03 6.42 6.86", ""), "section 'region.door_1': room"));
  EXPECT_TRUE(contains(error("6.31 6.74", "6.31 66.74"),
                       "section 'region.door_1': area = '3.63 4.42 6.31 66.74'"));
  EXPECT_TRUE(contains(error("3.63 4.42 6.31 6.74", "0.05 2.4 0.45 3.3"),
                       "section 'region.door_1': area = '0.05 2.4 0.45 3.3'"));  // a cupboard
  EXPECT_TRUE(contains(error("0.02 0.03 6.42 6.86", "50 0.03 56 6.86"),
                       "section 'region.door_1': room = '50 0.03 56 6.86'"));
  EXPECT_TRUE(contains(error("kind = openDoor", "kind = window"),
                       "section 'region.door_4': kind = 'window'"));
  EXPECT_TRUE(contains(error("[region.door_4]", "[regoin.door_4]"), "section 'regoin.door_4'"));
}

TEST(Experiment, ScanShapePosesMustStayInTheWorld)
{
  const TempDir dir;
  const std::string office = readBytes(kConfig + "worlds/office.ini");
  const std::string experiment =
      replaced(readBytes(kScanShapeIni), "../worlds/office.ini", "office.ini");
  const auto error = [&](const std::string& from, const std::string& to)
  {
    std::ofstream(dir.path("office.ini")) << replaced(office, from, to);
    return experimentError(dir, experiment);
  };
  const std::string far = error("posePosition = 0.01 ", "posePosition = 1000 ");
  for (const char* part : {"office.ini: section 'noise'", "posePosition or poseAngle", "outside"})
    EXPECT_TRUE(contains(far, part)) << far;
  const std::string tilted = error("poseAngle = 0.1 ", "poseAngle = 100 ");
  for (const char* part :
       {"office.ini: section 'noise'", "posePosition or poseAngle", "objectMinZ"})
    EXPECT_TRUE(contains(tilted, part)) << tilted;
}
