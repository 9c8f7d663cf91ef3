#include <gtest/gtest.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/scan/ScanInsertionOptions.h>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>

#include "InsertRuns.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;
using mrpt_mapconv::scan::TScanInsertionOptions;
namespace fs = std::filesystem;

// What mapconv insert is told: ini files and flags.

namespace
{
/** Inserts a scan of a chair with an ini file of this text, or without. */
class InsertInput : public ::testing::Test
{
 protected:
  InsertInput() { writeObjects(m_dir.path("chair.rawlog"), {chair(0)}); }

  Outcome insert(const std::string& file, std::vector<std::string> flags)
  {
    flags.insert(flags.begin(), {"insert", m_dir.path(file), "-o", m_dir.path("out"), "--json"});
    return mapconv(flags);
  }
  Outcome insertWith(const std::string& ini, std::vector<std::string> flags = {})
  {
    std::ofstream(m_dir.path("my.ini")) << ini;
    flags.insert(flags.end(), {"-c", m_dir.path("my.ini")});
    return insert("chair.rawlog", flags);
  }
  void expectNothingWritten() const { EXPECT_FALSE(fs::exists(m_dir.path("out"))); }

  TempDir m_dir;
};

std::string textOf(const TScanInsertionOptions& options)
{
  std::ostringstream text;
  options.dumpToTextStream(text);
  return text.str();
}

}  // namespace

TEST_F(InsertInput, theOldNameOfTheSectionIsReadAndNamedInAWarning)
{
  const std::string keys = "structureMinZ = 2.2\nstructureMaxZ = 2.6\nsectors = 4\n";
  const auto now = insertWith("[scanInsertion]\n" + keys),
             before = insertWith("[insertion]\n" + keys);
  ASSERT_EQ(0, now.status) << now.err;
  ASSERT_EQ(0, before.status) << before.err;
  EXPECT_EQ(warningsIn(now.err) + 1, warningsIn(before.err)) << before.err;
  EXPECT_TRUE(contains(before.err, "[insertion] is now called [scanInsertion]")) << before.err;
  for (const char* key : {"sectors", "structureMinZ"})
    EXPECT_EQ(parseJson(now.out)["parameters"][key].number,
              parseJson(before.out)["parameters"][key].number)
        << key;
  EXPECT_EQ(4, parseJson(before.out)["parameters"]["sectors"].number);
}

TEST_F(InsertInput, aResolutionThatIsNoNumberIsSaidToBeNone)
{
  for (const std::string text : {"abc", "1,5"})
  {
    const auto run = insert("chair.rawlog", {"--resolution=" + text, "--no-reflection-filter"});
    EXPECT_EQ(2, run.status) << text;
    EXPECT_TRUE(contains(run.err, "--resolution: '" + text + "' is not valid: it must be a number"))
        << run.err;
  }
}

TEST_F(InsertInput, theFilterNeedsAStructureSliceAndTheErrorSaysHowToGiveIt)
{
  const std::vector<std::string> ways = {"--structure", "structureMinZ", "structureMaxZ",
                                         "[scanInsertion]", "--no-reflection-filter"};
  auto run = insert("chair.rawlog", {});
  EXPECT_EQ(2, run.status);
  expectWords(run, ways);
  for (const char* ini :
       {"[map]\nresolution = 0.1\n", "[scanInsertion]\nreflectionFilter = true\n"})
  {
    run = insertWith(ini);
    EXPECT_EQ(2, run.status) << ini;
    expectWords(run, ways);
  }
  run = insertWith("[scanInsertion]\nstructureMinZ = 2.2\n");
  EXPECT_EQ(1, run.status);
  expectWords(run, {"my.ini", "scanInsertion", "structureMaxZ is missing"});
  expectNothingWritten();
  for (const auto& flags : {std::vector<std::string>{"--structure", "2.2", "2.6"},
                            std::vector<std::string>{"--no-reflection-filter"}})
    EXPECT_EQ(0, insertWith("[scanInsertion]\nreflectionFilter = true\n", flags).status)
        << flags[0];
  EXPECT_EQ(0, insertWith("[scanInsertion]\nreflectionFilter = false\n").status);
}

