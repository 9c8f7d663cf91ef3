#include <gtest/gtest.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt_mapconv/sim/RayCaster.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

// The worlds of config/worlds are what their comments say.
namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;

World load(const std::string& name)
{
  const mrpt::config::CConfigFile ini(MRPT_MAPCONV_SOURCE_DIR "/config/worlds/" + name + ".ini");
  return World::fromIni(ini, {"sensor.", "trajectory", "noise", "log", "truth"});
}

/** The truth of a world. */
struct Truth
{
  Truth(const World& world, double resolution)
      : layers(truthLayers(world, frameOf(world, resolution), {}))
  {
  }
  std::size_t indexAt(double x, double y) const
  {
    const auto& frame = layers.frame();
    return frame.indexOfKey(static_cast<int>(std::floor(x / frame.resolution)),
                            static_cast<int>(std::floor(y / frame.resolution)));
  }
  float ground(double x, double y) const { return layers.ground.cells()[indexAt(x, y)]; }
  float aerial(double x, double y) const { return layers.aerial.cells()[indexAt(x, y)]; }
  float floor(double x, double y) const { return layers.floor.cells()[indexAt(x, y)]; }
  float ceiling(double x, double y) const { return layers.ceiling.cells()[indexAt(x, y)]; }
  float slope(double x, double y) const { return layers.slope.cells()[indexAt(x, y)]; }

  /** Cells that a round robot of a radius [m] reaches from a place, from cell to cell. */
  std::vector<bool> reachedFrom(double x, double y, double radius) const
  {
    const auto& frame = layers.frame();
    const int reach = static_cast<int>(std::ceil(radius / frame.resolution));
    const auto fits = [&](int ix, int iy)
    {
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
        {
          if (std::hypot(dx, dy) * frame.resolution > radius) continue;
          const int jx = ix + dx, jy = iy + dy;
          if (jx < 0 || jy < 0 || jx >= frame.width || jy >= frame.height) return false;
          if (layers.ground.at(jx, jy) != 0) return false;
        }
      return true;
    };
    std::vector<bool> reached(frame.size());
    std::vector<std::size_t> open{indexAt(x, y)};
    const auto width = static_cast<std::size_t>(frame.width);
    while (!open.empty())
    {
      const std::size_t cell = open.back();
      open.pop_back();
      const int ix = static_cast<int>(cell % width), iy = static_cast<int>(cell / width);
      if (reached[cell] || !fits(ix, iy)) continue;
      reached[cell] = true;
      if (ix > 0) open.push_back(cell - 1);
      if (ix + 1 < frame.width) open.push_back(cell + 1);
      if (iy > 0) open.push_back(cell - width);
      if (iy + 1 < frame.height) open.push_back(cell + width);
    }
    return reached;
  }

  freespace::Layers layers;
};

/** Directions all around, not straight up or down. */
std::vector<mrpt::math::TPoint3Df> directionsAround()
{
  std::vector<mrpt::math::TPoint3Df> directions;
  for (int i = 0; i < 628; ++i)
    for (int j = -15; j <= 15; ++j)
    {
      const float angle = 0.01f * float(i), up = 0.1f * float(j);
      directions.emplace_back(std::cos(angle) * std::cos(up), std::sin(angle) * std::cos(up),
                              std::sin(up));
    }
  return directions;
}

TEST(Worlds, Building)
{
  const World world = load("building");
  const Truth truth(world, 0.05);
  // both rooms, and the door between them under its lintel
  for (const auto& [x, y] : {std::pair(-2.5, 0.5), {1.0, 1.0}, {4.5, 0.0}, {2.98, 0.8}})
  {
    EXPECT_EQ(truth.ground(x, y), 0) << x << " " << y;
    EXPECT_EQ(truth.floor(x, y), 0);
  }
  EXPECT_NEAR(truth.ceiling(1, 1), 2.6, 1e-6);
  EXPECT_NEAR(truth.ceiling(2.98, 0.8), 2.0, 1e-6);
  EXPECT_EQ(truth.aerial(2.98, 3), 1);  // the wall beside the door
  // table: only the flying robot finds room, above it
  EXPECT_EQ(truth.ground(-0.8, -0.6), 1);
  EXPECT_EQ(truth.aerial(-0.8, -0.6), 0);
  EXPECT_NEAR(truth.floor(-0.8, -0.6), 0.75, 1e-6);
  EXPECT_NEAR(truth.floor(-0.52, 4), 0.5, 1e-6);  // the low wall
  // ramp and platform
  EXPECT_NEAR(truth.slope(7.3, 1.5), 0.2, 1e-6);
  EXPECT_NEAR(truth.floor(7.3, 4), 0.6, 1e-6);
  EXPECT_EQ(truth.ground(7.3, 1.5), 0);
  EXPECT_EQ(truth.ground(7.3, 4), 0);
}

TEST(Worlds, ARobotGetsAroundInTheBuilding)
{
  const Truth truth(load("building"), 0.05);
  const auto reached = truth.reachedFrom(-2.5, 0.5, 0.4);
  for (const auto& [x, y] : {std::pair(-2.5, 3.8),
                             {1.0, 3.5},
                             {0.0, -2.2},
                             {4.5, 0.0},
                             {6.0, -2.0},
                             {4.5, 3.0},
                             {7.3, 1.5},
                             {7.1, 4.0}})
    EXPECT_TRUE(reached[truth.indexAt(x, y)]) << x << " " << y;
}

