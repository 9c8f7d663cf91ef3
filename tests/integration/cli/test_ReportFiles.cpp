#include <gtest/gtest.h>
#include <mrpt_mapconv/params/Printable.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "OctreeFiles.h"
#include "Program.h"
#include "ScanFiles.h"
#include "StrictJson.h"
#include "support/Gzip.h"
#include "support/TempDir.h"

// What the files of users are: packed, piped, foreign, incomplete, on disks that are full.
namespace
{
using namespace mrpt_mapconv::testing;
namespace fs = std::filesystem;

const std::string kReports = MRPT_MAPCONV_SHARED_DIR "/reports/";

void write(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

void gzip(const std::string& from, const std::string& to) { writeGzipped(to, readBytes(from)); }

/** `command` in a shell that has a file on its stdin, by way of a pipe; $0 is the program. */
Outcome piped(const std::string& file, std::vector<std::string> arguments)
{
  std::vector<std::string> words = {
      "bash", "-c", "file=\"$1\"; shift; cat \"$file\" | \"$0\" \"$@\"", MAPCONV_PROGRAM, file};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return runProgram(words);
}

class ReportFiles : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    HandMap::write(path("hand.bt"));
    gzip(path("hand.bt"), path("hand.bt.gz"));
  }

  std::string path(const std::string& name) const { return m_dir.path(name); }
  std::vector<std::string> convert(const std::string& input) const
  {
    return {"convert", input, "-o", path("out"), "--max-step", "0.1", "--json"};
  }
  static void expectFree(double cells, const Outcome& run)
  {
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_EQ("", run.err);
    EXPECT_EQ(cells, parseJson(run.out)["free"].number);
  }
  static void expectHandMap(const Outcome& run) { expectFree(HandMap::free, run); }
  static void expectProjection(const Outcome& run)
  {
    const auto& cells = HandMap::projection;
    expectFree(static_cast<double>(std::count(cells.begin(), cells.end(), 0)), run);
  }
  /** One error that holds these words. */
  static void expectError(const Outcome& run, const std::vector<std::string>& words)
  {
    EXPECT_EQ(1, run.status);
    EXPECT_EQ("", run.out);
    EXPECT_TRUE(isOneError(run.err)) << run.err;
    for (const auto& word : words) EXPECT_TRUE(contains(run.err, word)) << word << ": " << run.err;
  }

  TempDir m_dir;
};

TEST_F(ReportFiles, AnOctreeMayBeGzipped)
{
  expectHandMap(mapconv(convert(path("hand.bt.gz"))));
  fs::rename(path("hand.bt.gz"), path("packed"));
  expectHandMap(mapconv(convert(path("packed"))));
  expectProjection(mapconv({"project", path("packed"), "-o", path("flat"), "--z-min", "0.5",
                            "--z-max", "1.5", "--json"}));
  const auto info = mapconv({"info", path("packed"), "--json"});
  EXPECT_EQ("octree", parseJson(info.out)["kind"].text) << info.err;
}

TEST_F(ReportFiles, AGzippedOctreeThatIsCutOffIsNamed)
{
  fs::resize_file(path("hand.bt.gz"), fs::file_size(path("hand.bt.gz")) - 10);
  for (const std::string command : {"convert", "info"})
  {
    auto words = convert(path("hand.bt.gz"));
    if (command == "info") words = {"info", path("hand.bt.gz")};
    expectError(mapconv(words), {"hand.bt.gz", "truncated or damaged", "unexpected end of file"});
  }
}

TEST_F(ReportFiles, TheMapsOfTheReportsAreReadAsTheUnpackedOnes)
{
  if (!fs::exists(kReports)) GTEST_SKIP() << kReports << " is not there";
  for (const std::string name : {"map.bt", "color.ot"})
  {
    const auto unpack = runProgram({"gzip", "-dc", kReports + name + ".gz"}, path(name));
    ASSERT_EQ(0, unpack.status);
    const auto packed = mapconv(convert(kReports + name + ".gz"));
    const auto plain = mapconv(convert(path(name)));
    ASSERT_EQ(0, packed.status) << packed.err;
    for (const char* count : {"free", "occupied", "unknown", "cells"})
      EXPECT_EQ(parseJson(plain.out)[count].number, parseJson(packed.out)[count].number);
  }
}

TEST_F(ReportFiles, AnOctreeMayComeThroughAPipe)
{
  for (const char* name : {"hand.bt", "hand.bt.gz"})
  {
    expectHandMap(piped(path(name), convert("-")));
    expectHandMap(piped(path(name), convert("/dev/stdin")));
    expectProjection(piped(path(name), {"project", "-", "-o", path("flat"), "--z-min", "0.5",
                                        "--z-max", "1.5", "--json"}));
    const auto info = piped(path(name), {"info", "-", "--json"});
    EXPECT_EQ("octree", parseJson(info.out)["kind"].text) << info.err;
  }
  const auto text =
      piped(path("hand.bt"), {"convert", "-", "-o", path("out"), "--max-step", "0.1"});
  EXPECT_EQ(0U, text.out.find("stdin, OctoMap file (OcTree) -> ")) << text.out;
  EXPECT_FALSE(fs::exists("stdin"));
}

