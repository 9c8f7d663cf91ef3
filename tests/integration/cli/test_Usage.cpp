#include <gtest/gtest.h>

#include <filesystem>

#include "OctreeFiles.h"
#include "Program.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
/** Arguments that are wrong usage, and what the error must name. */
struct WrongUsage
{
  std::vector<std::string> arguments;
  std::string word;
};

std::vector<std::string> convertWith(const TempDir& dir, std::vector<std::string> flags)
{
  flags.insert(flags.begin(), {"convert", dir.path("hand.bt"), "-o", dir.path("out")});
  return flags;
}
}  // namespace

TEST(Usage, helpAndVersionAreNoErrors)
{
  for (const std::string command :
       {"", "convert", "project", "insert", "terrain", "ground", "info", "run", "sample-map"})
  {
    std::vector<std::string> arguments = {command, "--help"};
    if (command.empty()) arguments.erase(arguments.begin());
    const auto run = mapconv(arguments);
    EXPECT_EQ(0, run.status) << command;
    EXPECT_EQ("", run.err) << command;
    EXPECT_TRUE(contains(run.out, "xample:\n  mapconv ")) << run.out;
  }
  const auto version = mapconv({"--version"});
  EXPECT_EQ(0, version.status);
  EXPECT_EQ("mapconv ", version.out.substr(0, 8));
}

TEST(Usage, wrongUsageIsStatus2AndOneLineThatNamesIt)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  const std::string input = dir.path("hand.bt");
  const std::vector<WrongUsage> cases = {
      {{}, "subcommand"},
      {{"frobnicate"}, "frobnicate"},
      {{"--frobnicate"}, "frobnicate"},
      {{"convert"}, "INPUT"},
      {{"convert", input}, "--output"},
      {{"convert", "-o", dir.path("out")}, "INPUT"},
      {{"convert", input, "second.bt", "-o", dir.path("out")}, "second.bt"},
      {convertWith(dir, {"--frobnicate"}), "frobnicate"},
      {convertWith(dir, {"--threads", "-1"}), "--threads"},
      {convertWith(dir, {"--threads", "two"}), "--threads"},
      {convertWith(dir, {"--resolution", "0"}), "--resolution"},
      {convertWith(dir, {"--resolution", "nan"}), "--resolution"},
      {convertWith(dir, {"--slope-window", "0"}), "--slope-window"},
      {convertWith(dir, {"--slope-window", "1.5"}), "--slope-window"},
      {convertWith(dir, {"--min-occupancy", "1.01"}), "--min-occupancy"},
      {convertWith(dir, {"--min-clearance"}), "--min-clearance"},
      {{"project", input, "-o", dir.path("out")}, "--z-m"},
      {{"insert"}, "INPUT"},
      {{"insert", input}, "--output"},
      {{"insert", "-o", dir.path("out"), "--structure", "2.2", "2.6"}, "INPUT"},
      {{"insert", input, "-o", dir.path("out"), "--no-2d", "0"}, "0"},
      {{"terrain"}, "INPUT"},
      {{"terrain", input}, "--output"},
      {{"terrain", input, "-o", dir.path("out"), "--frobnicate"}, "frobnicate"},
      {{"ground"}, "INPUT"},
      {{"ground", input}, "--output"},
      {{"ground", input, "-o", dir.path("out"), "--frobnicate"}, "frobnicate"},
      {{"ground", input, "-o", dir.path("out"), "--cell-size", "0"}, "--cell-size"},
      {{"ground", input, "-o", dir.path("out"), "--ground-filter", "pmf"}, "--ground-filter"},
      {{"ground", input, "-o", dir.path("out"), "--points"}, "--points"},
      {{"ground", input, "-o", dir.path("out"), "--origin", "1e300,0,0"}, "-1e9 to 1e9"},
      {{"info"}, "FILE"},
      {{"run"}, "program"},
      {{"run", "--"}, "program"},
      {{"sample-map", "castle", "-o", dir.path("x.bt")}, "castle"},
      {{"sample-map", "building"}, "--output"},
      {{"sample-map", "building", "-o", dir.path("x.txt")}, ".bt"},
  };
  for (const auto& [arguments, word] : cases)
  {
    const auto run = mapconv(arguments);
    EXPECT_EQ(2, run.status) << word;
    EXPECT_EQ("", run.out) << word;
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    EXPECT_TRUE(contains(run.err, word)) << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
}

TEST(Usage, aValueThatIsNoValidNumberIsNamedWithItsFlag)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  for (const std::string flag : {"--min-clearance", "--min-occupancy", "--max-slope", "--max-step"})
    for (const std::string value : {"1,5", "nan", "-1", "abc", "", "0.5m", "inf"})
    {
      const auto run = mapconv(convertWith(dir, {flag, value}));
      EXPECT_EQ(2, run.status) << flag << " " << value;
      EXPECT_TRUE(isOneError(run.err)) << run.err;
      EXPECT_TRUE(contains(run.err, flag)) << run.err;
      EXPECT_TRUE(contains(run.err, value)) << run.err;
    }
  EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
}

TEST(SampleMap, writesAMapThatConverts)
{
  const TempDir dir;
  const auto made =
      mapconv({"sample-map", "building", "-o", dir.path("b.bt"), "--resolution", "0.2"});
  ASSERT_EQ(0, made.status) << made.err;
  EXPECT_EQ("", made.err);
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(dir.path("b.bt")));
  EXPECT_EQ(0.2, tree.getResolution());
  EXPECT_GT(tree.getNumLeafNodes(), 1000u);
  EXPECT_EQ(1u, dir.entries());
  const auto converted =
      mapconv({"convert", dir.path("b.bt"), "-o", dir.path("out"), "--max-step", "0.1"});
  EXPECT_EQ(0, converted.status) << converted.err;
}

TEST(SampleMap, badResolutionIsAnErrorAndLeavesNoFile)
{
  const TempDir dir;
  const auto run = mapconv({"sample-map", "building", "-o", dir.path("b.bt"), "--resolution", "9"});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_EQ(0u, dir.entries());
}
