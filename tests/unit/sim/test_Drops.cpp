#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/UpperEdges.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <cmath>
#include <string>
#include <vector>

// config/worlds/drops.ini is what its comments say, and its robot stays on the upper level.
namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::sim;

const std::string kDrops = MRPT_MAPCONV_SOURCE_DIR "/config/worlds/drops.ini";
constexpr double kYard = 0, kDeck = 1.25;  // [m]
constexpr double kDrop = 0.3;              // higher ones have edges: a step of 0.2 and a voxel [m]

const Scenario& hall()
{
  static const Scenario scenario = Scenario::load(kDrops);
  return scenario;
}

const freespace::Layers& truth()
{
  static const auto layers =
      truthLayers(hall().world, frameOf(hall().world, hall().truthResolution), hall().truth);
  return layers;
}

std::size_t indexAt(double x, double y)
{
  const auto& frame = truth().frame();
  return frame.indexOfKey(static_cast<int>(std::floor(x / frame.resolution)),
                          static_cast<int>(std::floor(y / frame.resolution)));
}
float floorAt(double x, double y) { return truth().floor.cells()[indexAt(x, y)]; }
float groundAt(double x, double y) { return truth().ground.cells()[indexAt(x, y)]; }

/** Edges of the world's levels, without those of what stands about. */
eval::CellMask levelEdges()
{
  return eval::without(eval::upperEdges(truth().floor, kDrop),
                       eval::cellsOf(hall().world, {"crate", "low_wall"}, truth().frame()));
}

std::size_t countIn(const eval::CellMask& cells, const Footprint& area)
{
  std::size_t count = 0;
  const auto& frame = cells.frame();
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
    {
      const double x = (frame.x0 + ix + 0.5) * frame.resolution;
      const double y = (frame.y0 + iy + 0.5) * frame.resolution;
      if (x > area.xMin && x < area.xMax && y > area.yMin && y < area.yMax)
        count += cells.at(ix, iy) != 0;
    }
  return count;
}

/** Calls visit(pose) all along the robot's way. */
template <class Visit>
void alongTheWay(double seconds, const Visit& visit)
{
  const int moments = static_cast<int>(hall().trajectory.duration() / seconds);
  for (int i = 0; i <= moments; ++i) visit(hall().trajectory.poseAt(i * seconds));
}

TEST(Drops, HasItsLevels)
{
  EXPECT_NEAR(floorAt(8, 8), kDeck, 1e-6);
  EXPECT_NEAR(floorAt(20, 13), kDeck, 1e-6) << "gallery";
  EXPECT_NEAR(floorAt(20, 4), kYard, 1e-6) << "yard";
  EXPECT_NEAR(floorAt(26, 13), kYard, 1e-6) << "behind the gallery";
  EXPECT_NEAR(floorAt(5, 4), kDeck - 1.5, 1e-6) << "pit";
  EXPECT_NEAR(floorAt(12, 0.8), kDeck + 0.18, 1e-6) << "kerb";
  EXPECT_NEAR(floorAt(2.5, 10.3), kDeck - 2.52, 1e-6) << "landing";
}

TEST(Drops, ItsStairsLeadFromTheLandingToTheDeck)
{
  float below = floorAt(2.5, 10.3);
  int steps = 0;
  for (int i = 0; i < 55; ++i)
  {
    const double x = 2.55 + 0.1 * i;
    const float here = floorAt(x, 10.3);
    if (here == below) continue;
    EXPECT_NEAR(here - below, 0.18, 1e-5) << x;
    below = here;
    ++steps;
  }
  EXPECT_EQ(steps, 14);
  EXPECT_NEAR(below, kDeck, 1e-6);
}

TEST(Drops, ItsRampLeadsFromTheDeckToTheYard)
{
  for (const double y : {9.55, 10.55, 11.55})
    for (int i = 0; i < 115; ++i)
    {
      const double x = 15.55 + 0.1 * i;
      EXPECT_EQ(groundAt(x, y), 0) << x << " " << y;
      const double right = std::min(kDeck, std::max(kYard, kDeck * (24 - x) / 8));
      EXPECT_NEAR(floorAt(x, y), right, 0.02) << x << " " << y;
    }
}

TEST(Drops, IsUnderACeilingOfFiveAndAQuarterMetres)
{
  std::size_t cells = 0;
  for (const float ceiling : truth().ceiling.cells())
  {
    if (std::isnan(ceiling)) continue;
    EXPECT_NEAR(ceiling, 5.25, 1e-6);
    ++cells;
  }
  EXPECT_GT(cells, 38000u);  // of 28 x 14 m, less the pillars
}

TEST(Drops, HasEdgesWhereOneCanFallDown)
{
  const auto edges = levelEdges();
  EXPECT_EQ(countIn(edges, {15.9, 0, 16, 9}), 90u) << "dock";
  EXPECT_EQ(countIn(edges, {23.9, 12, 24, 14}), 20u) << "gallery's end";
  // 0.3 m below the gallery after 1.92 m of the ramp, 0.3 m above the yard 1.92 m before its end
  EXPECT_NEAR(double(countIn(edges, {16, 12, 23.9, 12.1})), 60, 1) << "gallery";
  EXPECT_NEAR(double(countIn(edges, {16, 9, 24, 9.1})), 61, 1) << "ramp's open side";
  EXPECT_EQ(countIn(edges, {2.9, 2.9, 7.1, 5.1}), 2u * 42 + 2u * 20) << "pit";
  EXPECT_EQ(countIn(edges, {1.9, 9.3, 2, 11.3}), 20u) << "stairwell above the landing";
  for (const double y : {9.35, 11.25})  // its sides, up to the step that is less than 0.3 m down
    EXPECT_NEAR(double(countIn(edges, {2, y - 0.05, 7, y + 0.05})), 47, 1) << "stairwell";
}