TEST_F(InsertInput, iniSetsAndFlagsWin)
{
  const std::string ini =
      "[map]\nresolution = 0.25 // comment\n[scanInsertion]\nmodel = closestPoint\nobjectMinZ = "
      "0.1\n"
      "robotHeight = 1.8 ; comment\nstructureMinZ = 2\nstructureMaxZ = 2.5\nmaxRange = 7\n";
  auto run = insertWith(ini);
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_FALSE(contains(run.err, "unknown")) << run.err;
  JsonValue json = parseJson(run.out);
  EXPECT_EQ(0.25, json["resolution"].number);
  EXPECT_EQ("closestPoint", json["parameters"]["model"].text);
  EXPECT_EQ(0.1, json["parameters"]["objectMinZ"].number);
  EXPECT_EQ(1.8, json["parameters"]["objectMaxZ"].number);
  EXPECT_EQ(7, json["parameters"]["maxRange"].number);
  EXPECT_EQ(2.5, json["parameters"]["structureMaxZ"].number);

  run = insertWith(
      ini, {"--resolution", "0.125", "--model", "wholeShape", "--structure", "-1.5", "3.25"});
  ASSERT_EQ(0, run.status) << run.err;
  json = parseJson(run.out);
  EXPECT_EQ(0.125, json["resolution"].number);
  EXPECT_EQ("wholeShape", json["parameters"]["model"].text);
  EXPECT_EQ(-1.5, json["parameters"]["structureMinZ"].number);
  EXPECT_EQ(3.25, json["parameters"]["structureMaxZ"].number);
  EXPECT_EQ(0.1, json["parameters"]["objectMinZ"].number) << "what no flag is for";

  run = insertWith(ini, {"--no-reflection-filter"});
  EXPECT_FALSE(parseJson(run.out)["parameters"]["reflectionFilter"].truth);
}

TEST_F(InsertInput, theShippedFileHoldsTheDefaults)
{
  const std::string file = MRPT_MAPCONV_SOURCE_DIR "/config/scanShapeGrid/insert.ini";
  const auto without = insert("chair.rawlog", {"--structure", "2.2", "2.6"});
  const auto with = insert("chair.rawlog", {"-c", file});
  ASSERT_EQ(0, with.status) << with.err;
  EXPECT_EQ(without.err, with.err) << "no warning of its own";
  EXPECT_EQ(parseJson(without.out)["resolution"].number, parseJson(with.out)["resolution"].number);

  TScanInsertionOptions shipped, defaults;
  shipped.loadFromConfigFile(mrpt::config::CConfigFile(file), "scanInsertion");
  // what the file says is not the default
  defaults.profile.structureMinZ = shipped.profile.structureMinZ;
  defaults.profile.structureMaxZ = shipped.profile.structureMaxZ;
  EXPECT_TRUE(defaults.insert2D);
  defaults.insert2D = shipped.insert2D;
  EXPECT_EQ(textOf(defaults), textOf(shipped));
}

TEST_F(InsertInput, typosAreNamedInAWarning)
{
  const auto run = insertWith(
      "[scanInsertion]\nreflectionFilter = false\nmaxrnge = 3\n[map]\nresolutoin = "
      "1\n[conversion]\n"
      "minClearance = 1\n");
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(3, warningsIn(run.err)) << run.err;
  for (const char* word :
       {"my.ini", "maxrnge", "resolutoin", "[conversion]", "[scanInsertion] and"})
    EXPECT_TRUE(contains(run.err, word)) << word << " in " << run.err;
}

