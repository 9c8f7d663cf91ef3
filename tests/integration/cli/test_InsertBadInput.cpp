#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include "InsertRuns.h"
#include "OctreeFiles.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;
namespace fs = std::filesystem;

// Files that mapconv insert can make nothing of, and places that it cannot write to.

namespace
{
std::map<std::string, std::string> filesIn(const std::string& dir)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(dir))
    files[entry.path().filename().string()] = readBytes(entry.path().string());
  return files;
}

void write(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

void cutShort(const std::string& path) { fs::resize_file(path, fs::file_size(path) - 20); }

/** A file that nothing can be made of, and a word that the error must hold besides its name. */
struct BadFile
{
  std::string name;
  std::function<void(const std::string& path)> make;
  std::string word;
};

std::vector<BadFile> badFiles()
{
  using mrpt::maps::COccupancyGridMap2D;
  const auto objects = [](const Objects& list)
  { return [list](const std::string& path) { writeObjects(path, list); }; };
  const auto far = cloudOn({{1.75f, 0.25f, 0.5f}}, {0.25, 0.25, 1}, 1);
  return {
      {"missing.rawlog", [](const std::string&) {}, "no such file"},
      {"missing.map", [](const std::string&) {}, "no such file"},
      {"folder.rawlog", [](const std::string& path) { fs::create_directory(path); }, "directory"},
      {"empty.rawlog", [](const std::string& path) { write(path, ""); }, "empty"},
      {"text.map", [](const std::string& path) { write(path, "no map\n"); }, "MRPT"},
      {"octree.bt", [](const std::string& path) { HandMap::write(path); }, "octree"},
      {"octree.rawlog", [](const std::string& path) { HandMap::write(path); }, "octree"},
      {"a.gridmap", objects({COccupancyGridMap2D::Create()}), "COccupancyGridMap2D"},
      {"2d.rawlog", objects({robotAt(0, 0), scan2D(0)}), "holds 1 scan, but no 3D scan"},
      {"2d.simplemap", [](const std::string& path) { writeSimpleMap(path, {scan2D(0)}); }, "3D"},
      {"unposed.rawlog", objects({chair(0), chair(1)}), "--static"},
      {"cut.rawlog",
       [](const std::string& path)
       {
         writeObjects(path, {chair(0), chair(1)});
         cutShort(path);
       },
       "truncated"},
      {"cut.simplemap",
       [](const std::string& path)
       {
         writeSimpleMap(path, {chair(0), chair(0), chair(0)});
         cutShort(path);
       },
       "truncated"},
      {"floor.rawlog", objects({cloudOn({{1, 0, 0}}, {0, 0, 1}, 0)}), "none of its scans"},
      {"nan.rawlog", objects({cloudOn({}, {0, 0, 1}, 0)}), "1: it has no usable point"},
      {"far.rawlog", objects({robotAt(0, 0), chair(0), far, robotAt(3e4, 1)}), "maxGridCells"},
  };
}
}  // namespace

TEST(InsertBadInput, isOneClearErrorAndLeavesNoTrace)
{
  for (const BadFile& bad : badFiles())
  {
    const TempDir dir;
    bad.make(dir.path(bad.name));
    write(dir.path("small.ini"), "[map]\nmaxGridCells = 100000\n");
    const std::size_t entries = dir.entries();
    const auto run = mapconv({"insert", dir.path(bad.name), "-o", dir.path("out/deep"), "--json",
                              "-c", dir.path("small.ini"), "--no-reflection-filter"});
    EXPECT_EQ(1, run.status) << bad.name;
    expectWords(run, {bad.name, bad.word});
    EXPECT_EQ(entries, dir.entries()) << bad.name << " left something behind";
  }
}

TEST(InsertBadInput, leavesEarlierResultsAlone)
{
  const TempDir dir;
  writeObjects(dir.path("chair.rawlog"), {chair(0)});
  write(dir.path("bad.rawlog"), "nonsense");
  const auto insert = [&dir](const std::string& file)
  {
    return mapconv({"insert", dir.path(file), "-o", dir.path("out"), "--no-reflection-filter"})
        .status;
  };
  ASSERT_EQ(0, insert("chair.rawlog"));
  const auto before = filesIn(dir.path("out"));
  EXPECT_EQ(5U, before.size());
  EXPECT_EQ(1, insert("bad.rawlog"));
  EXPECT_EQ(before, filesIn(dir.path("out")));
}

TEST(InsertBadOutput, aFolderThatCannotBeWrittenIsNamed)
{
  const TempDir dir;
  writeObjects(dir.path("chair.rawlog"), {chair(0)});
  write(dir.path("file"), "mine");
  for (const std::string& out : {dir.path("file"), dir.path("file/sub"), std::string("/proc/no")})
  {
    const auto run =
        mapconv({"insert", dir.path("chair.rawlog"), "-o", out, "--no-reflection-filter"});
    EXPECT_EQ(1, run.status) << out;
    expectWords(run, {out});
  }
  EXPECT_EQ("mine", readBytes(dir.path("file")));
}

TEST(InsertBadOutput, aFullDiskLeavesNothingNewAndNothingChanged)
{
  const TinyDisk disk(64);
  if (!disk.mounted()) GTEST_SKIP() << "no right to mount a small disk";
  const TempDir dir;
  writeObjects(dir.path("chair.rawlog"), {chair(0)});
  fs::create_directory(disk.path("out"));
  write(disk.path("out/map.tif"), "earlier result");
  write(disk.path("filler"), std::string(44 << 10, 'x'));
  const auto run = mapconv(
      {"insert", dir.path("chair.rawlog"), "-o", disk.path("out"), "--no-reflection-filter"});
  EXPECT_EQ(1, run.status);
  expectWords(run, {"No space left on device"});
  EXPECT_EQ((std::map<std::string, std::string>{{"map.tif", "earlier result"}}),
            filesIn(disk.path("out")));
}

TEST(InsertBadOutput, aFileThatMayNotGrowIsLikeAFullDisk)
{
  const TempDir dir;
  writeObjects(dir.path("chair.rawlog"), {chair(0)});
  const auto run = runProgram(
      {"bash", "-c", "ulimit -f 1; exec \"$0\" insert \"$1\" -o \"$2\" --no-reflection-filter",
       MAPCONV_PROGRAM, dir.path("chair.rawlog"), dir.path("out")});
  EXPECT_EQ(1, run.status);
  expectWords(run, {});
  EXPECT_FALSE(fs::exists(dir.path("out")));
}
