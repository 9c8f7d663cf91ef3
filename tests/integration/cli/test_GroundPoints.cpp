#include <gtest/gtest.h>

#include <cmath>

#include "GroundRuns.h"
#include "support/Gzip.h"
#include "unit/cloud/LasBytes.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

// `--points FILE` of `mapconv ground`: the cloud in its order, with classes.

namespace
{
constexpr std::size_t kHeader = 375;  // of LAS 1.4

class GroundPoints : public GroundRuns
{
 protected:
  /** Expects the points of a file to be those of the hillside, with the classes that they should
   * get. */
  void expectHillside(const std::string& file) const
  {
    const auto right = Hillside::cloud(), read = cloud::readCloudFile(path(file));
    ASSERT_EQ(right.size(), read.size()) << file;
    const double rounding = file == "b.las" ? 0.000501 : 1e-9;  // a .las has millimetres
    EXPECT_EQ(right.classification, read.classification) << file;
    for (std::size_t i = 0; i < right.size(); ++i)
    {
      ASSERT_NEAR(right.x[i], read.x[i] + read.origin.x, rounding) << file << i;
      ASSERT_NEAR(right.y[i], read.y[i] + read.origin.y, rounding) << file << i;
      ASSERT_NEAR(right.z[i], read.z[i] + read.origin.z, rounding) << file << i;
    }
  }
};

/** The hillside as a `.las` whose other bytes are all set, with records before and behind the
 * points; the last one is withheld, and 50 m too low. */
LasBytes lasOf(int format)
{
  LasBytes las;
  las.format = format;
  las.minor = 4;
  las.pointSize = static_cast<std::uint16_t>(LasBytes::sizeOf(format) + 2);
  las.scale = {1. / 1024, 1. / 1024, 1. / 1024};
  las.record("someone", 7, "before");
  las.lateRecord("someone", 8, "behind");
  const auto add = [&las](double x, double y, double z)
  {
    las.add(static_cast<int>(1024 * x), static_cast<int>(1024 * y), static_cast<int>(1024 * z));
    for (std::size_t at = 12; at < las.size(); ++at) las.set(at, static_cast<std::uint8_t>(3 * at));
    las.set(15, static_cast<std::uint8_t>(las.format < 6 ? 0x6A : 0xF8));
  };
  const auto cloud = Hillside::cloud();
  for (std::size_t i = 0; i < cloud.size(); ++i) add(cloud.x[i], cloud.y[i], cloud.z[i]);
  add(3, 3, -50);
  las.set(15, static_cast<std::uint8_t>(format < 6 ? 0xE7 : 0xFC));
  return las;
}
}  // namespace

TEST_F(GroundPoints, ofALasOnlyClassesChangeAndNotThoseOfWithheldPoints)
{
  const auto classes = Hillside::cloud().classification;
  for (const int format : {0, 1, 3, 5, 6, 7, 10})
  {
    const LasBytes las = lasOf(format);
    write("a.las", las.bytes());
    const auto run = ground("a.las", {"--points", path("b.LAS"), "--json"});
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_EQ("", run.err) << format;
    const auto json = parseJson(run.out);
    EXPECT_EQ(json["points"].number, Hillside::kPoints + 1);
    EXPECT_EQ(json["groundPoints"].number, Hillside::kGround);
    EXPECT_EQ(json["withheldPoints"].number, 1);
    EXPECT_EQ(json["pointsFile"].text, path("b.LAS"));
    std::string expected = las.bytes();
    for (std::size_t i = 0; i < classes.size(); ++i)
    {
      const std::size_t point = kHeader + las.records.size() + i * las.size();
      if (format < 6)
        putAt(expected, point + 15, static_cast<std::uint8_t>(0x60 | classes[i]));
      else
        putAt(expected, point + 16, classes[i]);
    }
    EXPECT_TRUE(expected == readBytes(path("b.LAS"))) << format;
  }
  const auto text = ground("a.las").out;
  EXPECT_TRUE(contains(text, "left out     1 point that the file marks as withheld or noise\n"))
      << text;
}

TEST_F(GroundPoints, aGzippedLasIsCopiedUnpacked)
{
  write("a.las", lasOf(1).bytes());
  writeGzipped(path("a.las.gz"), lasOf(1).bytes());
  mapped("a.las", {"--points", path("plain.las")});
  mapped("a.las.gz", {"--points", path("gzipped.las")});
  EXPECT_TRUE(readBytes(path("plain.las")) == readBytes(path("gzipped.las")));
}

TEST_F(GroundPoints, aLasThatIsPipedInIsWrittenWithAWarningOfWhatThatLeavesOut)
{
  write("a.las", lasOf(1).bytes());
  for (const std::string input : {"-", "/dev/stdin"})
  {
    const auto run =
        runProgram({"/bin/sh", "-c",
                    "cat '" + path("a.las") + "' | " MAPCONV_PROGRAM " ground " + input + " -o '" +
                        path("out") + "' --points '" + path("b.las") + "'"});
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_EQ(1, warningsIn(run.err)) << run.err;
    EXPECT_TRUE(contains(run.err, path("b.las") + " is written without ")) << run.err;
    auto right = Hillside::cloud().classification;
    right.push_back(7);  // withheld, so it keeps its own
    const auto cloud = cloud::readCloudFile(path("b.las"));
    EXPECT_EQ(right, cloud.classification);
    EXPECT_EQ(1, cloud.withheld.back());
  }
}

