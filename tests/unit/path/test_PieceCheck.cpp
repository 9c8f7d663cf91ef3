// Straight pieces between the points of a path, by hand.
#include <gtest/gtest.h>
#include <mrpt_mapconv/path/PieceCheck.h>

#include "FlatLayers.h"
#include "support/HandMap.h"
#include "support/SeenGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::path;
using Kind = PieceProblem::Kind;
using mrpt::math::TPoint3D;

LiftedPath pathOf(const std::vector<TPoint3D>& points)
{
  LiftedPath path;
  for (const TPoint3D& position : points)
  {
    path.points.emplace_back();
    path.points.back().position = position;
  }
  return path;
}

/** What is wrong on flat layers of 0.25 m cells, 3 m high. */
std::vector<PieceProblem> problems(const freespace::Layers& layers, const LiftParams& params,
                                   const std::vector<TPoint3D>& points)
{
  const freespace::Layers seen = test::withSeenGround(layers);
  return PieceCheck(seen, {}, params, nullptr).problems(pathOf(points));
}

TEST(StepLimit, IsTheLargestOfStepVoxelAndSlope)
{
  auto conversion = freespace::ConversionParams::paper();
  conversion.maxSlope = 2;
  EXPECT_DOUBLE_EQ(StepLimit(conversion, 0.1).at(0.3), 0.6);
  EXPECT_DOUBLE_EQ(StepLimit(conversion, 0.1).at(0.1), 0.2);
  EXPECT_DOUBLE_EQ(StepLimit(conversion, 0.1).at(0.04), 0.2) << "a cell at least";
  EXPECT_DOUBLE_EQ(StepLimit(conversion, 0.3).at(0.1), 0.6);
  conversion.maxStep = 0.3;
  EXPECT_DOUBLE_EQ(StepLimit(conversion, 0.1).at(0.1), 0.3);
  EXPECT_FALSE(StepLimit(conversion, 0.1).forbids(-0.3, 0.1));
  EXPECT_TRUE(StepLimit(conversion, 0.1).forbids(-0.31, 0.1));
}

TEST(PieceCheck, AFloorsStepComesBeforeThatOfTheHeights)
{
  auto layers = test::flatLayers();
  layers.floor.at(4, 4) = 1;
  const auto found = problems(layers, test::ground(0, 0),
                              {{0.625, 1.125, 0}, {0.875, 1.125, 1}, {1.125, 1.125, 1}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind, Kind::FloorStep);
  EXPECT_EQ(found[0].index, 2u);
  EXPECT_EQ(found[0].inWords(),
            "at (1.12, 1.12): the floor rises from 0.00 m to 1.00 m within 0.25 m, more than a "
            "ground robot can, max(maxStep, a voxel, maxSlope x distance) = 0.50 m");
  EXPECT_EQ(found[1].kind, Kind::HeightStep);
  EXPECT_EQ(found[1].index, 1u);
}

TEST(PieceCheck, PlacesAndHeightsInWordsHaveTheOriginThatIsShown)
{
  PieceProblem step{Kind::FloorStep, 2, {1.125, 1.125}, 0, 1, 0.25, 0.5, {448258, 5411929, 200}};
  EXPECT_EQ(step.inWords().rfind("at (448259.12, 5411930.12): the floor rises from 200.00 m to "
                                 "201.00 m within 0.25 m, more than a ground robot can",
                                 0),
            0u)
      << step.inWords();
  freespace::Layers layers = test::flatLayers();
  auto ground = test::ground(0, 0);
  ground.shownOrigin = {1, 2, 3};
  for (int iy = 0; iy < layers.frame().height; ++iy)
    for (int ix = 4; ix < layers.frame().width; ++ix) layers.floor.at(ix, iy) = 1;
  const auto found = problems(layers, ground, {{0.875, 1.125, 0}, {1.125, 1.125, 0}});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].shownOrigin, mrpt::math::TPoint3D(1, 2, 3));
}

TEST(PieceCheck, AnAerialRobotMayClimb)
{
  EXPECT_TRUE(
      problems(test::flatLayers(), test::sphere(1), {{0.6, 1.1, 0.5}, {0.7, 1.1, 2.5}}).empty());
}

TEST(PieceCheck, AWallsCornerIsNotCut)
{
  auto layers = test::flatLayers();
  test::block(layers, 4, 4, 1.0f);
  const std::vector<TPoint3D> around{{0.9, 1.1, 0.5}, {1.15, 1.35, 0.5}};  // over cell (4, 4)
  for (const LiftParams& params : {test::ground(0.5, 0), test::sphere(0.5)})
  {
    const auto found = problems(layers, params, around);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind, Kind::Occupied);
    EXPECT_NEAR(found[0].place.x, 1.025, 1e-9);
    EXPECT_NEAR(found[0].place.y, 1.225, 1e-9);
    // exactly through the corner is no crossing
    EXPECT_TRUE(problems(layers, params, {{0.875, 1.125, 0.5}, {1.125, 0.875, 0.5}}).empty());
  }
}

TEST(PieceCheck, WithoutAVoxelMapFloorAndCeilingStandForIt)
{
  auto layers = test::flatLayers();
  layers.floor.at(4, 4) = 1;
  layers.ceiling.at(4, 4) = 2;
  const auto flies = [&](double z) {
    return problems(layers, test::sphere(0), {{0.9, 1.1, z}, {1.2, 1.1, z}}).empty();
  };
  EXPECT_FALSE(flies(0.9));
  EXPECT_TRUE(flies(1));
  EXPECT_TRUE(flies(2));
  EXPECT_FALSE(flies(2.1));
}

