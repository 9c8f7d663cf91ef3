// Paths lifted by hand: floors ahead, the sphere between floor and ceiling, what stops it.
#include <gtest/gtest.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <cmath>
#include <limits>

#include "FlatLayers.h"
#include "support/SeenGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::path;
using test::block;
using test::flatLayers;
using test::ground;
using test::sphere;
using Points = std::vector<mrpt::math::TPoint2D>;

LiftedPath lift(const Points& points, const freespace::Layers& layers, const LiftParams& params)
{
  return liftPath(points, test::withSeenGround(layers), {}, params);
}

/** The one point of a path that is only one point. */
LiftedPoint liftOne(double x, double y, const freespace::Layers& layers, const LiftParams& params)
{
  const LiftedPath lifted = lift({{x, y}}, layers, params);
  EXPECT_EQ(lifted.points.size(), 1u);
  return lifted.points.at(0);
}

void raiseFloorFrom(freespace::Layers& layers, int ix, float floor)
{
  for (int iy = 0; iy < layers.frame().height; ++iy)
    for (int x = ix; x < layers.frame().width; ++x) layers.floor.at(x, iy) = floor;
}

// half height of a 0.5 m sphere 0.125 m from its centre
const double kHalf = std::sqrt(0.25 - 0.015625);

TEST(LiftPath, PointsAreAddedUntilNoSpacingExceedsACell)
{
  const LiftedPath lifted = lift({{1.0, 1.0}, {2.0, 1.0}, {2.0, 1.3}}, flatLayers(), sphere(1));
  ASSERT_EQ(lifted.points.size(), 7u);  // 1 m is 4 cells, 0.3 m takes 2 steps
  const double x[] = {1, 1.25, 1.5, 1.75, 2, 2, 2}, y[] = {1, 1, 1, 1, 1, 1.15, 1.3};
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_NEAR(lifted.points[i].position.x, x[i], 1e-12);
    EXPECT_NEAR(lifted.points[i].position.y, y[i], 1e-12);
    EXPECT_EQ(lifted.points[i].isInput, i == 0 || i == 4 || i == 6) << i;
  }
}

TEST(LiftPath, PlacesInWordsHaveTheOriginThatIsShown)
{
  LiftParams params = sphere(1);
  params.shownOrigin = {448258, 5411929, 200};
  const LiftedPath lifted = lift({{-5, 1}}, flatLayers(), params);
  EXPECT_EQ(lifted.points[0].position.x, -5);
  EXPECT_EQ(lifted.describeProblem(0),
            "point 0 at (448253.00, 5411930.00): it lies outside the map");
}

TEST(LiftPath, DecimalLengthsGetNoExtraPoint)
{
  // 0.7 − 0.4 is a little less, 0.4 − 0.1 a little more than three cells of 0.1 m
  for (const double from : {0.1, 0.4})
    EXPECT_EQ(lift({{from, 0.5}, {from + 0.3, 0.5}}, flatLayers(0.1), ground(0, 0)).points.size(),
              4u);
}

TEST(LiftPath, GroundOverAStep)
{
  freespace::Layers layers = flatLayers();
  raiseFloorFrom(layers, 8, 0.5f);  // x ≥ 2 m
  const LiftedPath lifted = lift({{1.125, 1}, {2.625, 1}, {1.125, 1}}, layers, ground(0.25, 0.5));
  EXPECT_TRUE(lifted.feasible());
  EXPECT_FALSE(lifted.slabsChecked);
  ASSERT_EQ(lifted.points.size(), 13u);
  // the first point on the step is at 2.125; 1.625 is exactly 0.5 m before and behind it
  const double z[] = {0.25, 0.25, 0.75, 0.75, 0.75, 0.75, 0.75, 0.75, 0.75, 0.75, 0.75, 0.25, 0.25};
  for (std::size_t i = 0; i < lifted.points.size(); ++i)
  {
    EXPECT_EQ(lifted.points[i].position.z, z[i]) << i;
    EXPECT_EQ(lifted.points[i].rule, HeightRule::FloorAhead) << i;
  }
}

TEST(LiftPath, LookaheadEndsAreIncludedInDecimalsToo)
{
  freespace::Layers layers = flatLayers(0.1);
  raiseFloorFrom(layers, 8, 1.0f);
  // points at 0.55, 0.65, …: the one at 0.85 is two cells on, by decimals 0.2 m
  const LiftedPath near = lift({{0.55, 0.5}, {0.95, 0.5}}, layers, ground(0, 0.2));
  EXPECT_EQ(near.points.at(0).position.z, 0);
  EXPECT_EQ(near.points.at(1).position.z, 1);
  const LiftedPath far = lift({{0.55, 0.5}, {0.95, 0.5}}, layers, ground(0, 0.3));
  EXPECT_EQ(far.points.at(0).position.z, 1);
}

