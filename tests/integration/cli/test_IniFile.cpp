#include <gtest/gtest.h>

#include <filesystem>

#include "OctreeFiles.h"
#include "Program.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
/** Converts the hand map with an ini file of this text. */
class IniFile : public ::testing::Test
{
 protected:
  IniFile() { HandMap::write(m_dir.path("hand.bt")); }

  Outcome convertWith(const std::string& ini, std::vector<std::string> flags = {})
  {
    std::ofstream(m_dir.path("my.ini")) << ini;
    flags.insert(flags.begin(), {"convert", m_dir.path("hand.bt"), "-o", m_dir.path("out"), "-c",
                                 m_dir.path("my.ini"), "--json"});
    return mapconv(flags);
  }

  TempDir m_dir;
};
}  // namespace

TEST_F(IniFile, setsTheParameters)
{
  const auto run = convertWith(
      "[conversion]\nminClearance = 0.5 // comment\nminOccupancy=0.25\nslopeWindow = 3\n"
      "maxSlope = 1.5 ; comment\nmaxStep = 0.1\nrobot = aerial\n\n# "
      "comment\n[voxelInsertion]\nmaxrange "
      "= 5\n");
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "convert makes layers for both")) << run.err;
  EXPECT_TRUE(contains(run.err, "maxrange of ")) << "the input holds no scans: " << run.err;
  const JsonValue used = parseJson(run.out)["parameters"];
  EXPECT_EQ(0.5, used["minClearance"].number);
  EXPECT_EQ(0.25, used["minOccupancy"].number);
  EXPECT_EQ(3, used["slopeWindow"].number);
  EXPECT_EQ(1.5, used["maxSlope"].number);
  EXPECT_EQ(0.1, used["maxStep"].number);
}

TEST_F(IniFile, flagsWin)
{
  const auto run =
      convertWith("[conversion]\nslopeWindow = 3\nmaxStep = 0.2\n", {"--slope-window", "1"});
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue used = parseJson(run.out)["parameters"];
  EXPECT_EQ(1, used["slopeWindow"].number);
  EXPECT_EQ(0.2, used["maxStep"].number);
  EXPECT_EQ(1.0, used["minClearance"].number);
}

TEST_F(IniFile, aFlagDoesNotHideABadValueOfTheFile)
{
  for (const char* value : {"banana", "-1", "nan", "1,5", ""})
  {
    const auto run = convertWith(std::string("[conversion]\nminClearance = ") + value + "\n",
                                 {"--min-clearance", "0.5"});
    EXPECT_EQ(1, run.status) << value;
    EXPECT_TRUE(contains(run.err, "section 'conversion': minClearance = ")) << run.err;
  }
}

TEST_F(IniFile, aKeyInOtherCapitalsHasNoEffectAndThatIsSaid)
{
  const auto run = convertWith("[conversion]\nMINCLEARANCE = 0.7\nmaxStep = 0.1\n");
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_TRUE(contains(run.err, "unknown key 'MINCLEARANCE' has no effect")) << run.err;
  EXPECT_EQ(1.0, parseJson(run.out)["parameters"]["minClearance"].number);
}

TEST_F(IniFile, keysBeforeAnySectionAreOfAnUnknownOne)
{
  const auto run = convertWith("minClearance = 2\n[conversion]\nmaxStep = 0.1\n");
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(
      contains(run.err, "unknown section [] has no effect; [conversion] and [voxelInsertion] do"))
      << run.err;
}

TEST_F(IniFile, theShippedFileHoldsTheDefaults)
{
  const auto without = convertWith("[conversion]\n");
  const auto with =
      mapconv({"convert", m_dir.path("hand.bt"), "-o", m_dir.path("out"), "-c",
               MRPT_MAPCONV_SOURCE_DIR "/config/freeSpaceGrid/convert.ini", "--json"});
  ASSERT_EQ(0, with.status) << with.err;
  EXPECT_EQ(without.err, with.err) << "no warning of its own";
  const JsonValue a = parseJson(without.out)["parameters"], b = parseJson(with.out)["parameters"];
  for (const char* name : {"minClearance", "minOccupancy", "slopeWindow", "maxSlope", "maxStep"})
    EXPECT_EQ(a[name].number, b[name].number) << name;
  EXPECT_EQ("auto", b["maxStep"].text);
  EXPECT_EQ("seen", b["floorFrom"].text);
}

TEST_F(IniFile, thePapersParametersHaveANameAFlagAndAFile)
{
  const auto byKey = convertWith("[conversion]\npaper = true\n");
  const auto byFlag = convertWith("[conversion]\nmaxStep = 0.3\nmaxSlope = 1\n", {"--paper"});
  const auto byFile =
      mapconv({"convert", m_dir.path("hand.bt"), "-o", m_dir.path("out"), "-c",
               MRPT_MAPCONV_SOURCE_DIR "/config/freeSpaceGrid/paper.ini", "--json"});
  for (const auto& run : {byKey, byFlag, byFile})
  {
    ASSERT_EQ(0, run.status) << run.err;
    const JsonValue used = parseJson(run.out)["parameters"];
    EXPECT_EQ(1.0, used["minClearance"].number);
    EXPECT_EQ(0.5, used["minOccupancy"].number);
    EXPECT_EQ(2, used["slopeWindow"].number);
    EXPECT_EQ(2.0, used["maxSlope"].number);
    EXPECT_EQ(0.0, used["maxStep"].number);
    EXPECT_EQ("lowestFree", used["floorFrom"].text);
  }
}

