#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "InsertRuns.h"
#include "OctreeFiles.h"
#include "support/TempDir.h"

// What messages say is true, said once, and in lines that no file's name can break.
namespace
{
using namespace mrpt_mapconv::testing;
namespace fs = std::filesystem;

std::size_t countOf(const std::string& words, const std::string& text)
{
  std::size_t count = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

class ReportMessages : public ::testing::Test
{
 protected:
  std::string path(const std::string& name) const { return m_dir.path(name); }
  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  Outcome insert(const std::string& log, std::vector<std::string> flags) const
  {
    flags.insert(flags.begin(), {"insert", path(log), "-o", path("map"), "--json"});
    return mapconv(flags);
  }
  Outcome convert(const std::string& log, std::vector<std::string> flags) const
  {
    flags.insert(flags.begin(), {"convert", path(log), "-o", path("out"), "--max-step", "0.1"});
    return mapconv(flags);
  }

  TempDir m_dir;
};

TEST_F(ReportMessages, TheGapBetweenPosesCanBeSet)
{
  writeObjects(path("a.rawlog"), {robotAt(0, 0), lookDown(2), robotAt(1, 4)});
  const auto refused = convert("a.rawlog", {});
  expectWords(refused, {"no 3D scan lies within", "--max-pose-gap"});
  for (const auto& run : {convert("a.rawlog", {"--max-pose-gap", "2"}),
                          insert("a.rawlog", {"--no-reflection-filter", "--max-pose-gap=2"})})
    EXPECT_FALSE(contains(run.err, "lies within")) << run.err;
  EXPECT_EQ(2, convert("a.rawlog", {"--max-pose-gap", "-1"}).status);
  HandMap::write(path("a.bt"));
  const auto none = convert("a.bt", {"--max-pose-gap", "2"});
  EXPECT_TRUE(contains(none.err, "--max-pose-gap has no effect")) << none.err;
}

TEST_F(ReportMessages, PosesWithoutALabelCanBeChosen)
{
  writeObjects(path("a.rawlog"), {robotAt(0, 0), odometryAt(5, 0), lookDown(0)});
  EXPECT_TRUE(contains(convert("a.rawlog", {}).err, "'robotPose' (1), 'odometry' (1)"));
  for (const std::string source : {"", "odometry", "robotPose"})
  {
    const auto run = convert("a.rawlog", {"--pose-source", source});
    EXPECT_EQ(0, run.status) << run.err;
    EXPECT_EQ("", run.err) << source;
  }
  writeObjects(path("b.rawlog"), {odometryAt(5, 0), lookDown(0)});
  expectWords(convert("b.rawlog", {"--pose-source", "robotPose"}), {"there are: 'odometry' (1)"});
}

TEST_F(ReportMessages, ALogOf2DScansThatAreLeftOutNamesTheKey)
{
  writeObjects(path("a.rawlog"), {robotAt(0, 0), scan2D(0)});
  write("my.ini", "[voxelInsertion]\ninsert2D = false\n");
  expectWords(convert("a.rawlog", {"-c", path("my.ini")}),
              {"a.rawlog", "all of its scans are 2D", "insert2D = false of", "my.ini"});
}

TEST_F(ReportMessages, WallsThatNobodyLooksForAreNamed)
{
  writeObjects(path("a.rawlog"), {chair(0)});
  write("off.ini", "[scanInsertion]\nreflectionFilter = false\n");
  write("walls.ini",
        "[scanInsertion]\nstructureMinZ = 2\nstructureMaxZ = 3\nstructureGap = -1\nsectors = 0\n");
  const auto expectOne = [](const Outcome& run, const std::string& words)
  {
    EXPECT_EQ(0, run.status) << run.err;
    EXPECT_TRUE(contains(run.err, words)) << words << " in " << run.err;
    EXPECT_EQ(1U, countOf("no effect", run.err)) << run.err;
  };
  expectOne(insert("a.rawlog", {"-c", path("off.ini"), "--structure", "2", "3"}),
            "--structure has no effect: reflectionFilter = false of " + path("off.ini"));
  expectOne(insert("a.rawlog", {"--no-reflection-filter", "--structure", "2", "3"}),
            "--structure has no effect: --no-reflection-filter");
  expectOne(insert("a.rawlog", {"-c", path("walls.ini"), "--no-reflection-filter"}),
            "structureMinZ, structureMaxZ of " + path("walls.ini") +
                " have no effect: --no-reflection-filter");
  EXPECT_FALSE(contains(insert("a.rawlog", {"-c", path("walls.ini")}).err, "no effect"));
  expectOne(insert("a.rawlog", {"--no-reflection-filter", "--static", "--pose-source", "x"}),
            "--pose-source has no effect: --static");
}

TEST_F(ReportMessages, WhyScansAreSkippedIsSaidOnce)
{
  writeObjects(path("a.rawlog"), {chair(0), cloudOn({}, {0, 0, 1}, 0)});
  const auto run = mapconv(
      {"insert", path("a.rawlog"), "-o", path("map"), "--static", "--no-reflection-filter"});
  EXPECT_EQ(0, run.status);
  EXPECT_EQ(1U, countOf("no usable point", run.err + run.out)) << run.err << run.out;
  EXPECT_TRUE(contains(run.err, "1 of 2 scans is skipped: ")) << run.err;
}

TEST_F(ReportMessages, ANewLineInANameBreaksNoLine)
{
  const std::string name = "nl\nkind         forged.bt";
  expectWords(mapconv({"info", path(name)}), {"nl kind         forged.bt: no such file"});
  HandMap::write(path(name));
  const auto info = mapconv({"info", path(name)});
  EXPECT_EQ(0, info.status) << info.err;
  EXPECT_FALSE(contains(info.out, "\nkind         forged")) << info.out;
  const auto run = convert(name, {});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_FALSE(contains(run.out, "\nkind")) << run.out;
  write("bad\n.bt", "nothing");
  expectWords(convert("bad\n.bt", {}), {"bad .bt: ", "not an OctoMap file"});
}

TEST_F(ReportMessages, WhatIsPipedInIsCalledStdin)
{
  const std::string map = MRPT_MAPCONV_SHARED_DIR "/real/laberynth.bt";
  if (!fs::exists(map)) GTEST_SKIP() << map << " is not there";
  const auto piped = [&](std::vector<std::string> words)
  {
    words.insert(words.begin(), {"bash", "-c", "file=\"$1\"; shift; \"$0\" \"$@\" < \"$file\"",
                                 MAPCONV_PROGRAM, map});
    return runProgram(words);
  };
  const auto converted = piped({"convert", "-", "-o", path("out"), "--max-step", "0.1"});
  EXPECT_TRUE(contains(converted.err, "error: stdin: no voxel of the map is free"))
      << converted.err;
  const auto projected = piped({"project", "-", "-o", path("p"), "--z-min", "0", "--z-max", "1"});
  EXPECT_TRUE(contains(projected.err, "warning: stdin: no voxel")) << projected.err;
}

}  // namespace