TEST(LiftPath, LookaheadFollowsThePathNotTheBeeline)
{
  freespace::Layers layers = flatLayers();
  raiseFloorFrom(layers, 8, 0.5f);
  // there and back again: the last point is 0.75 m from the step, the way to it 2.25 m
  const Points detour = {{2.125, 1.125}, {2.125, 2.125}, {1.375, 2.125}, {1.375, 1.625}};
  const LiftedPath lifted = lift(detour, layers, ground(0, 1));
  EXPECT_EQ(lifted.points.back().position.z, 0);
}

TEST(LiftPath, LookaheadSkipsCellsWithoutFloor)
{
  freespace::Layers layers = flatLayers();
  block(layers, 5, 4, grid::kUnknown);
  const LiftedPath lifted = lift({{1.125, 1.125}, {1.625, 1.125}}, layers, ground(0.25, 1));
  ASSERT_EQ(lifted.points.size(), 3u);
  EXPECT_EQ(lifted.points[0].position.z, 0.25);
  EXPECT_EQ(lifted.points[1].problem, Infeasibility::NoFloor);
  EXPECT_EQ(lifted.points[2].position.z, 0.25);
  EXPECT_EQ(lifted.firstProblem(), 1u);
  EXPECT_EQ(lifted.describeProblem(1), "point 1 at (1.38, 1.12): no floor there");
  EXPECT_EQ(lifted.describeProblem(0), "");
}

TEST(LiftPath, SphereOverAStep)
{
  freespace::Layers layers = flatLayers();
  raiseFloorFrom(layers, 8, 0.5f);  // x ≥ 2 m
  const LiftParams params = sphere(0.25);
  const LiftedPoint before = liftOne(1.125, 1.125, layers, params);
  EXPECT_EQ(before.position.z, 0.5);  // 0.25 would be nearer to the floor than the radius
  EXPECT_EQ(before.rule, HeightRule::SphereFloor);
  const LiftedPoint edge = liftOne(1.875, 1.125, layers, params);  // 0.125 m before the step
  EXPECT_NEAR(edge.position.z, 0.5 + kHalf, 1e-12);
  EXPECT_EQ(edge.rule, HeightRule::SphereFloor);
  const LiftedPoint onTop = liftOne(2.875, 1.125, layers, sphere(0.75));
  EXPECT_EQ(onTop.position.z, 1.25);
  EXPECT_EQ(onTop.rule, HeightRule::FloorAhead);
}

TEST(LiftPath, SphereUnderACeiling)
{
  freespace::Layers layers = flatLayers();
  const LiftedPoint high = liftOne(1.125, 1.125, layers, sphere(2.75));
  EXPECT_EQ(high.position.z, 2.5);
  EXPECT_EQ(high.rule, HeightRule::SphereCeiling);
  const LiftedPoint touching = liftOne(1.125, 1.125, layers, sphere(2.5));
  EXPECT_EQ(touching.position.z, 2.5);
  EXPECT_EQ(touching.rule, HeightRule::FloorAhead) << "touching is allowed";
  layers.ceiling.at(5, 4) = 1.25f;  // the next cell, 0.125 m away, hangs lower
  const LiftedPoint beside = liftOne(1.125, 1.125, layers, sphere(2.75));
  EXPECT_NEAR(beside.position.z, 1.25 - kHalf, 1e-12);
  EXPECT_EQ(beside.rule, HeightRule::SphereCeiling);
}

TEST(LiftPath, GapThatIsTooLow)
{
  freespace::Layers layers = flatLayers();
  for (int iy = 0; iy < 12; ++iy) layers.ceiling.at(8, iy) = 0.9375f;
  const LiftedPath lifted = lift({{1.125, 1.125}, {2.625, 1.125}}, layers, sphere(0.5));
  ASSERT_EQ(lifted.points.size(), 7u);
  EXPECT_FALSE(lifted.feasible());
  // 0.125 m before the gap: z ≥ 0.5 (own floor), z ≤ 0.9375 − 0.484…; 0.375 m before: ≤ 0.607
  EXPECT_EQ(lifted.firstProblem(), 3u);
  EXPECT_EQ(lifted.points[2].problem, Infeasibility::None);
  EXPECT_EQ(lifted.points[4].problem, Infeasibility::NoHeight);
  EXPECT_TRUE(std::isnan(lifted.points[4].position.z));
  EXPECT_EQ(lifted.points[4].rule, HeightRule::None);
  EXPECT_EQ(lifted.points[6].problem, Infeasibility::None) << "no point depends on another's";
  EXPECT_EQ(lifted.describeProblem(4),
            "point 4 at (2.12, 1.12): the safety sphere fits in at no height");
  for (int iy = 0; iy < 12; ++iy) layers.ceiling.at(8, iy) = 1.0f;
  EXPECT_EQ(liftOne(2.125, 1.125, layers, sphere(2)).position.z, 0.5) << "a gap that just fits";
}