TEST_F(GroundPoints, everyFormatWithClassesIsWrittenInTheCloudsOrder)
{
  writeCloud("a.ply", Hillside::bareCloud());
  for (const std::string file : {"b.las", "b.ply", "b.pcd", "b.xyz", "b.txt", "b.csv"})
  {
    const auto run = ground("a.ply", {"--points", path(file)});
    ASSERT_EQ(0, run.status) << run.err;
    EXPECT_EQ("", run.err);
    EXPECT_TRUE(contains(run.out, "points       -> " + path(file) + "\n")) << run.out;
    expectHillside(file);
  }
  EXPECT_EQ(0U, readBytes(path("b.csv")).find("x,y,z,classification\n0.125,0.125,0.015625,2\n"));
}

TEST_F(GroundPoints, lackThePointsThatWereLeftOutAndAWarningSaysSo)
{
  std::string pcd =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\n"
      "HEIGHT 2\nPOINTS 4\nDATA ascii\n0 0 1\nnan nan nan\n0 1 1\n1 1 1\n";
  write("a.pcd", pcd);
  const auto run = ground("a.pcd", {"--cell-size", "1", "--points", path("b.pcd")});
  ASSERT_EQ(0, run.status) << run.err;
  EXPECT_TRUE(contains(run.err, "warning: 1 point of " + path("a.pcd") + " left out")) << run.err;
  EXPECT_TRUE(contains(run.err, "warning: " + path("b.pcd") +
                                    " lacks the 1 point that was left out, so its points have "
                                    "other numbers than those of the input\n"))
      << run.err;
  EXPECT_EQ(3U, cloud::readCloudFile(path("b.pcd")).size());
}

TEST_F(GroundPoints, classesThatTheCloudHasAreReplaced)
{
  auto cloud = Hillside::cloud();
  cloud.classification.assign(cloud.size(), 9);
  writeCloud("a.pcd", cloud);
  mapped("a.pcd", {"--points", path("b.csv")});
  expectHillside("b.csv");
}

TEST_F(GroundPoints, mayLieInTheFolderOfTheMap)
{
  writeCloud("a.csv", Hillside::bareCloud());
  mapped("a.csv", {"--points", path("out/points.csv")});
  expectHillside("out/points.csv");
  EXPECT_TRUE(std::filesystem::exists(path("out/ground.tif")));
}

TEST_F(GroundPoints, aNameThatCannotBeIsRefusedBeforeTheCloudIsRead)
{
  writeCloud("a.csv", Hillside::bareCloud());
  write("broken.csv", "x,y,z\n1,2\n");
  write("file", "");
  std::filesystem::create_symlink(path("broken.csv"), path("link.csv"));
  for (const auto& [name, words] : std::vector<std::pair<std::string, std::string>>{
           {"b.laz", ".las, .ply, .pcd, .xyz, .txt or .csv\n"},
           {"b.xyz.gz", ".xyz, .txt or .csv\n"},
           {"b", ".las, .ply, .pcd"},
           {"b.bin", "KITTI's .bin has no classes"},
           {"broken.csv", "it is the input"},
           {"link.csv", "it is the input"},
           {"file/b.csv", "cannot create the folder"}})
    expectError("broken.csv", {"--points", path(name)}, {words});
}

TEST_F(GroundPoints, ifTheFolderCannotBeWrittenThereAreNoPointsEither)
{
  writeCloud("a.csv", Hillside::bareCloud());
  write("file", "");
  const auto refused =
      mapconv({"ground", path("a.csv"), "-o", path("file/out"), "--points", path("b.csv")});
  EXPECT_EQ(1, refused.status);
  EXPECT_TRUE(isOneError(refused.err)) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(path("b.csv")));

  std::filesystem::create_directories(path("out/ground.tif"));
  expectError("a.csv", {"--points", path("b.csv")}, {"cannot replace '" + path("out/ground.tif")});
  EXPECT_FALSE(std::filesystem::exists(path("b.csv")));
}

TEST_F(GroundPoints, whoInterruptsTheWritingFindsNothing)
{
  write("wide.csv", "x,y,z\n0,0,0\n900,0,1\n0,900,1\n900,900,1\n");  // 13 million cells
  std::filesystem::create_directories(path("points"));
  const auto run = runProgram(
      {"/bin/sh", "-c",
       "cd '" + path("") +
           "'; " MAPCONV_PROGRAM
           " ground wide.csv -o out --ground-filter smrf --points points/b.csv & "
           "until ls -d points/.mapconv-* out/.mapconv-*; do sleep 0.02; done >/dev/null 2>&1; "
           "kill -TERM $!; wait $!"});
  EXPECT_EQ(128 + 15, run.status) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("out")));
  EXPECT_TRUE(std::filesystem::is_empty(path("points")));
}

TEST_F(GroundPoints, ifThePointsCannotBeWrittenThereIsNoFolderEither)
{
  writeCloud("a.csv", Hillside::bareCloud());
  const TinyDisk disk(16);
  if (!disk.mounted()) GTEST_SKIP() << "no rights to mount a disk";
  const auto run = ground("a.csv", {"--points", disk.path("b.csv")});
  EXPECT_EQ(1, run.status);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  EXPECT_TRUE(contains(run.err, "'" + disk.path("b.csv") + "'")) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}