TEST(Worlds, TheBuildingIsClosed)
{
  const World world = load("building");
  const RayCaster caster(world);
  for (const auto& direction : directionsAround())
    EXPECT_LT(caster.cast({{-2.5f, 0.5f, 1}, direction}, 0, 30).range, 14) << direction.asString();
}

TEST(Worlds, Cave)
{
  const World world = load("cave");
  const Truth truth(world, 0.1);
  const auto reached = truth.reachedFrom(-15, -8, 0.4);
  // all around the loop, past the low wall and into the dead end
  for (const auto& [x, y] : {std::pair(-9.0, -5.5),
                             {-1.0, -6.8},
                             {9.0, -4.5},
                             {8.5, 0.5},
                             {1.0, 7.5},
                             {-4.45, 8.8},
                             {-7.7, 2.0},
                             {15.5, 10.5}})
    EXPECT_TRUE(reached[truth.indexAt(x, y)]) << x << " " << y;
  EXPECT_EQ(truth.aerial(0, 0), 1);  // rock
  EXPECT_EQ(truth.aerial(-15, 5), 1);
  EXPECT_EQ(truth.ground(-4.45, 6.25), 1);  // the low wall's side

  double low = 9, high = -9, highestGap = 0;
  std::size_t steep = 0, free = 0;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    if (!reached[i]) continue;
    low = std::min<double>(low, truth.layers.floor.cells()[i]);
    high = std::max<double>(high, truth.layers.floor.cells()[i]);
    highestGap = std::max<double>(highestGap,
                                  truth.layers.ceiling.cells()[i] - truth.layers.floor.cells()[i]);
    ++free;
    steep += truth.layers.slope.cells()[i] > 0.4f;
  }
  EXPECT_GT(high - low, 2);
  EXPECT_LT(high - low, 3.2);
  EXPECT_LT(highestGap, 5);
  EXPECT_LT(double(steep), 0.1 * double(free));
}

TEST(Worlds, TheCaveIsClosedExceptForTheWayIn)
{
  const World world = load("cave");
  const RayCaster caster(world);
  for (const auto& direction : directionsAround())
    EXPECT_LT(caster.cast({{8.5f, 0.5f, 0.5f}, direction}, 0, 60).range, 20);
}

TEST(Worlds, Outdoor)
{
  const World world = load("outdoor");
  const Truth truth(world, 0.5);
  const auto count = [&](const std::string& beginning)
  {
    int number = 0;
    for (std::size_t i = 0; i < world.size(); ++i)
      number += world.name(i).compare(0, beginning.size(), beginning) == 0;
    return number;
  };
  EXPECT_EQ(count("box.wall_"), 10);
  EXPECT_EQ(count("box.house_"), 6);
  EXPECT_EQ(count("sphere.crown_"), 60);
  EXPECT_EQ(count("cylinder.trunk_"), 60);

  std::vector<Solid> ground;
  double low = 99, high = -99;
  for (int x = -100; x <= 100; x += 2)
    for (int y = -100; y <= 100; y += 2)
    {
      ground.clear();
      for (std::size_t i = 0; i < world.size(); ++i)
        if (world.name(i) == "heightField.ground") world.primitive(i).appendSolids(x, y, ground);
      ASSERT_EQ(ground.size(), 1u);
      low = std::min(low, ground[0].top);
      high = std::max(high, ground[0].top);
    }
  EXPECT_NEAR(high - low, 8, 0.2);

  // the ways that are promised to be clear
  for (int i = -124; i <= 124; ++i)
    for (const double across : {-2.0, 0.0, 2.0})
      for (const double way : {-60.0, 0.0, 60.0})
      {
        const double along = 0.5 * i;
        EXPECT_EQ(truth.ground(along, way + across), 0) << along << " " << way + across;
        EXPECT_EQ(truth.ground(way + across, along), 0) << way + across << " " << along;
      }
}

TEST(Worlds, OneCanWalkUnderTreesRoofsAndTheBridge)
{
  const World world = load("outdoor");
  std::vector<Solid> solids;
  int roofs = 0;
  for (std::size_t i = 0; i < world.size(); ++i)
  {
    const std::string& name = world.name(i);
    const bool roof = name.find("_roof") != std::string::npos || name == "box.bridge_deck";
    const bool crown = name.find("crown_") != std::string::npos;
    if (!roof && !crown) continue;
    ++roofs;
    const Footprint area = world.primitive(i).footprint();
    const double aside = crown ? 0.3 : 0;  // beside the trunk
    world.solidsAt((area.xMin + area.xMax) / 2 + aside, (area.yMin + area.yMax) / 2, solids);
    ASSERT_GE(solids.size(), 2u) << name;
    EXPECT_GT(solids[1].bottom - solids[0].top, 1.8) << name;
  }
  EXPECT_EQ(roofs, 65);
}
}  // namespace