TEST(LiftPath, GapOfTheSpheresDiameterFitsAtEveryHeight)
{
  // heights are floats: 1.1f − 0.1f is not 1
  for (int key = -200; key <= 1000; ++key)
  {
    freespace::Layers layers = flatLayers(0.1);
    for (float& floor : layers.floor.cells()) floor = static_cast<float>(key * 0.1);
    for (float& ceiling : layers.ceiling.cells()) ceiling = static_cast<float>((key + 10) * 0.1);
    const LiftedPoint point = liftOne(0.55, 0.55, layers, sphere(1));
    ASSERT_EQ(point.problem, Infeasibility::None) << key;
    ASSERT_NEAR(point.position.z, key * 0.1 + 0.5, 1e-5);
  }
}

TEST(LiftPath, AlongTheMapsEdge)
{
  const freespace::Layers layers = flatLayers();
  const LiftedPath lifted = lift({{1, 0.375}, {2, 0.375}}, layers, sphere(1));
  for (const LiftedPoint& point : lifted.points)
    EXPECT_EQ(point.problem, Infeasibility::Unknown) << "0.375 m from the edge";
  EXPECT_EQ(lifted.points.back().obstacle, mrpt::math::TPoint2D(1.875, -0.125));
  EXPECT_EQ(lifted.describeProblem(4),
            "point 4 at (2.00, 0.38): the safety sphere reaches the unknown cell at (1.88, -0.12)");
  EXPECT_EQ(liftOne(1, 0.5, layers, sphere(1)).problem, Infeasibility::Unknown) << "it touches";
  EXPECT_EQ(liftOne(1, 0.501, layers, sphere(1)).problem, Infeasibility::None);

  LiftParams brave = sphere(1);
  brave.unknownIsPassable = true;
  EXPECT_EQ(liftOne(1, 0.375, layers, brave).position.z, 1);
  EXPECT_EQ(liftOne(0, 0, layers, brave).problem, Infeasibility::None) << "the corner is inside";
  EXPECT_EQ(liftOne(5, 1, layers, brave).problem, Infeasibility::OffMap) << "xMax is not";
  EXPECT_EQ(liftOne(1, 3, layers, brave).problem, Infeasibility::OffMap);
  EXPECT_EQ(liftOne(-1e-9, 1, layers, brave).problem, Infeasibility::OffMap);
  EXPECT_EQ(lift({{1e12, 1}}, layers, brave).describeProblem(0),
            "point 0 at (1000000000000.00, 1.00): it lies outside the map");
}

TEST(LiftPath, WallsAndUnknownCells)
{
  freespace::Layers layers = flatLayers();
  block(layers, 10, 6, grid::kUnknown);  // x 2.5 … 2.75, y 1.5 … 1.75
  LiftParams brave = sphere(1);
  brave.unknownIsPassable = true;
  EXPECT_EQ(liftOne(2.375, 1.625, layers, sphere(1)).problem, Infeasibility::Unknown);
  EXPECT_EQ(liftOne(2.375, 1.625, layers, brave).position.z, 1);

  block(layers, 11, 6, 0.6f);  // behind it, 0.375 m away
  const LiftedPath wall = lift({{2.375, 1.625}}, layers, sphere(1));
  EXPECT_EQ(wall.points[0].problem, Infeasibility::Wall) << "a wall counts before the unknown";
  EXPECT_EQ(wall.describeProblem(0),
            "point 0 at (2.38, 1.62): the safety sphere reaches the occupied cell at (2.88, 1.62)");
  EXPECT_EQ(liftOne(2.375, 1.625, layers, brave).problem, Infeasibility::Wall);
  EXPECT_EQ(liftOne(2.625, 1.625, layers, brave).problem, Infeasibility::NoFloor);
  EXPECT_EQ(liftOne(2.375, 1.625, layers, ground(1, 0)).problem, Infeasibility::None)
      << "a ground robot has no sphere";
}

TEST(LiftPath, ReachIsExactInDecimals)
{
  freespace::Layers layers = flatLayers(0.1);
  block(layers, 7, 5, 1.0f);  // from 0.7 m on, in double a little more
  LiftParams params = sphere(1);
  params.safetyRadius = 0.25;
  EXPECT_EQ(liftOne(0.45, 0.55, layers, params).problem, Infeasibility::Wall);
  EXPECT_EQ(liftOne(0.45 - 1e-6, 0.55, layers, params).problem, Infeasibility::None);
}

TEST(LiftPath, EmptySingleAndRepeatedPoints)
{
  const freespace::Layers layers = flatLayers();
  const LiftedPath none = lift({}, layers, sphere(1));
  EXPECT_TRUE(none.points.empty());
  EXPECT_TRUE(none.feasible());

  const LiftedPoint one = liftOne(2, 1, layers, sphere(1, 5));
  EXPECT_EQ(one.position, mrpt::math::TPoint3D(2, 1, 1));
  EXPECT_TRUE(one.isInput);

  const LiftedPath repeated = lift({{2, 1}, {2, 1}, {2.25, 1}, {2.25, 1}}, layers, sphere(1));
  ASSERT_EQ(repeated.points.size(), 4u);
  for (const LiftedPoint& point : repeated.points)
  {
    EXPECT_TRUE(point.isInput);
    EXPECT_EQ(point.position.z, 1);
  }
}

}  // namespace
