// planOnGrid on hand-worked maps.
#include <gtest/gtest.h>
#include <mrpt_mapconv/planning/GridPlanner.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "../../oracle/PlanOracle.h"
#include "TextMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::planning;
using mrpt::math::TPoint2D;
using mrpt_mapconv::test::PlanOracle;
using mrpt_mapconv::test::textMap;

/** Expects a sound path that starts and ends exactly where it should. */
GridPath expectPath(const grid::Layer<float>& map, const TPoint2D& start, const TPoint2D& goal,
                    double radius)
{
  const GridPath path = planOnGrid(map, start, goal, radius);
  EXPECT_TRUE(path.found()) << path.problem;
  if (path.points.empty())
  {
    ADD_FAILURE() << "no points";
    return path;
  }
  EXPECT_EQ(path.points.front(), start);
  EXPECT_EQ(path.points.back(), goal);
  EXPECT_EQ(PlanOracle(map, radius).fault(path.points), "");
  return path;
}

void expectProblem(const grid::Layer<float>& map, const TPoint2D& start, const TPoint2D& goal,
                   double radius, const std::string& problem)
{
  const GridPath path = planOnGrid(map, start, goal, radius);
  EXPECT_FALSE(path.found());
  EXPECT_TRUE(path.points.empty());
  EXPECT_EQ(path.problem, problem);
}

double pathLength(const GridPath& path)
{
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    sum += (path.points[i] - path.points[i - 1]).norm();
  return sum;
}

const grid::Layer<float> kOpen = textMap({"......", "......", "......", "......"});

TEST(GridPlanner, goesStraightWhereNothingIsInTheWay)
{
  const GridPath path = expectPath(kOpen, {0.13, 0.14}, {0.57, 0.31}, 0);
  EXPECT_EQ(path.points.size(), 2u);
}

TEST(GridPlanner, goesAroundAWall)
{
  const auto map = textMap({"......",  //
                            "..#...",  //
                            "..#...",  //
                            "..#..."});
  const GridPath path = expectPath(map, {0.05, 0.05}, {0.55, 0.05}, 0);
  // over (0.15, 0.35) or so: longer than the straight line to the wall's top and down again
  EXPECT_GT(pathLength(path), 0.15 + 0.15 + 2 * 0.25);
  EXPECT_LT(pathLength(path), 0.5 + 2 * 0.3);
}

TEST(GridPlanner, aPlaceIsAPathToItself)
{
  const GridPath path = expectPath(kOpen, {0.25, 0.25}, {0.25, 0.25}, 0.1);
  EXPECT_EQ(path.points.size(), 1u);
}

TEST(GridPlanner, staysInACell)
{
  const GridPath path = expectPath(kOpen, {0.21, 0.21}, {0.29, 0.28}, 0.1);
  EXPECT_EQ(path.points.size(), 2u);
}

TEST(GridPlanner, aMapOfOneCell)
{
  expectPath(textMap({"."}), {0.01, 0.02}, {0.09, 0.03}, 0);
  expectProblem(textMap({"#"}), {0.01, 0.02}, {0.09, 0.03}, 0,
                "start (0.01, 0.02) m is in an occupied cell");
  expectProblem(textMap({"."}), {0.01, 0.02}, {0.09, 0.03}, 0.05,
                "start (0.01, 0.02) m is too near to an obstacle: its free cell comes within 0 m "
                "of the map's edge, the robot's radius is 0.05 m");
}

// PlannerSimple2D by itself finds no way between two neighbours without a third cell beside them
TEST(GridPlanner, neighboursInADeadEnd)
{
  const auto map = textMap({"####",  //
                            "#..#",  //
                            "####"});
  expectPath(map, {0.11, 0.11}, {0.29, 0.19}, 0);
  expectPath(textMap({".."}), {0.19, 0.0}, {0.1, 0.0}, 0);
}

TEST(GridPlanner, aPlaceOnTheSideOfAWall)
{
  const auto map = textMap({"#####",  //
                            "#...#",  //
                            "#.#.#",  //
                            "#...#",  //
                            "#####"});
  const double third = 3 * 0.1;  // where column and row 3 begin; 0.3 is less than that
  expectPath(map, {0.1, 0.1}, {third, third}, 0);
  expectPath(map, {third, 0.1}, {0.1, third}, 0);
  expectPath(map, {third, 0.2}, {0.1, 0.2}, 0);
  expectProblem(map, {0.1, 0.1}, {0.2, 0.2}, 0, "goal (0.2, 0.2) m is in an occupied cell");
}

