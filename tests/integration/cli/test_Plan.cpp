#include <gtest/gtest.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "PathRows.h"
#include "Program.h"
#include "StrictJson.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv::testing;

namespace
{
double lengthOf(const std::vector<Row>& rows)
{
  double length = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    length += std::hypot(rows[i].x - rows[i - 1].x, rows[i].y - rows[i - 1].y);
  return length;
}

/** The generated building: two rooms, x -4 … 3 and 3 … 8, a door at y 0.4 … 1.4, 2 m high; a table
 * and a low wall in the west room; a ramp and a platform (0.6 m) in the east room. */
class Plan : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    s_dir = std::make_unique<TempDir>();
    ASSERT_EQ(0, mapconv({"sample-map", "building", "-o", s_dir->path("b.bt")}).status);
    ASSERT_EQ(0,
              mapconv({"convert", s_dir->path("b.bt"), "-o", map(), "--max-step", "0.1"}).status);
  }
  static void TearDownTestSuite() { s_dir.reset(); }

  static std::string map() { return s_dir->path("map"); }
  static std::string file(const std::string& name) { return s_dir->path(name); }
  static Outcome plan(const std::string& robot, const std::string& from, const std::string& to,
                      const std::string& out, std::vector<std::string> more = {},
                      const std::string& radius = "0.25")
  {
    std::vector<std::string> arguments = {"plan",           map(),  "--robot", robot,
                                          "--from",         from,   "--to",    to,
                                          "--robot-radius", radius, "-o",      file(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return mapconv(arguments);
  }

  static std::unique_ptr<TempDir> s_dir;
};
std::unique_ptr<TempDir> Plan::s_dir;
}  // namespace

TEST_F(Plan, GroundRobotGoesThroughTheDoor)
{
  const Outcome outcome = plan("ground", "-3,2", "4,-2", "ground.csv", {"--json"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_EQ("", outcome.err);
  const auto rows = rowsOf(file("ground.csv"));
  ASSERT_GT(rows.size(), 100u);
  EXPECT_DOUBLE_EQ(-3, rows.front().x);
  EXPECT_DOUBLE_EQ(2, rows.front().y);
  EXPECT_DOUBLE_EQ(4, rows.back().x);
  EXPECT_DOUBLE_EQ(-2, rows.back().y);
  bool throughDoor = false;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_NEAR(0, rows[i].z, 1e-6);  // on the floor
    if (std::abs(rows[i].x - 3) < 0.05)
    {
      throughDoor = true;
      EXPECT_GE(rows[i].y, 0.4 + 0.25);
      EXPECT_LE(rows[i].y, 1.4 - 0.25);
    }
    if (i > 0)
    {
      EXPECT_LE(std::hypot(rows[i].x - rows[i - 1].x, rows[i].y - rows[i - 1].y), 0.0501);
    }
  }
  EXPECT_TRUE(throughDoor);
  // no shorter than straight through the door's middle part, and not much longer
  EXPECT_GT(lengthOf(rows), std::hypot(7, 4) - 0.01);
  EXPECT_LT(lengthOf(rows), 10.5);
  const auto json = parseJson(outcome.out);
  EXPECT_EQ(static_cast<double>(rows.size()), json["points"].number);
  EXPECT_NEAR(lengthOf(rows), json["length"].number, 1e-6);
  EXPECT_FALSE(json["slabsChecked"].truth);  // a ground robot has no sphere
}

TEST_F(Plan, AerialRobotFliesOverTheLowWall)
{
  // the low wall (0.5 m) stands at x = 1.2 … 1.35 from y = 2 on: the straight way leads over it
  const Outcome outcome =
      plan("aerial", "0.5,3", "2.2,3", "fly.csv", {"--height-offset", "0.5", "--json"});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  EXPECT_TRUE(parseJson(outcome.out)["slabsChecked"].truth);
  double over = 0;
  for (const Row& row : rowsOf(file("fly.csv")))
    if (row.x > 1.2 && row.x < 1.35) over = std::max(over, row.z);
  EXPECT_NEAR(1.0, over, 0.06);  // its top and the offset
  const auto ground = plan("ground", "0.5,3", "2.2,3", "around.csv");
  ASSERT_EQ(0, ground.status) << ground.err;
  EXPECT_GT(lengthOf(rowsOf(file("around.csv"))), 1.5 * lengthOf(rowsOf(file("fly.csv"))));
}

TEST_F(Plan, WritesPictureAndSceneBesideThePath)
{
  ASSERT_EQ(0, plan("aerial", "-3,2", "-1,2", "all.csv").status);
  EXPECT_EQ("\x89PNG", readBytes(file("all.png")).substr(0, 4));
  mrpt::opengl::COpenGLScene scene;
  ASSERT_TRUE(scene.loadFromFile(file("all.3Dscene")));
  const auto voxels = scene.getByClass<mrpt::opengl::COctoMapVoxels>();
  ASSERT_TRUE(voxels);
  EXPECT_GT(voxels->getVoxelCount(0), 1000u);
  const auto lines = scene.getByClass<mrpt::opengl::CSetOfLines>();
  ASSERT_TRUE(lines);
  EXPECT_GE(lines->size(), rowsOf(file("all.csv")).size() - 1);
}

TEST_F(Plan, SaysWhyThereIsNoPath)
{
  const auto why =
      [&](const std::string& from, const std::string& to, const std::string& radius = "0.25")
  {
    const Outcome outcome = plan("ground", from, to, "none.csv", {}, radius);
    EXPECT_EQ(1, outcome.status);
    EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(file("none.csv")));
    EXPECT_FALSE(std::filesystem::exists(file("none.png")));
    return outcome.err;
  };
  EXPECT_TRUE(contains(why("-30,2", "4,-2"), "outside")) << why("-30,2", "4,-2");
  EXPECT_TRUE(contains(why("-3,2", "3,3"), "goal")) << why("-3,2", "3,3");  // in a wall
  EXPECT_TRUE(contains(why("3,3", "-3,2"), "start")) << why("3,3", "-3,2");
  // the door is 1 m wide
  EXPECT_TRUE(contains(why("-3,2", "4,-2", "0.7"), "connected")) << why("-3,2", "4,-2", "0.7");
}

