#include <gtest/gtest.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt/obs/CObservationGPS.h>
#include <sys/stat.h>

#include <filesystem>
#include <functional>

#include "OctreeFiles.h"
#include "Program.h"
#include "ScanFiles.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;
namespace fs = std::filesystem;

namespace
{
void write(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string handBytes()
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  return readBytes(dir.path("hand.bt"));
}

/** The hand map's file, saying that it has `nodes` nodes. */
std::string withNodeCount(const std::string& nodes)
{
  std::string bytes = handBytes();
  const auto begin = bytes.find("\nsize ") + 6;
  return bytes.replace(begin, bytes.find('\n', begin) - begin, nodes);
}

/** A file that cannot be converted, and a word that the error must hold besides the file's name. */
struct BadFile
{
  std::string name;
  std::function<void(const std::string& path)> make;
  std::string word;
};

std::vector<BadFile> badFiles()
{
  const auto bytes = [](const std::string& content)
  { return [content](const std::string& path) { write(path, content); }; };
  const std::string hand = handBytes();
  return {
      {"missing.bt", [](const std::string&) {}, "no such file"},
      {"missing.rawlog", [](const std::string&) {}, "no such file"},
      {"missing.map", [](const std::string&) {}, "no such file"},
      {"folder.bt", [](const std::string& path) { fs::create_directory(path); }, "directory"},
      {"empty.bt", bytes(""), "empty"},
      {"empty.rawlog", bytes(""), "empty"},
      {"empty.simplemap", bytes(""), "empty"},
      {"text.bt", bytes("this is no octree\n"), "OctoMap"},
      {"text.rawlog", bytes("this is no rawlog\n"), ""},
      {"text.map", bytes("this is no map\n"), "MRPT"},
      {"cut.bt", bytes(hand.substr(0, hand.size() - 9)), "nodes"},
      {"cut_header.bt", bytes(hand.substr(0, 60)), ""},
      {"liar.bt", bytes(withNodeCount("123456")), "123456"},
      {"huge_liar.bt", bytes(withNodeCount("99999999999999999999")), ""},
      {"no_nodes.bt", [](const std::string& path) { writeTree(octomap::OcTree(0.1), path); },
       "not one voxel"},
      {"empty_octomap.map",
       [](const std::string& path) { writeObjects(path, {mrpt::maps::COctoMap::Create(0.1)}); },
       "not one voxel"},
      {"no_scans.rawlog",
       [](const std::string& path) {
         writeObjects(path, {robotAt(0, 0), mrpt::obs::CObservationGPS::Create()});
       },
       "3D"},
      {"no_keyframes.simplemap", [](const std::string& path) { writeSimpleMap(path, {}, true); },
       "no scans"},
      {"cut.rawlog",
       [](const std::string& path)
       {
         writeObjects(path, {lookDown(0), lookDown(1)});
         fs::resize_file(path, fs::file_size(path) - 20);
       },
       "truncated"},
      {"cut.simplemap",
       [](const std::string& path)
       {
         writeSimpleMap(path, {0, 1, 2}, true);
         fs::resize_file(path, fs::file_size(path) - 20);
       },
       "truncated"},
  };
}
}  // namespace

TEST(BadInput, isOneClearErrorAndLeavesNoTrace)
{
  for (const BadFile& bad : badFiles())
    for (const std::string command : {"convert", "project"})
    {
      const TempDir dir;
      bad.make(dir.path(bad.name));
      const std::size_t entries = dir.entries();
      std::vector<std::string> arguments = {command, dir.path(bad.name), "-o", dir.path("out/deep"),
                                            "--json"};
      if (command == "project")
        for (const char* more : {"--z-min", "0", "--z-max", "1"}) arguments.emplace_back(more);
      const auto run = mapconv(arguments);
      EXPECT_EQ(1, run.status) << bad.name;
      EXPECT_EQ("", run.out) << bad.name;
      EXPECT_TRUE(isOneError(run.err)) << bad.name << ": " << run.err;
      EXPECT_TRUE(contains(run.err, bad.name)) << run.err;
      EXPECT_TRUE(contains(run.err, bad.word)) << bad.word << " in " << run.err;
      EXPECT_EQ(entries, dir.entries()) << bad.name << " left something behind";
    }
}

TEST(BadInput, infoSaysTheSame)
{
  for (const BadFile& bad : badFiles())
  {
    // of these info has something to tell
    if (contains(bad.word, "one voxel") || contains(bad.word, "3D") || bad.word == "no scans")
      continue;
    const TempDir dir;
    bad.make(dir.path(bad.name));
    const auto run = mapconv({"info", dir.path(bad.name), "--json"});
    EXPECT_EQ(1, run.status) << bad.name;
    EXPECT_EQ("", run.out) << bad.name;
    EXPECT_TRUE(isOneError(run.err)) << bad.name << ": " << run.err;
    EXPECT_TRUE(contains(run.err, bad.name)) << run.err;
  }
}