TEST_F(InsertInput, badIniValuesAreErrorsThatNameFileSectionKeyAndValue)
{
  const std::vector<std::array<std::string, 3>> cases = {
      {"map", "resolution", "0"},
      {"map", "resolution", "fine"},
      {"map", "maxGridCells", "0.5"},
      {"scanInsertion", "model", "nearest"},
      {"scanInsertion", "objectMinZ", "2"},
      {"scanInsertion", "robotHeight", "tall"},
      {"scanInsertion", "reflectionFilter", "perhaps"},
      {"scanInsertion", "structureMaxZ", "2.1"},
      {"scanInsertion", "maxRange", "-3"},
      {"scanInsertion", "sectors", "1.5"},
      {"scanInsertion", "pHit", "0.4"},
      {"scanInsertion", "insert2D", "2"},
      {"scanInsertion", "maxDistanceInsertion", "0"}};
  for (const auto& [section, key, value] : cases)
  {
    std::string slice = "structureMinZ = 2.2\n";
    if (key != "structureMaxZ") slice += "structureMaxZ = 2.6\n";
    const std::string line = key + " = " + value + "\n";
    const auto run =
        insertWith("[scanInsertion]\n" + slice + (section == "map" ? "[map]\n" + line : line));
    EXPECT_EQ(1, run.status) << key << " " << value;
    expectWords(run, {"my.ini", section, key, value});
    expectNothingWritten();
  }
}

TEST_F(InsertInput, badFlagsAreStatus2AndNamed)
{
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> cases = {
      {{"--resolution", "0"}, {"--resolution", "0.0001"}},
      {{"--resolution", "nan"}, {"--resolution", "nan"}},
      {{"--resolution", "fine"}, {"--resolution", "fine"}},
      {{"--resolution", "5000"}, {"--resolution", "5000"}},
      {{"--model", "nearest"}, {"--model", "nearest", "wholeShape"}},
      {{"--structure", "2.6", "2.2"}, {"--structure", "2.6", "2.2"}},
      {{"--structure", "2.6", "2.6"}, {"--structure", "2.6"}},
      {{"--structure", "2.2"}, {"--structure"}},
      {{"--structure", "2.2", "inf"}, {"--structure", "inf"}},
      {{"--structure", "low", "2.2"}, {"--structure", "low"}},
      {{"--structure", "2.2", "2.6", "2.8"}, {"--structure", "2 ", "3"}},
      {{"--structure", "2.2", "2.6", "2.8", "3.0"}, {"--structure", "2 ", "4"}},
      {{"--structure", "2.2", "2.6", "--structure", "2.3", "2.5"}, {"--structure", "2 ", "4"}},
      {{"--object", "1", "0.5"}, {"--object 1 0.5", "MIN must be below MAX"}},
      {{"--object", "1"}, {"--object"}},
      {{"--max-range=-1"}, {"--max-range", "-1"}},
      {{"--max-range", "far"}, {"--max-range", "far"}},
      {{"--frobnicate"}, {"--frobnicate"}},
  };
  for (const auto& [flags, words] : cases)
  {
    const auto run = insert("chair.rawlog", flags);
    EXPECT_EQ(2, run.status) << flags[0];
    expectWords(run, words);
  }
  expectNothingWritten();
}

TEST_F(InsertInput, structureTakesTwoHeightsAndLeavesTheInputAlone)
{
  const auto run = mapconv({"insert", "-o", m_dir.path("out"), "--json", "--structure", "2.2",
                            "2.6", m_dir.path("chair.rawlog")});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(m_dir.path("chair.rawlog"), parseJson(run.out)["input"].text);
  EXPECT_EQ(2.2, parseJson(run.out)["parameters"]["structureMinZ"].number);
  EXPECT_EQ(2.6, parseJson(run.out)["parameters"]["structureMaxZ"].number);
  EXPECT_TRUE(contains(mapconv({"insert", "--help"}).out, "A return at a 3D scan's maximum range"));
  EXPECT_TRUE(contains(mapconv({"insert", "--help"}).out, "--structure MIN MAX   "))
      << "no word of more than two";
}