// between walls, n cells hold a disc anywhere in the middle cell if 0.1 (n - 1) / 2 ≥ radius
TEST(GridPlanner, corridorJustWideEnough)
{
  const auto map = textMap({"##########", "..........", "..........", "..........", "..........",
                            "..........", "##########"});
  expectPath(map, {0.35, 0.35}, {0.65, 0.35}, 0.2);
  expectPath(map, {0.3, 0.31}, {0.65, 0.39}, 0.2);
  expectProblem(map, {0.35, 0.35}, {0.65, 0.35}, 0.201,
                "start (0.35, 0.35) m is too near to an obstacle: its free cell comes within 0.2 m "
                "of the occupied cell at (0.25, 0.05) m, the robot's radius is 0.201 m");
}

TEST(GridPlanner, aDoorJustWideEnough)
{
  const auto map = textMap({"........#........",  //
                            "........#........",  //
                            "........#........",  //
                            "........#........",  //
                            ".................",  //
                            ".................",  //
                            ".................",  //
                            "........#........",  //
                            "........#........",  //
                            "........#........",  //
                            "........#........"});
  expectPath(map, {0.35, 0.15}, {1.35, 0.95}, 0.1);
  expectProblem(map, {0.35, 0.25}, {1.35, 0.85}, 0.11,
                "start (0.35, 0.25) m and goal (1.35, 0.85) m are not connected for a robot with a "
                "radius of 0.11 m");
}

// 4.2 / 0.3 is a little more than 14 in doubles
TEST(GridPlanner, aRadiusOfWholeCellsLosesNoneToRounding)
{
  const grid::Layer<float> map({0.3, 0, 0, 29, 29}, 0.0f);
  EXPECT_TRUE(planOnGrid(map, {4.35, 4.35}, {4.37, 4.33}, 4.2).found());
  EXPECT_FALSE(planOnGrid(map, {4.35, 4.35}, {4.37, 4.33}, 4.2001).found());
}

TEST(GridPlanner, inflatesByADiscNotASquare)
{
  // the square of cell (3, 3) is 0.2 and 0.2 m away from the pillar's, that is 0.283 m
  grid::Layer<float> wide({0.1, -20, -20, 50, 50}, 0.0f);
  wide.at(20, 20) = 1.0f;
  expectPath(wide, {0.35, 0.35}, {0.85, 0.85}, 0.28);
  EXPECT_FALSE(planOnGrid(wide, {0.35, 0.35}, {0.85, 0.85}, 0.29).found());
  EXPECT_FALSE(planOnGrid(wide, {0.35, 0.25}, {0.85, 0.85}, 0.28).found());
}

TEST(GridPlanner, slipsThroughNoDiagonalGap)
{
  const auto gap = textMap({"..#..",  //
                            "..#..",  //
                            ".#...",  //
                            ".#..."});
  expectProblem(gap, {0.05, 0.05}, {0.45, 0.35}, 0,
                "start (0.05, 0.05) m and goal (0.45, 0.35) m are not connected for a robot with a "
                "radius of 0 m");
  // PlannerSimple2D by itself goes through the gap although there is a way around
  const auto around = textMap({"..#..",  //
                               "..#..",  //
                               ".#...",  //
                               ".#...",  //
                               "....."});
  const GridPath path = expectPath(around, {0.05, 0.45}, {0.45, 0.35}, 0);
  EXPECT_GT(pathLength(path), 0.35 + 0.4);  // down to the lowest row, across, and up again
}

TEST(GridPlanner, cutsNoCorner)
{
  const auto map = textMap({"..",  //
                            ".#"});
  const GridPath path = expectPath(map, {0.05, 0.05}, {0.15, 0.15}, 0);
  EXPECT_EQ(path.points.size(), 3u);
}

// PlannerSimple2D by itself leaves the two outer rows as they are
TEST(GridPlanner, keepsOffTheMapsEdge)
{
  const auto map = textMap({".....",  //
                            ".....",  //
                            ".###.",  //
                            ".....",  //
                            "....."});
  expectPath(map, {0.05, 0.05}, {0.45, 0.45}, 0);
  expectProblem(kOpen, {0.25, 0.05}, {0.25, 0.15}, 0.1,
                "start (0.25, 0.05) m is too near to an obstacle: its free cell comes within 0 m "
                "of the map's edge, the robot's radius is 0.1 m");
  expectPath(kOpen, {0.15, 0.15}, {0.45, 0.25}, 0.1);
  expectProblem(kOpen, {0.15, 0.15}, {0.55, 0.25}, 0.1,
                "goal (0.55, 0.25) m is too near to an obstacle: its free cell comes within 0 m "
                "of the map's edge, the robot's radius is 0.1 m");
}