TEST_F(ReportFiles, ALogMayComeThroughAPipe)
{
  writeObjects(path("log"), {robotAt(0, 0), lookDown(0), robotAt(1, 1), lookDown(1)}, true);
  writeSimpleMap(path("map"), {0, 1}, true);
  for (const std::string name : {"log", "map"})
  {
    const auto named = mapconv(convert(path(name)));
    const auto run = piped(path(name), convert("-"));
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_EQ(parseJson(named.out)["free"].number, parseJson(run.out)["free"].number);
    const auto inserted =
        piped(path(name), {"insert", "-", "-o", path("grid"), "--json", "--no-reflection-filter"});
    EXPECT_FALSE(contains(inserted.err, "is no file")) << inserted.err;
    EXPECT_EQ(0, piped(path(name), {"info", "-"}).status);
  }
}

TEST_F(ReportFiles, APathMayComeThroughAPipeAndItsVoxelsMayBeGzipped)
{
  ASSERT_EQ(0, mapconv(convert(path("hand.bt"))).status);
  write(path("way.csv"), "\xEF\xBB\xBFx,y\r\n-0.75,0.75\r\n-0.75,1.25\r\n");
  const std::vector<std::string> lift = {"lift", path("out"),      "-", "--robot", "ground",
                                         "-o",   path("way3d.csv")};
  EXPECT_EQ(0, piped(path("way.csv"), lift).status) << piped(path("way.csv"), lift).err;
  gzip(path("out/voxels.bt"), path("out/voxels.bt.gz"));
  fs::remove(path("out/voxels.bt"));
  const auto packed = piped(path("way.csv"), lift);
  EXPECT_EQ(0, packed.status) << packed.err;
  EXPECT_EQ(0, warningsIn(packed.err)) << packed.err;
}

TEST_F(ReportFiles, NothingOnStdinIsNamed)
{
  write(path("empty"), "");
  expectError(piped(path("empty"), convert("-")), {"stdin: is empty"});
}

TEST_F(ReportFiles, ForeignKindsAreNamedWithWhatTurnsThemIntoSomethingThatIsRead)
{
  write(path("drive.bag"), "#ROSBAG V2.0\n" + std::string(5000, '\x1b'));
  write(path("a.laz"), "LASF" + std::string(100, '\0') + "\x83" + std::string(500, '\0'));
  const std::vector<std::pair<std::string, std::string>> files = {{"drive.bag", "rosbag2rawlog"},
                                                                  {"a.laz", "pdal translate"}};
  for (const auto& [name, words] : files)
  {
    const std::string file = path(name);
    expectError(mapconv(convert(file)), {name, words});
    expectError(mapconv({"info", file}), {name, words});
    expectError(mapconv({"insert", file, "-o", path("out"), "--structure", "2", "3"}),
                {name, words});
    expectError(mapconv({"project", file, "-o", path("out"), "--z-min", "0", "--z-max", "1"}),
                {name, words});
    expectError(mapconv({"plan", file, "--robot", "ground", "--from", "0,0", "--to", "1,1",
                         "--robot-radius", "0.2", "-o", path("p.csv")}),
                {name, words});
  }
  expectError(mapconv({"plan", path("hand.bt"), "--robot", "ground", "--from", "0,0", "--to", "1,1",
                       "--robot-radius", "0.2", "-o", path("p.csv")}),
              {"hand.bt: is a file", "mapconv convert"});
}

TEST_F(ReportFiles, CloudsWithoutATrajectoryAreRefusedWithWhatDoesWithoutOne)
{
  write(path("cloud.bt"), "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n");
  write(path("0001.bin"), std::string(1600, '\x42'));
  write(path("a.ply"), "ply\n");
  write(path("a.las"), "LASF");
  write(path("a.xyz"), "1 2 3\n");
  const auto expectRefused = [&](const std::vector<std::string>& words, const std::string& name) {
    expectError(mapconv(words), {name, "--trajectory FILE", "info and ground do without"});
  };
  for (const std::string name : {"cloud.bt", "0001.bin", "a.ply", "a.las", "a.xyz"})
    expectRefused(convert(path(name)), name);
  const std::string cloud = path("a.xyz");
  expectRefused({"terrain", cloud, "-o", path("out")}, "a.xyz");
  expectRefused({"insert", cloud, "-o", path("out"), "--structure", "2", "3"}, "a.xyz");
  expectRefused({"project", cloud, "-o", path("out"), "--z-min", "0", "--z-max", "1"}, "a.xyz");
}

