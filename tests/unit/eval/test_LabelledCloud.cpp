#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/eval/LabelledCloud.h>

#include <cmath>
#include <fstream>
#include <string>

#include "support/TempDir.h"

namespace
{
using namespace mrpt_mapconv;
using mrpt_mapconv::testing::TempDir;

/** Ground at z = 1, a box on it, and a lidar that hangs above both, looking down. */
const std::string kWorld = R"(
[world]
bounds = -10 -10 0  10 10 20
[heightField.ground]
min = -10 -10
max = 10 10
cell = 1
solid = below
base = 1
[box.a]
min = 0 -10 1
max = 10 10 3
[sensor.above]
kind = lidar
pose = 0 0 0  0 90 0
rate = 1
maxRange = 12
elevations = 0
azimuthSteps = 360
[sensor.flat]
kind = scanner2D
pose = 0 0 0  0 90 0
rate = 1
maxRange = 12
fieldOfView = 20
rays = 5
[trajectory]
poses = [0  -5 0 11  0 0 0] [3  4 0 11  0 0 0]
[noise]
posePosition = 3
)";

eval::LabelledCloud simulated(const std::string& text, int every = 1)
{
  const TempDir dir;
  std::ofstream(dir.path("w.ini")) << text;
  return eval::simulateCloud(sim::Scenario::load(dir.path("w.ini")), 1, every);
}
}  // namespace

TEST(LabelledCloud, PointsOfASimulationAreGroundWhereTheyComeFromTheGround)
{
  const auto labelled = simulated(kWorld);
  ASSERT_EQ(labelled.truth.size(), labelled.cloud.size());
  ASSERT_GT(labelled.cloud.size(), 100u);
  std::size_t ground = 0;
  for (std::size_t i = 0; i < labelled.cloud.size(); ++i)
  {
    const bool isGround = std::abs(labelled.cloud.z[i] - 1) < 1e-4;
    EXPECT_TRUE(isGround || std::abs(labelled.cloud.z[i] - 3) < 1e-4) << labelled.cloud.z[i];
    EXPECT_EQ(labelled.truth[i] == cloud::kGround, isGround) << i;
    ground += isGround ? 1 : 0;
  }
  EXPECT_GT(ground, 20u);
  EXPECT_LT(ground, labelled.cloud.size());
  EXPECT_EQ(labelled.groundPoints(), ground);
}

TEST(LabelledCloud, OfTheScansOfASimulationEveryNthIsTaken)
{
  // the first two of four hang over the ground, at x = -5 and -2
  const auto all = simulated(kWorld), second = simulated(kWorld, 3);
  EXPECT_LT(second.cloud.size(), all.cloud.size());
  for (std::size_t i = 0; i < second.cloud.size(); ++i)
    EXPECT_TRUE(std::abs(second.cloud.x[i] + 5) < 1e-4 || std::abs(second.cloud.x[i] - 4) < 1e-4);
}

TEST(LabelledCloud, TheGroundOfAFileIsThatOfAnotherFile)
{
  const TempDir dir;
  // far from the origin: a float would take the second point for the third
  std::ofstream(dir.path("all.xyz")) << "512345.25 5412345.5 3\n512346.25 5412345.52 3\n"
                                        "512346.25 5412345.51 3\n512345.25 5412345.5 4\n";
  std::ofstream(dir.path("ground.xyz")) << "512346.25 5412345.51 3\n512345.25 5412345.5 3\n";
  const auto labelled = eval::readLabelledCloud(dir.path("all.xyz"), dir.path("ground.xyz"));
  const std::vector<std::uint8_t> truth = {cloud::kGround, cloud::kUnclassified, cloud::kGround,
                                           cloud::kUnclassified};
  EXPECT_EQ(labelled.truth, truth);
}

TEST(LabelledCloud, AMissingFileIsNamed)
{
  const TempDir dir;
  std::ofstream(dir.path("all.xyz")) << "1 2 3\n";
  try
  {
    eval::readLabelledCloud(dir.path("all.xyz"), dir.path("ground.xyz"));
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("ground.xyz"), std::string::npos) << error.what();
  }
}

TEST(LabelledCloud, TrueGroundIsThatOfTheCellsCentresAndOfNoOtherBody)
{
  const TempDir dir;
  std::string text = kWorld;
  text.replace(text.find("base = 1"), 8, "gradient = 0.1 0");
  std::ofstream(dir.path("w.ini")) << text;
  const auto scenario = sim::Scenario::load(dir.path("w.ini"));
  grid::GridFrame frame;
  frame.resolution = 0.5;
  frame.x0 = -22;  // a metre beyond the ground
  frame.y0 = 0;
  frame.width = 44;
  frame.height = 2;
  const auto ground = eval::trueGround(scenario.world, frame);
  EXPECT_TRUE(std::isnan(ground.at(1, 0)));
  EXPECT_NEAR(ground.at(2, 0), -0.975, 1e-6);
  EXPECT_NEAR(ground.at(30, 1), 0.425, 1e-6);  // under the box
}