TEST_F(InsertInput, objectAndMaxRangeHaveFlags)
{
  const auto run = insert(
      "chair.rawlog", {"--no-reflection-filter", "--object", "0.25", "0.75", "--max-range", "4"});
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue json = parseJson(run.out);
  EXPECT_EQ(0.25, json["parameters"]["objectMinZ"].number);
  EXPECT_EQ(0.75, json["parameters"]["objectMaxZ"].number);
  EXPECT_EQ(4, json["parameters"]["maxRange"].number);
  EXPECT_GT(json["occupied"].number, 0);
  const auto near = insert("chair.rawlog", {"--no-reflection-filter", "--max-range", "1"});
  EXPECT_EQ(1, near.status) << "the chair is 1.5 m away";
  const auto low = insert("chair.rawlog", {"--no-reflection-filter", "--object", "0.1", "0.4"});
  EXPECT_EQ(1, low.status) << "the chair's point is 0.5 m high";
}

TEST_F(InsertInput, aLidarOnARoofIsTheUsualCaseOutdoors)
{
  writeObjects(m_dir.path("car.rawlog"), {cloudOn({{1.75f, 0.25f, 0.5f}}, {0.25, 0.25, 1.9}, 0)});
  const auto run = insert("car.rawlog", {"--no-reflection-filter"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ("", run.err);
  EXPECT_EQ(1, parseJson(run.out)["occupied"].number);
}

TEST_F(InsertInput, theStructureIsAskedForOnlyIfThereAre3DScans)
{
  writeObjects(m_dir.path("still.rawlog"), {});
  for (const std::string file : {"still.rawlog", "missing.rawlog"})
  {
    const auto run = insert(file, {});
    EXPECT_EQ(1, run.status) << run.err;
    EXPECT_FALSE(contains(run.err, "--structure")) << run.err;
    EXPECT_TRUE(contains(run.err, file)) << run.err;
  }
}

TEST_F(InsertInput, cellsTooFineForMaxRangeAreNamedBeforeTheLogIsRead)
{
  const std::string filter = "[scanInsertion]\nreflectionFilter = false\n";
  std::ofstream(m_dir.path("fine.ini")) << "[map]\nresolution = 0.001\n" << filter;
  std::ofstream(m_dir.path("far.ini")) << filter << "maxRange = 700\n";
  struct Case
  {
    std::vector<std::string> flags;
    int status;
    std::vector<std::string> words;
  };
  const std::string fine = m_dir.path("fine.ini"), far = m_dir.path("far.ini");
  const std::vector<Case> cases = {
      {{"--resolution", "0.001", "--no-reflection-filter"},
       2,
       {"maxRange = 20 ", "resolution = 0.001 m", "at most 10 m", "resolution is from --resolution",
        "maxRange is the default"}},
      {{"-c", fine},
       1,
       {"maxRange = 20 ", "resolution = 0.001 m", "resolution is from " + fine,
        "maxRange is the default"}},
      {{"-c", far},
       1,
       {"maxRange = 700 ", "resolution = 0.05 m", "at most 500 m", "resolution is the default",
        "maxRange is from " + far}},
      {{"-c", far, "--resolution", "0.01"},
       2,
       {"maxRange = 700 ", "at most 100 m", "resolution is from --resolution",
        "maxRange is from " + far}},
  };
  for (const auto& [flags, status, words] : cases)
  {
    const auto run = insert("missing.rawlog", flags);
    EXPECT_EQ(status, run.status) << run.err;
    expectWords(run, words);
    EXPECT_FALSE(contains(run.err, "missing.rawlog")) << run.err;
  }
  EXPECT_EQ(0, insert("chair.rawlog", {"-c", far, "--resolution", "0.07"}).status);
}

TEST_F(InsertInput, allParametersAreInTheSummary)
{
  TScanInsertionOptions defaults;
  mrpt::config::CConfigFileMemory ini;
  defaults.saveToConfigFile(ini, "scanInsertion");
  std::vector<std::string> keys;
  ini.getAllKeys("scanInsertion", keys);
  EXPECT_GE(keys.size(), 14U);
  const auto run = insert("chair.rawlog", {"--no-reflection-filter"});
  const JsonValue json = parseJson(run.out);
  for (const auto& key : keys)
    EXPECT_EQ(1U, json["parameters"].object.count(key)) << key << " in " << run.out;
  EXPECT_EQ(4e8, json["parameters"]["maxGridCells"].number);
  EXPECT_EQ(15, json["parameters"]["maxDistanceInsertion"].number) << "of 2D scans";
  EXPECT_EQ(0.65, json["parameters"]["maxOccupancyUpdateCertainty"].number);
}

TEST_F(InsertInput, theSummaryHasTheValuesAndNamesThoseThatAreNotTheDefault)
{
  const std::vector<std::pair<std::string, double>> values = {
      {"maxGridCells", 1e6},     {"objectMinZ", 0.125},
      {"objectMaxZ", 1.75},      {"minRange", 0.25},
      {"maxRange", 12.5},        {"sectors", 360},
      {"structureGap", 1.5},     {"structureTolerance", 0.375},
      {"pHit", 0.8125},          {"pMiss", 0.375},
      {"pMin", 0.0625},          {"pMax", 0.9375},
      {"structureMinZ", 2.0625}, {"maxDistanceInsertion", 7.5},
      {"structureMaxZ", 2.5}};
  std::string ini = "[map]\nmaxGridCells = 1e6\n[scanInsertion]\ninsert2D = false\n";
  for (const auto& [key, value] : values)
    if (key != "maxGridCells") ini += key + " = " + std::to_string(value) + "\n";
  // std::to_string() writes 360.000000, which is no whole number
  ini.replace(ini.find("360.000000"), 10, "360");
  const auto run = insertWith(ini);
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue parameters = parseJson(run.out)["parameters"];
  for (const auto& [key, value] : values) EXPECT_DOUBLE_EQ(value, parameters[key].number) << key;
  EXPECT_FALSE(parameters["insert2D"].truth);

  const auto summary = [this](std::vector<std::string> flags)
  {
    flags.insert(flags.begin(), {"insert", m_dir.path("chair.rawlog"), "-o", m_dir.path("out")});
    return mapconv(flags).out;
  };
  std::string text = summary({"-c", m_dir.path("my.ini")});
  for (const char* part :
       {"not default  maxGridCells = 1e+06", "sectors = 360", "pHit = 0.8125",
        "structureTolerance = 0.375", "insert2D = false", "maxDistanceInsertion = 7.5"})
    EXPECT_TRUE(contains(text, part)) << part << " in\n" << text;
  EXPECT_FALSE(contains(text, "decimation") || contains(text, "reflectionFilter =")) << text;
  text = summary({"--no-reflection-filter"});
  EXPECT_TRUE(contains(text, "\nnot default  reflectionFilter = false\n")) << text;
}

TEST_F(InsertInput, flagsWithoutEffectAreNamed)
{
  auto run = insert("chair.rawlog", {"--structure", "2.2", "2.6", "--no-reflection-filter"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "--structure has no effect")) << run.err;
  writeSimpleMap(m_dir.path("chair.simplemap"), {chair(0)});
  run = insert("chair.simplemap", {"--no-reflection-filter", "--static"});
  EXPECT_EQ(0, run.status);
  EXPECT_TRUE(contains(run.err, "--static has no effect")) << run.err;
}

TEST_F(InsertInput, aMapThatFewWallsAreSeenInIsWarnedOf)
{
  const auto run = insert("chair.rawlog", {"--structure", "2.2", "2.6"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "0.0 %") && contains(run.err, "structureMinZ")) << run.err;
  EXPECT_EQ(0, parseJson(run.out)["shareWithWall"].number);
}