TEST_F(ReportFiles, PublicFilesOfForeignKindsAreNamed)
{
  const std::string real = MRPT_MAPCONV_SHARED_DIR "/real/";
  if (!fs::exists(real)) GTEST_SKIP() << real << " is not there";
  for (const std::string name : {"autzen-thin.las", "isprs_samp11.pcd"})
    expectError(mapconv(convert(real + name)), {name + ": is a cloud of points", "--trajectory"});
  expectError(mapconv(convert(real + "depot.pgm")), {"ros-map-yaml2mrpt"});
  expectError(mapconv(convert(real + "depot.yaml")), {"ros-map-yaml2mrpt"});
}

TEST_F(ReportFiles, NothingUnprintableReachesATerminal)
{
  const std::string evil = "\x1b[31m\x9b\x07";
  write(path("evil.rawlog"), "\x8b" + evil + "class\1");
  write(path("evil.csv"), evil + ",1\n");
  write(path("evil.bt"),
        "# Octomap OcTree binary file\nid " + evil + "\nsize 1\nres 1\ndata\n\1\1");
  write(path("evil.ini"), evil + "\n");
  const auto scan = lookDown(0);
  scan->sensorLabel = evil;
  writeObjects(path("label.rawlog"), {scan});
  for (const std::vector<std::string>& words :
       {convert(path("evil.rawlog")),
        convert(path("evil.bt")),
        convert(path("no" + evil + ".bt")),
        {"convert", path("hand.bt"), "-o", path("out"), "-c", path("evil.ini")},
        {"info", path("label.rawlog")},
        {"info", path("label.rawlog"), "--json"},
        {evil}})
  {
    const auto run = mapconv(words);
    std::istringstream lines(run.err + run.out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_EQ(mrpt_mapconv::params::printable(line), line);
  }
}

TEST_F(ReportFiles, RangeImagesThatAreMissingAreNamedWithAllThatFindsThem)
{
  if (!fs::exists(kReports)) GTEST_SKIP() << kReports << " is not there";
  const std::vector<std::string> words = {"extrange.rawlog", "8 of 8 scans", "scan 1",
                                          "'KINECT'",        "r0.bin",       "extrange_Images",
                                          "extrange_IMAGES", "Images in",    "copy"};
  auto inserting = convert(kReports + "extrange.rawlog");
  inserting[0] = "insert";
  inserting[4] = "--no-reflection-filter";
  inserting.erase(inserting.begin() + 5);
  for (const auto& command : {convert(kReports + "extrange.rawlog"), inserting})
  {
    const auto run = mapconv(command);
    expectError(run, words);
    EXPECT_EQ(std::string::npos, run.err.find('[')) << run.err;
  }
}

TEST_F(ReportFiles, ARangeImageThatIsCutOffIsNamedWithLogAndScan)
{
  if (!fs::exists(kReports)) GTEST_SKIP() << kReports << " is not there";
  fs::copy(kReports + "extrange.rawlog", path("extrange.rawlog"));
  fs::create_directory(path("extrange_Images"));
  for (int i = 0; i < 8; ++i)
    write(path("extrange_Images/r" + std::to_string(i) + ".bin"),
          std::string("\2\0\0\0\3\0\0\0\1", 9));
  expectError(mapconv(convert(path("extrange.rawlog"))),
              {"extrange.rawlog: scan 1 of 8", "'KINECT'", "extrange_Images/r0.bin: is truncated"});
}

/** The reason for each size of a disk that is too small, so that each kind of file is the first one
 * that does not fit. */
TEST_F(ReportFiles, AFullDiskIsCalledAFullDiskWhicheverFileMeetsIt)
{
  write(path("world.ini"),
        readBytes(MRPT_MAPCONV_SOURCE_DIR "/tests/integration/cli/golden/world.ini"));
  ASSERT_EQ(0, mapconv(convert(path("hand.bt"))).status);
  std::uintmax_t whole = 0;
  for (const auto& entry : fs::directory_iterator(path("out"))) whole += entry.file_size();
  for (int kilobytes = 8; kilobytes < static_cast<int>(whole >> 10U); kilobytes += 12)
  {
    const TinyDisk disk(kilobytes);
    if (!disk.mounted()) GTEST_SKIP() << "no right to mount a small disk";
    const auto run =
        mapconv({"convert", path("hand.bt"), "-o", disk.path("out"), "--max-step", "0.1"});
    expectError(run, {"No space left on device"});
    EXPECT_FALSE(fs::exists(disk.path("out"))) << kilobytes;
  }
  const TinyDisk disk(16);
  expectError(mapconv({"simulate", path("world.ini"), "-o", disk.path("out")}),
              {"No space left on device"});
  expectError(mapconv({"sample-map", "building", "-o", disk.path("b.bt")}),
              {"No space left on device"});
}

TEST_F(ReportFiles, AFullDeviceIsCalledSoForResultsAndSinglefiles)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  for (const auto& words : {std::vector<std::string>{"info", path("hand.bt"), "--json"},
                            std::vector<std::string>{"info", path("hand.bt")}})
  {
    const auto run = mapconv(words, "/dev/full");
    EXPECT_TRUE(contains(run.err, "stdout': No space left on device")) << run.err;
  }
}

}  // namespace