TEST(GridPlanner, endsOutsideTheMap)
{
  const std::string covers =
      " is outside the map, which covers x from 0 to 0.6 m and y from 0 to 0.4 m";
  expectProblem(kOpen, {-0.01, 0.05}, {0.15, 0.15}, 0, "start (-0.01, 0.05) m" + covers);
  expectProblem(kOpen, {0.15, 0.15}, {0.55, 0.41}, 0, "goal (0.55, 0.41) m" + covers);
  expectProblem(kOpen, {0.15, 0.15}, {1e9, 0.1}, 0, "goal (1000000000, 0.1) m" + covers);
  expectProblem(kOpen, {0.15, 0.15}, {0.15, 4 * 0.1}, 0, "goal (0.15, 0.4) m" + covers);
}

TEST(GridPlanner, endsInCellsThatAreNotFree)
{
  const auto map = textMap({".#?."});
  expectProblem(map, {0.15, 0.05}, {0.05, 0.05}, 0, "start (0.15, 0.05) m is in an occupied cell");
  expectProblem(map, {0.05, 0.05}, {0.15, 0.05}, 0, "goal (0.15, 0.05) m is in an occupied cell");
  expectProblem(map, {0.25, 0.05}, {0.05, 0.05}, 0, "start (0.25, 0.05) m is in an unknown cell");
  expectProblem(map, {0.05, 0.05}, {0.25, 0.05}, 0, "goal (0.25, 0.05) m is in an unknown cell");
}

TEST(GridPlanner, passesNothingUnknown)
{
  EXPECT_FALSE(planOnGrid(textMap({".?."}), {0.05, 0.05}, {0.25, 0.05}, 0).found());
  grid::Layer<float> map({0.1, 0, 0, 3, 1}, 0.0f);
  map.at(1, 0) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(planOnGrid(map, {0.05, 0.05}, {0.25, 0.05}, 0).found());
  map.at(1, 0) = 0.004f;
  EXPECT_FALSE(planOnGrid(map, {0.05, 0.05}, {0.25, 0.05}, 0).found()) << "hardly occupied";
}

TEST(GridPlanner, aRadiusLargerThanTheMap)
{
  EXPECT_FALSE(planOnGrid(kOpen, {0.15, 0.15}, {0.25, 0.25}, 1.0).found());
  EXPECT_FALSE(planOnGrid(kOpen, {0.15, 0.15}, {0.25, 0.25}, 1e300).found());
}

// MRPT's float limits could not hold this frame
TEST(GridPlanner, farFromTheOrigin)
{
  grid::Layer<float> map({0.05, 200000000, -190000000, 9, 9}, 0.0f);
  for (std::int32_t iy = 0; iy < 8; ++iy) map.at(4, iy) = 1.0f;
  const double x = map.frame().xMin(), y = map.frame().yMin();
  const TPoint2D start(x + 0.07, y + 0.08), goal(x + 0.43, y + 0.02);
  const GridPath path = planOnGrid(map, start, goal, 0);
  ASSERT_TRUE(path.found()) << path.problem;
  EXPECT_EQ(path.points.front(), start);
  EXPECT_EQ(path.points.back(), goal);
}

TEST(GridPlanner, rejectsWhatIsNoInput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const TPoint2D place(0.15, 0.15);
  EXPECT_THROW(planOnGrid({}, place, place, 0), std::invalid_argument);
  EXPECT_THROW(planOnGrid(kOpen, {nan, 0.1}, place, 0), std::invalid_argument);
  EXPECT_THROW(planOnGrid(kOpen, place, {0.1, infinity}, 0), std::invalid_argument);
  EXPECT_THROW(planOnGrid(kOpen, place, place, nan), std::invalid_argument);
  EXPECT_THROW(planOnGrid(kOpen, place, place, infinity), std::invalid_argument);
  try
  {
    planOnGrid(kOpen, place, place, -0.1);
    FAIL() << "took a negative radius";
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_STREQ(e.what(),
                 "plan: robot radius = -0.1 is not valid: it must be finite and not negative [m]");
  }
}

}  // namespace
