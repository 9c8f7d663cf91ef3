#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "OctreeFiles.h"
#include "Program.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
/** A corridor along x, 9 × 5 columns of 0.5 m: floor at 0.5 m, ceiling at 3 m, and over x key 4 a
 * lintel at 2 … 2.5 m with free space above it. */
class Lift : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    s_dir = std::make_unique<TempDir>();
    const std::string open = "offfffo", lintel = "offfoffffo";
    std::vector<std::vector<std::string>> columns(5, std::vector<std::string>(9, open));
    for (auto& row : columns) row[4] = lintel;
    writeTree(treeOf(0.5, columns, 0, 0), s_dir->path("corridor.bt"));
    ASSERT_EQ(0,
              mapconv({"convert", s_dir->path("corridor.bt"), "-o", map(), "--min-clearance", "1"})
                  .status);
  }
  static void TearDownTestSuite() { s_dir.reset(); }

  static std::string map() { return s_dir->path("map"); }
  static std::string file(const std::string& name) { return s_dir->path(name); }
  static Outcome lift(const std::string& csv, std::vector<std::string> more = {},
                      const std::string& robot = "aerial")
  {
    std::ofstream(file("path.csv")) << csv;
    std::vector<std::string> arguments = {"lift", map(), file("path.csv"),  "--robot",
                                          robot,  "-o",  file("lifted.csv")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mapconv(arguments);
  }
  static std::string lifted() { return readBytes(file("lifted.csv")); }

  static std::unique_ptr<TempDir> s_dir;
};
std::unique_ptr<TempDir> Lift::s_dir;
}  // namespace

TEST_F(Lift, KeepsInputPointsAndDensifies)
{
  ASSERT_EQ(0, lift("x,y\n0.75,1.25\n1.5,1.25\n", {"--height-offset", "0.5"}).status);
  EXPECT_EQ("x,y,z\n0.75,1.25,1\n1.125,1.25,1\n1.5,1.25,1\n", lifted());
}

TEST_F(Lift, GoesUnderTheLintel)
{
  // 2 m is wanted; the sphere of 0.4 m must stay below the lintel at 2 m
  ASSERT_EQ(0, lift("2.25,1.25\n", {"--height-offset", "1.5", "--safety-radius", "0.4"}).status);
  EXPECT_EQ("x,y,z\n2.25,1.25,1.6\n", lifted());
}

TEST_F(Lift, WithoutTheVoxelMapTheLintelIsNotSeen)
{
  std::filesystem::rename(map() + "/voxels.bt", file("voxels.bt"));
  const Outcome outcome =
      lift("2.25,1.25\n", {"--height-offset", "1.5", "--safety-radius", "0.4", "--json"});
  std::filesystem::rename(file("voxels.bt"), map() + "/voxels.bt");
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ(1, warningsIn(outcome.err));
  EXPECT_TRUE(contains(outcome.err, "slabs")) << outcome.err;
  EXPECT_FALSE(parseJson(outcome.out)["slabsChecked"].truth);
  EXPECT_EQ("x,y,z\n2.25,1.25,2\n", lifted());
}

TEST_F(Lift, ColumnsAreFoundByTheirNames)
{
  ASSERT_EQ(0,
            lift("# a comment\n\nt, y ,x\r\n0,1.25,0.75\r\n", {"--height-offset", "0.5"}).status);
  EXPECT_EQ("x,y,z\n0.75,1.25,1\n", lifted());
}

TEST_F(Lift, MalformedFilesNameTheLine)
{
  const auto error = [&](const std::string& csv)
  {
    std::filesystem::remove(file("lifted.csv"));
    const Outcome outcome = lift(csv);
    EXPECT_EQ(1, outcome.status);
    EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(file("lifted.csv")));
    return outcome.err;
  };
  EXPECT_TRUE(contains(error("x,y\n0.75,1.25\n0.8;1.25\n"), "line 3")) << error("x,y\n0;1\n");
  EXPECT_TRUE(contains(error("0.75,1.25\n0.75\n"), "line 2"));
  EXPECT_TRUE(contains(error("0.75,1.25\n\n0.75,1.25abc\n"), "line 3"));
  EXPECT_TRUE(contains(error("0.75,nan\n"), "line 1"));
  EXPECT_TRUE(contains(error("a,b\n0.75,1.25\n"), "line 1"));
  EXPECT_TRUE(contains(error("x,y\n"), "no point"));
  const Outcome missing =
      mapconv({"lift", map(), file("none.csv"), "--robot", "ground", "-o", file("lifted.csv")});
  EXPECT_EQ(1, missing.status);
  EXPECT_TRUE(contains(missing.err, "none.csv")) << missing.err;
}

