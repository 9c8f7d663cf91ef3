#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

// config/worlds/{stairs,platforms,warehouse}.ini are what their comments and the comparison of
// terrain maps say.
namespace
{
using namespace mrpt_mapconv::sim;

constexpr const char* kWorlds[] = {"stairs", "platforms", "warehouse"};

const Scenario& scenario(const std::string& name)
{
  static std::map<std::string, Scenario> loaded;
  const auto found = loaded.find(name);
  if (found != loaded.end()) return found->second;
  const std::string file = MRPT_MAPCONV_SOURCE_DIR "/config/worlds/" + name + ".ini";
  return loaded.emplace(name, Scenario::load(file)).first->second;
}

/** Top of the lowest solid [m]. */
double topAt(const std::string& world, double x, double y)
{
  std::vector<Solid> solids;
  scenario(world).world.solidsAt(x, y, solids);
  return solids.at(0).top;
}

/** Where a level begins on a way, and how high it is above the one before [m]. */
struct Riser
{
  double place, height;
};

/** The steps from one level to the next between two places. */
std::vector<Riser> risers(const std::string& world, double x0, double y0, double x1, double y1)
{
  std::vector<Riser> found;
  const double length = std::hypot(x1 - x0, y1 - y0);
  const int places = static_cast<int>(std::lround(length / 1e-3));
  for (int i = 1; i <= places; ++i)
  {
    const auto at = [&](int k)
    { return topAt(world, x0 + (x1 - x0) * k / places, y0 + (y1 - y0) * k / places); };
    if (std::abs(at(i) - at(i - 1)) > 0.01) found.push_back({i * 1e-3, at(i) - at(i - 1)});
  }
  return found;
}

void expectFlight(const std::vector<Riser>& flight, std::size_t count, double height, double depth)
{
  ASSERT_EQ(flight.size(), count);
  for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(flight[i].height, height, 1e-9) << i;
  for (std::size_t i = 1; i < count; ++i)
    EXPECT_NEAR(flight[i].place - flight[i - 1].place, depth, 2e-3) << i;
}

TEST(TerrainWorlds, HaveTheNoiseOfTheComparison)
{
  for (const char* name : kWorlds)
  {
    const Scenario& world = scenario(name);
    EXPECT_EQ(world.noise.poseHeight, 0.002);
    EXPECT_EQ(world.noise.poseTilt, 0.05);
    EXPECT_EQ(world.noise.posePosition, 0);
    EXPECT_EQ(world.noise.poseAngle, 0);
    EXPECT_TRUE(world.log.poses);
    ASSERT_EQ(world.sensors.size(), 2u);
    for (const char* sensor : {"camera", "lidar"})
      EXPECT_TRUE(std::any_of(world.sensors.begin(), world.sensors.end(),
                              [&](const auto& s) { return s->params().name == sensor; }));
    for (const auto& sensor : world.sensors)
    {
      EXPECT_TRUE(sensor->is3D());
      EXPECT_EQ(sensor->params().rangeNoise, 0.02);
    }
  }
}

TEST(TerrainWorlds, TheirRobotWalksHalfAMetreAboveTheGround)
{
  for (const char* name : kWorlds)
  {
    const Trajectory& way = scenario(name).trajectory;
    for (double t = 0; t < way.duration(); t += 0.05)
    {
      const auto pose = way.poseAt(t);
      ASSERT_NEAR(pose.z() - topAt(name, pose.x(), pose.y()), 0.5, 0.25) << name << " " << pose;
    }
  }
}

TEST(TerrainWorlds, FlightsOfStairsHaveTheirStepsAndTreads)
{
  expectFlight(risers("stairs", 1, 0.8, 4, 0.8), 5, 0.15, 0.3);
  expectFlight(risers("stairs", 3.4, 1.2, 3.4, 3.5), 4, 0.18, 0.26);
  expectFlight(risers("stairs", 0, 3.4, 4, 3.4), 7, 0.21, 0.35);
  expectFlight(risers("stairs", 1, -1.5, 3, -1.5), 3, 0.1, 0.4);
  expectFlight(risers("stairs", 5, -1.5, 3, -1.5), 5, 0.06, 0.24);
}

TEST(TerrainWorlds, PlatformsHaveTheirHeights)
{
  for (const auto& [x, height] :
       {std::pair(1.6, 0.05), {2.7, 0.1}, {3.8, 0.15}, {4.9, 0.2}, {6.5, 0.0}})
    EXPECT_NEAR(topAt("platforms", x, 1.1), height, 1e-9);
  for (const auto& [x, height] : {std::pair(6.5, 0.4), {5.4, 0.3}, {4.0, 0.12}})
    EXPECT_NEAR(topAt("platforms", x, 4.05), height, 1e-9);
  EXPECT_NEAR(topAt("platforms", 6.5, 2.403), 0.2, 1e-9) << "middle of the ramp";
  EXPECT_NEAR(topAt("platforms", 1.608, 3.404), 0.02, 2e-3) << "the plate's lower corner";
  EXPECT_NEAR(topAt("platforms", 3.006, 4.702), 0.25, 3e-3) << "the plate's upper corner";
}

TEST(TerrainWorlds, TheWarehousesDockHasStairsAndARamp)
{
  expectFlight(risers("warehouse", 5, 8.75, 8, 8.75), 4, 0.15, 0.35);
  EXPECT_TRUE(risers("warehouse", 15.3, 3, 15.3, 9).empty());
  EXPECT_NEAR(topAt("warehouse", 15.3, 9), 0.6, 1e-9);
  EXPECT_NEAR(topAt("warehouse", 15.3, 3), 0, 1e-9);
  expectFlight(risers("warehouse", 1.6, 3.05, 0.6, 3.05), 1, 0.12, 0);
}

// what comments say about cells: no face along the axes lies in the middle or on the border of one
TEST(TerrainWorlds, EdgesLieNeitherInTheMiddleNorOnTheBorderOfCells)
{
  for (const double resolution : {0.005, 0.01, 0.02, 0.05, 0.1})
    for (const char* name : kWorlds)
    {
      const World& world = scenario(name).world;
      for (std::size_t i = 0; i < world.size(); ++i)
      {
        const Footprint area = world.primitive(i).footprint();
        if (world.nameBegins(i, "floor") || world.nameBegins(i, "wall")) continue;
        for (const double edge : {area.xMin, area.xMax, area.yMin, area.yMax})
        {
          const double halves = edge / resolution * 2;
          EXPECT_GT(std::abs(halves - std::round(halves)), 0.01) << world.name(i) << " " << edge;
        }
      }
    }
}
}  // namespace