TEST_F(IniFile, whatStandsBesideThePapersNameReplacesItsValues)
{
  const auto run = convertWith("[conversion]\nmaxStep = 0.3\npaper = true\nmaxGap = 4\n",
                               {"--floor-from", "seen"});
  ASSERT_EQ(0, run.status) << run.err;
  const JsonValue used = parseJson(run.out)["parameters"];
  EXPECT_EQ(0.3, used["maxStep"].number);
  EXPECT_EQ("seen", used["floorFrom"].text);
  EXPECT_FALSE(contains(run.err, "maxGap")) << run.err;
  const auto useless = convertWith("[conversion]\npaper = true\nmaxGap = 4\n");
  EXPECT_TRUE(contains(useless.err, "maxGap of ")) << useless.err;
  EXPECT_TRUE(contains(useless.err, "has no effect: floorFrom is lowestFree")) << useless.err;
}

TEST_F(IniFile, aStepMayBeAuto)
{
  const auto run = convertWith("[conversion]\nmaxStep = 0.3\n", {"--max-step", "auto"});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_EQ("auto", parseJson(run.out)["parameters"]["maxStep"].text);
  for (const std::string value : {"+0.2", "AUTO"})  // what one takes, the other does
  {
    const auto inFile = convertWith("[conversion]\nmaxStep = " + value + "\n");
    const auto asFlag = convertWith("[conversion]\n", {"--max-step", value});
    ASSERT_EQ(0, inFile.status) << inFile.err;
    ASSERT_EQ(0, asFlag.status) << asFlag.err;
    const JsonValue one = parseJson(inFile.out)["parameters"]["maxStep"];
    const JsonValue other = parseJson(asFlag.out)["parameters"]["maxStep"];
    EXPECT_EQ(one.text, other.text) << value;
    EXPECT_EQ(one.number, other.number) << value;
  }
  for (const std::string bad : {"high", "", "-0.1", "nan"})
  {
    const auto refused = convertWith("[conversion]\n", {"--max-step", bad});
    EXPECT_NE(0, refused.status) << bad;
    EXPECT_TRUE(contains(refused.err, "--max-step: ")) << refused.err;
    EXPECT_TRUE(contains(refused.err, "auto")) << refused.err;
  }
}

TEST_F(IniFile, typosAreNamedInAWarning)
{
  const auto run = convertWith(
      "[conversion]\nminClearence = 0.5\nmaxStep = 0.1\n[voxelInsertion]\nmaxRange = "
      "3\n[other]\na=b\n");
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(3, warningsIn(run.err)) << run.err;
  for (const char* word : {"my.ini", "minClearence", "maxRange", "[other]"})
    EXPECT_TRUE(contains(run.err, word)) << word << " in " << run.err;
  EXPECT_EQ(3, std::count(run.err.begin(), run.err.end(), '\n')) << run.err;
}

TEST_F(IniFile, theOldNameOfASectionIsReadAndNamedInAWarning)
{
  const auto run = convertWith("[conversion]\nmaxStep = 0.1\n[insertion]\nmaxrange = -1\n");
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "[insertion] is now called [voxelInsertion]")) << run.err;
  const auto bad = convertWith("[insertion]\nmaxrange = far\n");
  EXPECT_EQ(1, bad.status) << "its keys count";
  EXPECT_TRUE(contains(bad.err, "section 'insertion': maxrange = 'far'")) << bad.err;
}

TEST_F(IniFile, theOldNameBesideTheNewOneHasNoEffectAndThatIsSaid)
{
  const auto run = convertWith(
      "[conversion]\nmaxStep = 0.1\n[insertion]\nmaxrange = far\n[voxelInsertion]\nmaxrange = "
      "-1\n");
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_EQ(1, warningsIn(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "[insertion] has no effect beside [voxelInsertion]")) << run.err;
}

TEST_F(IniFile, badValuesAreErrorsThatNameFileSectionKeyAndValue)
{
  const std::vector<std::array<std::string, 3>> cases = {
      {"conversion", "minClearance", "banana"}, {"conversion", "minClearance", "1,5"},
      {"conversion", "minClearance", "-1"},     {"conversion", "maxSlope", "nan"},
      {"conversion", "minOccupancy", "1.5"},    {"conversion", "slopeWindow", "0"},
      {"conversion", "slopeWindow", "1.5"},     {"conversion", "robot", "submarine"},
      {"voxelInsertion", "maxrange", "far"},    {"voxelInsertion", "probHit", "1.7"},
      {"voxelInsertion", "pruning", "perhaps"}};
  for (const auto& [section, key, value] : cases)
  {
    const auto run = convertWith("[" + section + "]\n" + key + " = " + value + "\n");
    EXPECT_EQ(1, run.status) << key << " " << value;
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    for (const std::string& word : {std::string("my.ini"), section, key, value})
      EXPECT_TRUE(contains(run.err, word)) << word << " in " << run.err;
    EXPECT_FALSE(std::filesystem::exists(m_dir.path("out")));
  }
}

TEST_F(IniFile, aLineThatIsNoIniIsAnError)
{
  const auto run = convertWith("[conversion]\nminClearance 0.5\n");
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "line 2: 'minClearance 0.5'")) << run.err;
}

TEST_F(IniFile, aMissingFileIsAnError)
{
  for (const std::string& file : {m_dir.path("none.ini"), m_dir.path()})
  {
    const auto run =
        mapconv({"convert", m_dir.path("hand.bt"), "-o", m_dir.path("out"), "-c", file});
    EXPECT_EQ(1, run.status);
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    EXPECT_TRUE(contains(run.err, file)) << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(m_dir.path("out")));
}
