// The straight pieces of random lifted paths against every voxel of the map.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/path/PieceCheck.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../oracle/PieceOracle.h"
#include "RandomMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using path::LiftedPath;
using Kind = path::PieceProblem::Kind;

MapShape smallShape(Rng& rng)
{
  MapShape shape = randomShape(rng);
  shape.nx = std::min(shape.nx, 12);
  shape.ny = std::min(shape.ny, 12);
  shape.nz = std::min(shape.nz, 40);
  return shape;
}

/** Points anywhere on the map, often on borders and centres of voxels, some far apart. */
LiftedPath randomPath(Rng& rng, const MapShape& shape, double res)
{
  const auto coordinate = [&](int first, int count)
  {
    const int key = pick(rng, first, first + count - 1);
    const int kind = pick(rng, 0, 3);
    return kind == 0 ? key * res : kind == 1 ? (key + 0.5) * res : (key + uniform(rng, 0, 1)) * res;
  };
  LiftedPath path;
  for (int i = pick(rng, 2, 6); i > 0; --i)
  {
    path::LiftedPoint point;
    point.position = {coordinate(shape.x0, shape.nx), coordinate(shape.y0, shape.ny),
                      coordinate(shape.z0, shape.nz)};
    if (!path.points.empty() && chance(rng, 50))  // near the one before
      for (const std::size_t axis : {0u, 1u, 2u})
      {
        const double before = path.points.back().position[axis];
        double& here = point.position[axis];
        if (here != before) here = before + 0.1 * (here - before);
      }
    path.points.push_back(point);
  }
  return path;
}

/** NaN, which differs from nothing by too much, where there is none. */
double supportBelow(const freespace::Layers& layers, const mrpt::math::TPoint3D& at)
{
  const double res = layers.frame().resolution;
  return static_cast<double>(layers.support.cells()[layers.frame().indexOfKey(
      grid::cellKey(at.x, res), grid::cellKey(at.y, res))]);
}

TEST(PieceCheck, FindsWhatTheVoxelsSay)
{
  constexpr double kResolutions[] = {0.05, 0.07, 0.1, 0.3};
  int crossing = 0, clear = 0, steps = 0, groundSteps = 0, unseen = 0;
  for (unsigned seed = 0; seed < 1500 && !HasFatalFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const double res = kResolutions[pick(rng, 0, 3)];
    const MapShape shape = smallShape(rng);
    octomap::OcTree tree(res);
    randomTree(rng, shape, tree);
    const oracle::DenseMap voxels = oracle::denseMap(tree);
    const voxel::OctreeSource<octomap::OcTree> source(tree);

    auto conversion = freespace::ConversionParams::paper();
    conversion.minClearance = pick(rng, 1, 8) * 0.5 * res;
    conversion.maxStep = chance(rng, 50) ? 0 : uniform(rng, 0, 3) * res;
    conversion.maxSlope = uniform(rng, 0, 3);
    if (chance(rng, 50)) conversion.floorFrom = freespace::FloorFrom::Seen;
    path::LiftParams params;
    params.robot = chance(rng, 50) ? freespace::Robot::Ground : freespace::Robot::Aerial;
    params.heightOffset = chance(rng, 50) ? 0 : uniform(rng, 0, 3) * res;
    const auto layers = freespace::convert(source, conversion, 1);
    MapShape inside = shape;
    inside.x0 = layers.frame().x0, inside.nx = layers.frame().width;
    inside.y0 = layers.frame().y0, inside.ny = layers.frame().height;
    const LiftedPath path = randomPath(rng, inside, res);

    const auto problems = path::PieceCheck(layers, conversion, params, &source).problems(path);
    const auto found = [&](Kind kind, std::size_t index)
    {
      return std::any_of(problems.begin(), problems.end(),
                         [&](const auto& problem)
                         { return problem.kind == kind && problem.index == index; });
    };
    const oracle::PieceOracle truth(voxels, conversion, params.robot, params.heightOffset);
    for (std::size_t i = 1; i < path.points.size(); ++i)
    {
      const auto &from = path.points[i - 1].position, &to = path.points[i].position;
      const bool crosses = truth.crossesOccupied(from, to);
      ASSERT_EQ(found(Kind::Occupied, i), crosses)
          << from << " to " << to << " of " << shape.text();
      ++(crosses ? crossing : clear);
      const bool high = params.robot == freespace::Robot::Ground &&
                        truth.stepTooHigh(from.z, to.z, std::hypot(to.x - from.x, to.y - from.y));
      ASSERT_EQ(found(Kind::HeightStep, i), high) << from << " to " << to;
      steps += high;
      const double before = supportBelow(layers, from), behind = supportBelow(layers, to);
      const bool rises =
          params.robot == freespace::Robot::Ground &&
          truth.stepTooHigh(before, behind, std::hypot(to.x - from.x, to.y - from.y));
      ASSERT_EQ(found(Kind::FloorStep, i), rises) << from << " to " << to;
      groundSteps += rises;
      const bool overUnseen =
          params.robot == freespace::Robot::Ground && truth.crossesUnseenGround(layers, from, to);
      ASSERT_EQ(found(Kind::UnseenGround, i), overUnseen) << from << " to " << to;
      unseen += overUnseen;
    }
  }
  EXPECT_GT(crossing, 500);
  EXPECT_GT(clear, 500);
  EXPECT_GT(steps, 200);
  EXPECT_GT(groundSteps, 100);
  EXPECT_GT(unseen, 100);
}

}  // namespace