TEST_F(Lift, SaysWhichPointCannotBeReachedAndWhy)
{
  std::filesystem::remove(file("lifted.csv"));
  const Outcome edge = lift("2.25,1.25\n4.3,1.25\n");
  EXPECT_EQ(1, edge.status);
  EXPECT_TRUE(isOneError(edge.err)) << edge.err;
  EXPECT_TRUE(contains(edge.err, "point ")) << edge.err;
  EXPECT_TRUE(contains(edge.err, "unknown cell at (4.75, 1.25)")) << edge.err;
  EXPECT_FALSE(std::filesystem::exists(file("lifted.csv")));
  EXPECT_EQ(0, lift("2.25,1.25\n4.3,1.25\n", {"--unknown-is-passable"}).status);
  EXPECT_EQ(0, lift("2.25,1.25\n4.3,1.25\n", {}, "ground").status);
  const Outcome off = lift("2.25,1.25\n9,1.25\n", {}, "ground");
  EXPECT_EQ(1, off.status);
  EXPECT_TRUE(contains(off.err, "outside")) << off.err;
}

TEST_F(Lift, OptionsAreChecked)
{
  for (const char* radius : {"0", "-1", "0.51", "inf"})
  {
    const Outcome outcome = lift("2.25,1.25\n", {"--safety-radius", radius});
    EXPECT_EQ(2, outcome.status) << radius;
    EXPECT_TRUE(contains(outcome.err, "--safety-radius")) << outcome.err;
  }
  EXPECT_EQ(2, lift("2.25,1.25\n", {"--lookahead", "-1"}).status);
  EXPECT_EQ(2, lift("2.25,1.25\n", {"--lookahead", "x"}).status);
  EXPECT_EQ(2, lift("2.25,1.25\n", {"--height-offset", "nan"}).status);
  EXPECT_EQ(2,
            mapconv({"lift", map(), file("path.csv"), "--robot", "ground", "-o", file("path.txt")})
                .status);
  const Outcome same =
      mapconv({"lift", map(), file("path.csv"), "--robot", "ground", "-o", file("path.csv")});
  EXPECT_EQ(2, same.status);
  EXPECT_TRUE(contains(same.err, "path.csv is the path")) << same.err;
}

TEST_F(Lift, WarnsOfOptionsWithoutEffect)
{
  const Outcome outcome =
      lift("2.25,1.25\n", {"--safety-radius", "0.4", "--unknown-is-passable"}, "ground");
  EXPECT_EQ(0, outcome.status);
  EXPECT_EQ(2, warningsIn(outcome.err)) << outcome.err;
}

TEST_F(Lift, CommonFormsOfCsvAreRead)
{
  const std::string expected = "x,y,z\n0.75,1.25,1\n";
  for (const char* csv :
       {"\xEF\xBB\xBFx,y\n0.75,1.25\n", "X,Y,Z\n0.75,1.25,7\n", "\"x\",\"y\"\n\"0.75\",1.25\n",
        "+0.75,1.25\n", "0.75,1.25,9\n", "0.75 , 1.25"})
  {
    const Outcome outcome = lift(csv, {"--height-offset", "0.5"});
    EXPECT_EQ(0, outcome.status) << csv << outcome.err;
    EXPECT_EQ(expected, lifted()) << csv;
  }
}

TEST_F(Lift, UncommonFormsAreRefusedWithTheReason)
{
  const auto error = [&](const std::string& csv) { return lift(csv).err; };
  EXPECT_TRUE(contains(error("0.75;1.25\n"), "commas between")) << error("0.75;1.25\n");
  EXPECT_TRUE(contains(error("x\ty\n0.75\t1.25\n"), "commas between"));
  EXPECT_TRUE(contains(error("1,5,2,5\n"), "line 1"));  // decimal commas
  EXPECT_TRUE(contains(error("1,1,foo,bar\n"), "line 1"));
  EXPECT_TRUE(contains(error("1,1\n1,1,1\n"), "2 fields"));
  EXPECT_TRUE(contains(error("x,y\n1,1,1\n"), "2 fields"));
  EXPECT_TRUE(contains(error("1e308,1\n"), "line 1"));
  EXPECT_TRUE(contains(error("0.75,1.25\n0.75,9e7\n"), "path.csv"));  // far too long a way
}

TEST_F(Lift, RefusesAVoxelMapOfAnotherPlace)
{
  std::filesystem::copy(map() + "/voxels.bt", file("keep.bt"));
  std::vector<std::vector<std::string>> columns(5, std::vector<std::string>(9, "ooffffffffo"));
  writeTree(treeOf(0.5, columns, 0, 0), map() + "/voxels.bt");
  const Outcome outcome = lift("2.25,1.25\n");
  std::filesystem::rename(file("keep.bt"), map() + "/voxels.bt");
  EXPECT_EQ(1, outcome.status);
  EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "voxel map")) << outcome.err;
}