TEST(BadInput, leavesEarlierResultsAlone)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  write(dir.path("cut.bt"), handBytes().substr(0, 150));
  ASSERT_EQ(0, mapconv({"convert", dir.path("hand.bt"), "-o", dir.path("out")}).status);
  std::map<std::string, std::string> before;
  for (const auto& entry : fs::directory_iterator(dir.path("out")))
    before[entry.path().filename().string()] = readBytes(entry.path().string());
  EXPECT_EQ(1, mapconv({"convert", dir.path("cut.bt"), "-o", dir.path("out")}).status);
  std::map<std::string, std::string> after;
  for (const auto& entry : fs::directory_iterator(dir.path("out")))
    after[entry.path().filename().string()] = readBytes(entry.path().string());
  EXPECT_EQ(before, after);
}

TEST(BadInput, anOctreeWithoutFreeVoxelsIsAnErrorAndNoFolder)
{
  const TempDir dir;
  writeTree(treeOf(0.5, {{"oo", "o"}}, 0, 0), dir.path("solid.bt"));
  const auto run = mapconv(
      {"convert", dir.path("solid.bt"), "-o", dir.path("out"), "--max-step", "0.1", "--json"});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "solid.bt: no voxel of the map is free")) << run.err;
  EXPECT_EQ("", run.out);
  EXPECT_FALSE(fs::exists(dir.path("out")));
}

TEST(BadOutput, aFullDiskLeavesNothingNewAndNothingChanged)
{
  const TinyDisk disk(64);
  if (!disk.mounted()) GTEST_SKIP() << "no right to mount a small disk";
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  fs::create_directory(disk.path("out"));
  write(disk.path("out/layers.tif"), "earlier result");
  write(disk.path("filler"), std::string(40 << 10, 'x'));
  const auto run =
      mapconv({"convert", dir.path("hand.bt"), "-o", disk.path("out"), "--max-step", "0.1"});
  EXPECT_EQ(1, run.status);
  EXPECT_EQ("", run.out);
  EXPECT_TRUE(contains(run.err, "No space left on device")) << run.err;
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_EQ("earlier result", readBytes(disk.path("out/layers.tif")));
  EXPECT_EQ(1, std::distance(fs::directory_iterator(disk.path("out")), fs::directory_iterator()));
}

TEST(BadOutput, aFolderThatCannotBeWrittenIsNamedBeforeTheWorkBegins)
{
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  write(dir.path("file"), "mine");
  for (const std::string& out : {dir.path("file"), dir.path("file/sub"), std::string("/proc/no")})
  {
    const auto run = mapconv({"convert", dir.path("hand.bt"), "-o", out});
    EXPECT_EQ(1, run.status) << out;
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    EXPECT_TRUE(contains(run.err, out)) << run.err;
  }
  EXPECT_EQ("mine", readBytes(dir.path("file")));
}

TEST(BadOutput, aFullStdoutIsAnError)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const TempDir dir;
  HandMap::write(dir.path("hand.bt"));
  const auto run = mapconv(
      {"convert", dir.path("hand.bt"), "-o", dir.path("out"), "--max-step", "0.1"}, "/dev/full");
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(contains(run.err, "stdout")) << run.err;
}

TEST(BadInput, aSignalWhileWritingLeavesNothingBehind)
{
  const TempDir dir;
  ASSERT_EQ(0, mapconv({"sample-map", "outdoor", "-o", dir.path("big.bt")}).status);
  for (const char* after : {"0.3", "0.6", "0.9", "1.2"})
  {
    const std::string out = dir.path("out");
    runProgram(
        {"timeout", "-s", "INT", after, MAPCONV_PROGRAM, "convert", dir.path("big.bt"), "-o", out});
    if (!std::filesystem::exists(out)) continue;  // ended before the files were in place
    EXPECT_TRUE(std::filesystem::exists(out + "/map.3Dscene")) << after;
    for (const auto& entry : std::filesystem::directory_iterator(out))
      EXPECT_NE('.', entry.path().filename().string()[0]) << entry.path();
    std::filesystem::remove_all(out);
  }
}

TEST(BadInput, aFileThatMayNotGrowIsLikeAFullDisk)
{
  const TempDir dir;
  ASSERT_EQ(0, mapconv({"sample-map", "building", "-o", dir.path("b.bt")}).status);
  const auto run =
      runProgram({"bash", "-c", "ulimit -f 30; exec \"$0\" convert \"$1\" -o \"$2\" --max-step 0.1",
                  MAPCONV_PROGRAM, dir.path("b.bt"), dir.path("out")});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
}

TEST(BadInput, aSignalThatTheCallerIgnoresIsIgnored)
{
  const TempDir dir;
  ASSERT_EQ(0, mapconv({"sample-map", "outdoor", "-o", dir.path("big.bt")}).status);
  const auto run = runProgram({"bash", "-c",
                               "trap '' HUP; \"$0\" convert \"$1\" -o \"$2\" & "
                               "sleep 0.4; kill -HUP $!; wait $!",
                               MAPCONV_PROGRAM, dir.path("big.bt"), dir.path("out")});
  EXPECT_EQ(0, run.status) << run.err;
  EXPECT_TRUE(std::filesystem::exists(dir.path("out") + "/map.3Dscene"));
}