TEST(PieceCheck, AGroundRobotIsAsHighAsMinClearanceAndClimbsAVoxel)
{
  const auto hits = [](int kz, double heightOffset, freespace::Robot robot)
  {
    test::HandMap map(0.1);
    for (int kx = 0; kx < 5; ++kx) map.free(kx, 0, 0, 15);
    map.occupied(2, 0, kz, kz + 1);
    const auto conversion = freespace::ConversionParams::paper();
    LiftParams params;
    params.robot = robot;
    params.heightOffset = heightOffset;
    const auto path = pathOf({{0.05, 0.05, heightOffset}, {0.45, 0.05, heightOffset}});
    for (const PieceProblem& problem :
         PieceCheck(map.convert(conversion), conversion, params, &map.source()).problems(path))
      if (problem.kind == Kind::Occupied) return true;
    return false;
  };
  using freespace::Robot;
  EXPECT_FALSE(hits(0, 0, Robot::Ground));
  EXPECT_TRUE(hits(1, 0, Robot::Ground));
  EXPECT_TRUE(hits(9, 0, Robot::Ground));
  EXPECT_FALSE(hits(10, 0, Robot::Ground));
  EXPECT_TRUE(hits(1, 0.35, Robot::Ground)) << "its body begins below the path";
  EXPECT_FALSE(hits(10, 0.35, Robot::Ground));
  EXPECT_FALSE(hits(2, 0.35, Robot::Aerial));
  EXPECT_TRUE(hits(3, 0.35, Robot::Aerial));
}

TEST(LiftedPath, HasALengthIn3DAndOneIn2D)
{
  const auto path = pathOf({{0, 0, 0}, {3, 0, 4}, {3, 2, 4}});
  EXPECT_DOUBLE_EQ(path.length(), 7);
  EXPECT_DOUBLE_EQ(path.length2D(), 5);
  EXPECT_EQ(pathOf({}).length(), 0);
}

/** Flat layers, of which one cell's free space begins elsewhere than its ground. */
freespace::Layers layersWithOpenCell(float floor, float support)
{
  auto layers = test::withSeenGround(test::flatLayers());
  layers.floor.at(4, 4) = floor;
  layers.support.at(4, 4) = support;
  layers.evidence.at(4, 4) = freespace::evidence::kInferred;
  return layers;
}

TEST(PieceCheck, StepsOfAGroundRobotAreThoseOfTheSupport)
{
  const std::vector<TPoint3D> across{{0.875, 1.125, 0}, {1.125, 1.125, 0}};
  const auto found = [&](float floor, float support)
  {
    const auto layers = layersWithOpenCell(floor, support);
    return PieceCheck(layers, {}, test::ground(0, 0), nullptr).problems(pathOf(across));
  };
  EXPECT_TRUE(found(-2, 0.25f).empty());
  const auto steps = found(0, -1);
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].kind, Kind::FloorStep);
  EXPECT_EQ(steps[0].to, -1);
}

TEST(PieceCheck, AGroundRobotCutsNoCornerOfGroundThatNobodySaw)
{
  auto layers = test::withSeenGround(test::flatLayers());
  layers.support.at(4, 4) = freespace::Layers::kNone;
  layers.evidence.at(4, 4) = freespace::evidence::kOpen;
  const auto found = [&](const LiftParams& params, const voxel::VoxelSource* voxels)
  {
    const std::vector<TPoint3D> corner{{0.9, 1.11, 0}, {1.15, 1.36, 0}};  // over (4, 4)
    return PieceCheck(layers, {}, params, voxels).problems(pathOf(corner));
  };
  test::HandMap map(0.25);
  map.free(4, 4, 0, 12);
  for (const voxel::VoxelSource* voxels :
       std::initializer_list<const voxel::VoxelSource*>{nullptr, &map.source()})
  {
    const auto unseen = found(test::ground(0, 0), voxels);
    ASSERT_EQ(unseen.size(), 1u);
    EXPECT_EQ(unseen[0].kind, Kind::UnseenGround);
    EXPECT_EQ(unseen[0].index, 1u);
    EXPECT_EQ(unseen[0].inWords(),
              "at (1.02, 1.23): on the straight way between two points, nobody saw the ground "
              "there, and none that was seen around tells where it is");
    EXPECT_TRUE(found(test::sphere(0), voxels).empty()) << "a flying robot needs none";
  }
  test::block(layers, 4, 4, grid::kUnknown);
  EXPECT_TRUE(found(test::ground(0, 0), nullptr).empty()) << "unknown cells are in nobody's way";
}

TEST(PieceCheck, UnknownVoxelsBelowAFreeRangeAreInNoGroundRobotsWay)
{
  const auto hits = [](float floor, float support, const LiftParams& params, double z)
  {
    const auto layers = layersWithOpenCell(floor, support);
    return !PieceCheck(layers, {}, params, nullptr)
                .problems(pathOf({{0.9, 1.1, z}, {1.2, 1.1, z}}))
                .empty();
  };
  EXPECT_FALSE(hits(1, 0, test::ground(0, 0), 0)) << "free space begins 1 m over the ground";
  EXPECT_TRUE(hits(-1, 0.5f, test::ground(0.25, 0), 0.25)) << "that is under the ground";
  EXPECT_TRUE(hits(1, 0, test::sphere(0), 0.5)) << "nobody flies where nothing is known";
}

}  // namespace