TEST_F(Plan, WrongUsage)
{
  EXPECT_EQ(2, plan("ground", "-3,2", "4,-2", "path.txt").status);
  EXPECT_EQ(2, plan("swimming", "-3,2", "4,-2", "path.csv").status);
  EXPECT_EQ(2, plan("ground", "-3", "4,-2", "path.csv").status);
  EXPECT_EQ(2, plan("ground", "-3,nan", "4,-2", "path.csv").status);
  EXPECT_EQ(2, plan("ground", "-3,2", "4,-2", ".csv").status);
  const Outcome negative = plan("ground", "-3,2", "4,-2", "path.csv", {}, "-1");
  EXPECT_EQ(2, negative.status);
  EXPECT_TRUE(contains(negative.err, "'-1' is not valid")) << negative.err;
  EXPECT_EQ(2, plan("ground", "-3,2", "4,-2", "path.csv", {}, "nan").status);
}

TEST_F(Plan, TheSphereMustFitIntoTheMapsClearance)
{
  const Outcome outcome = plan("aerial", "-3,2", "4,-2", "path.csv", {}, "0.6");
  EXPECT_EQ(2, outcome.status);
  EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "--robot-radius 0.6")) << outcome.err;
  EXPECT_EQ(2, plan("aerial", "-3,2", "4,-2", "path.csv", {}, "0").status);
}

TEST_F(Plan, NeedsAConvertedMap)
{
  const Outcome outcome =
      mapconv({"plan", s_dir->path("nothing"), "--robot", "ground", "--from", "0,0", "--to", "1,1",
               "--robot-radius", "0.2", "-o", s_dir->path("x.csv")});
  EXPECT_EQ(1, outcome.status);
  EXPECT_TRUE(contains(outcome.err, "nothing: there is no such folder")) << outcome.err;
}

TEST_F(Plan, LiftTakesItsPath)
{
  ASSERT_EQ(0, plan("ground", "-3,2", "4,-2", "p.csv").status);
  const Outcome outcome = mapconv({"lift", map(), file("p.csv"), "--robot", "ground",
                                   "--height-offset", "0.3", "-o", file("lifted.csv")});
  ASSERT_EQ(0, outcome.status) << outcome.err;
  const auto before = rowsOf(file("p.csv")), after = rowsOf(file("lifted.csv"));
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(before[i].z + 0.3, after[i].z, 1e-9);
}