TEST(Drops, StairsRampAndKerbAreNoEdges)
{
  const auto edges = levelEdges();
  EXPECT_EQ(countIn(edges, {2.1, 9.5, 8, 11.1}), 0u) << "stairs";
  EXPECT_EQ(countIn(edges, {15, 9.2, 25, 11.9}), 0u) << "ramp";
  EXPECT_EQ(countIn(edges, {10, 0, 14, 2}), 0u) << "kerb";
}

TEST(Drops, AreAllTheEdgesThatThereAre)
{
  const auto edges = levelEdges();
  const std::size_t named = countIn(edges, {15.9, 0, 24, 9.1}) + countIn(edges, {16, 12, 24, 14}) +
                            countIn(edges, {2, 2, 8, 6}) + countIn(edges, {1.8, 9.2, 7.2, 11.4});
  EXPECT_EQ(countIn(edges, {-1, -1, 29, 15}), named);
}

TEST(Drops, ItsRobotStaysOnTheDeckAndAwayFromEverything)
{
  constexpr double kRadius = 0.45;  // [m]
  alongTheWay(0.05,
              [](const mrpt::poses::CPose3D& pose)
              {
                ASSERT_NEAR(pose.z(), kDeck, 1e-9) << pose.asString();
                for (int i = 0; i < 36; ++i)
                  for (const double r : {0.0, 0.2, 0.35, kRadius})
                  {
                    const double x = pose.x() + r * std::cos(0.1745 * i);
                    const double y = pose.y() + r * std::sin(0.1745 * i);
                    ASSERT_EQ(groundAt(x, y), 0) << pose.asString();
                    ASSERT_NEAR(floorAt(x, y), kDeck, 1e-6) << pose.asString();
                  }
              });
}

/** Which cells of the floor, at their true places, a lidar of the hall sees. */
eval::CellMask floorSeen(const Sensor& lidar)
{
  const RayCaster caster(hall().world);
  eval::CellMask seen(truth().frame(), 0);
  std::uint64_t key = 0;
  alongTheWay(1 / lidar.params().rate,
              [&](const mrpt::poses::CPose3D& pose)
              {
                for (const auto& p : lidar.scan(caster, pose, key++).truePoints)
                {
                  const auto i = indexAt(double{p.x}, double{p.y});
                  if (std::abs(p.z - truth().floor.cells()[i]) < 0.05f) seen.cells()[i] = 1;
                }
              });
  return seen;
}

double shareSeen(const eval::CellMask& seen, const Footprint& area)
{
  const double cells = (area.xMax - area.xMin) * (area.yMax - area.yMin) * 100;
  return static_cast<double>(countIn(seen, area)) / cells;
}

const Footprint kRamp{16, 9, 24, 12}, kPit{3, 3, 7, 5}, kStairwell{2, 9.4, 7, 11.2};

TEST(Drops, TheLidarLooksDownEverywhere)
{
  ASSERT_EQ(hall().sensors.size(), 1u);
  EXPECT_EQ(hall().sensors[0]->params().name, "lidar");
  const auto seen = floorSeen(*hall().sensors[0]);
  EXPECT_GT(shareSeen(seen, kRamp), 0.7);
  EXPECT_GT(shareSeen(seen, kPit), 0.3);
  EXPECT_GT(shareSeen(seen, kStairwell), 0.3);
}

TEST(Drops, TheNarrowOneSeesNoBottomOfPitAndStairwell)
{
  const Scenario narrow = Scenario::load(kDrops, {"narrow"});
  ASSERT_EQ(narrow.sensors.size(), 1u);
  const auto seen = floorSeen(*narrow.sensors[0]);
  EXPECT_GT(shareSeen(seen, {8, 2, 16, 9}), 0.9) << "deck";
  EXPECT_GT(shareSeen(seen, kRamp), 0.3);
  EXPECT_LT(shareSeen(seen, kPit), 0.01);
  EXPECT_LT(shareSeen(seen, {2, 9.4, 6, 11.2}), 0.01);
}

TEST(Drops, AllBeamsMeetSomething)
{
  const RayCaster caster(hall().world);
  std::size_t rays = 0, returns = 0;
  const Sensor& lidar = *hall().sensors[0];
  alongTheWay(2,
              [&](const mrpt::poses::CPose3D& pose)
              {
                rays += lidar.rays();
                returns += lidar.scan(caster, pose, rays).truePoints.size();
              });
  const double expected = static_cast<double>(rays) * (1 - lidar.params().dropout);
  EXPECT_NEAR(static_cast<double>(returns), expected, 5 * std::sqrt(0.01 * expected));
}
}  // namespace
