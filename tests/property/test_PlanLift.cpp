// What planRobotPath() plans is what liftPath() and PieceCheck accept.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/path/PieceCheck.h>
#include <mrpt_mapconv/planning/RobotPath.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../oracle/PieceOracle.h"
#include "RandomMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using freespace::Robot;
using mrpt::math::TPoint2D;

constexpr int kSide = 24, kTop = 30;  // voxels

/** What was not seen of a column. */
struct Unseen
{
  int end = -1;       //!< nothing below this voxel was seen,
  int butFor = kTop;  //!< but for this one, of something that stands there
  bool has(int z) const { return z < end && z != butFor; }
};

/** Patches and bands of columns of which the ground and perhaps some more was not seen. */
std::vector<Unseen> unseenPatches(Rng& rng, const std::vector<int>& floor)
{
  std::vector<Unseen> columns(kSide * kSide);
  for (int patch = pick(rng, 1, 8); patch > 0; --patch)
  {
    const bool alongX = chance(rng, 50);
    const int x = alongX && chance(rng, 50) ? 0 : pick(rng, 0, kSide - 1);
    const int y = pick(rng, 0, kSide - 1);
    const int xEnd = std::min(kSide, x + pick(rng, 1, alongX ? kSide : 5));
    const int yEnd = std::min(kSide, y + pick(rng, 1, alongX ? 5 : kSide));
    const int above = chance(rng, 60) ? 0 : pick(rng, -1, 7);
    const int thing = chance(rng, 50) ? pick(rng, 1, 5) : kTop;
    for (int iy = y; iy < yEnd; ++iy)
      for (int ix = x; ix < xEnd; ++ix)
        if (const auto i = static_cast<std::size_t>(iy * kSide + ix); floor[i] < kTop)
          columns[i] = {floor[i] + above, floor[i] + thing};
  }
  return columns;
}

/** Floors in patches, each a little higher or lower than what it lies on, some walls and lintels;
 * free space up to kTop.
 * \param unseen whether the ground was not seen everywhere */
void fillWithSteps(Rng& rng, bool unseen, octomap::OcTree& tree)
{
  std::vector<int> floor(kSide * kSide, 4), top(kSide * kSide, kTop);
  for (int patch = pick(rng, 3, 20); patch > 0; --patch)
  {
    const bool across = chance(rng, 30);  // no way around
    const int x = pick(rng, 0, kSide - 1), y = across ? 0 : pick(rng, 0, kSide - 1);
    const int xEnd = std::min(kSide, x + pick(rng, 1, 14));
    const int yEnd = across ? kSide : std::min(kSide, y + pick(rng, 1, 14));
    const int kind = across ? 2 : pick(rng, 0, 9), change = kind == 0 ? kTop : pick(rng, -2, 2);
    for (int iy = y; iy < yEnd; ++iy)
      for (int ix = x; ix < xEnd; ++ix)
        if (const auto i = static_cast<std::size_t>(iy * kSide + ix); kind == 1)
          top[i] = kTop - 14;
        else
          floor[i] = std::clamp(floor[i] + change, 0, kTop);
  }
  const auto notSeen = unseen ? unseenPatches(rng, floor) : std::vector<Unseen>(kSide * kSide);
  for (int iy = 0; iy < kSide; ++iy)
    for (int ix = 0; ix < kSide; ++ix)
      for (int z = -1; z < kTop; ++z)
      {
        const auto i = static_cast<std::size_t>(iy * kSide + ix);
        if (notSeen[i].has(z)) continue;
        const bool occupied = z < floor[i] || z >= top[i] || (z < notSeen[i].end);
        tree.setNodeValue(oracle::octomapKey(ix, iy, z), occupied ? 3.5f : -2.0f, true);
      }
  tree.updateInnerOccupancy();
}

/** A place anywhere in a free cell; anywhere at all if none is found. */
TPoint2D somewhere(Rng& rng, const grid::Layer<float>& occupancy, double res)
{
  int ix = 0, iy = 0;
  for (int tries = 0; tries < 40; ++tries)
  {
    ix = pick(rng, 0, kSide - 1), iy = pick(rng, 0, kSide - 1);
    if (occupancy.at(ix, iy) == grid::kFree) break;
  }
  return {(ix + uniform(rng, 0.001, 0.999)) * res, (iy + uniform(rng, 0.001, 0.999)) * res};
}

std::vector<TPoint2D> flat(const path::LiftedPath& path)
{
  std::vector<TPoint2D> points;
  for (const auto& point : path.points) points.emplace_back(point.position.x, point.position.y);
  return points;
}

/** Free cells of the ground layer over whose ground something occupied is in a ground robot's way,
 * by all voxels: there must be none. */
std::vector<TPoint2D> obstaclesIn(const octomap::OcTree& tree, const freespace::Layers& layers,
                                  const freespace::ConversionParams& conversion)
{
  const double res = tree.getResolution();
  const oracle::DenseMap voxels = oracle::denseMap(tree);
  const oracle::PieceOracle body(voxels, conversion, Robot::Ground, 0);
  std::vector<TPoint2D> centres;
  for (int iy = 0; iy < layers.frame().height; ++iy)
    for (int ix = 0; ix < layers.frame().width; ++ix)
    {
      const mrpt::math::TPoint3D place((layers.frame().x0 + ix + 0.5) * res,
                                       (layers.frame().y0 + iy + 0.5) * res,
                                       static_cast<double>(layers.support.at(ix, iy)));
      if (layers.ground.at(ix, iy) == grid::kFree && body.crossesOccupied(place, place))
        centres.emplace_back(place.x, place.y);
    }
  return centres;
}

/** Kinds of paths that came up. */
struct Tally
{
  int climbing = 0, flown = 0, inferred = 0;
};

/** Plans on a random map, if there is a way, and lifts what was planned. */
void checkOnce(unsigned seed, freespace::FloorFrom floorFrom, Tally& tally)
{
  constexpr double kResolutions[] = {0.05, 0.1, 0.3};
  SCOPED_TRACE("seed " + std::to_string(seed));
  Rng rng(seed);
  const double res = kResolutions[pick(rng, 0, 2)];
  octomap::OcTree tree(res);
  fillWithSteps(rng, floorFrom == freespace::FloorFrom::Seen, tree);
  const voxel::OctreeSource<octomap::OcTree> source(tree);

  freespace::ConversionParams conversion;
  conversion.floorFrom = floorFrom;
  conversion.minClearance = pick(rng, 5, 12) * res;
  conversion.maxStep = chance(rng, 60) ? 0 : pick(rng, 1, 3) * res;
  conversion.maxSlope = pick(rng, 1, 3) + uniform(rng, 0.001, 0.1);  // steps are just low enough
  const auto layers = freespace::convert(source, conversion, 1);
  planning::RobotPathQuery query;
  query.lift.robot = chance(rng, 75) ? Robot::Ground : Robot::Aerial;
  const bool ground = query.lift.robot == Robot::Ground;
  query.robotRadius = chance(rng, 50) ? 0 : uniform(rng, 0, 2) * res;
  query.lift.safetyRadius = conversion.minClearance * uniform(rng, 0.1, 0.4);
  query.lift.heightOffset = ground && chance(rng, 70) ? 0 : uniform(rng, 0, 6) * res;
  query.lift.lookahead = chance(rng, 50) ? 5 * res : uniform(rng, 0, 8) * res;
  const auto& occupancy = ground ? layers.ground : layers.aerial;
  query.start = somewhere(rng, occupancy, res);
  query.goal = somewhere(rng, occupancy, res);

  const auto planned = planning::planRobotPath(layers, conversion, query, &source);
  if (!planned.found()) return;
  const auto lifted = path::liftPath(flat(planned.path), layers, conversion, query.lift, &source);
  ASSERT_EQ(lifted.points.size(), planned.path.points.size());
  ASSERT_TRUE(lifted.feasible()) << lifted.describeProblem(*lifted.firstProblem());
  ASSERT_NEAR(lifted.inferredLength, planned.path.inferredLength, 1e-9);
  for (const auto& problem :
       path::PieceCheck(layers, conversion, query.lift, &source).problems(lifted))
    FAIL() << "point " << problem.index << " " << problem.inWords();
  double low = 1e9, high = -1e9;
  for (const auto& point : lifted.points)
  {
    low = std::min(low, point.position.z);
    high = std::max(high, point.position.z);
  }
  tally.climbing += ground && high - low > 1.5 * res;
  tally.flown += !ground;
  tally.inferred += lifted.inferredLength > 1.5 * res;
  if (!ground || floorFrom != freespace::FloorFrom::Seen) return;
  ASSERT_TRUE(obstaclesIn(tree, layers, conversion).empty());
}

TEST(PlanLift, EveryPlannedPathIsAccepted)
{
  Tally tally;
  for (unsigned seed = 0; seed < 1000 && !HasFatalFailure(); ++seed)
    checkOnce(seed, freespace::FloorFrom::LowestFree, tally);
  EXPECT_GT(tally.climbing, 100);
  EXPECT_GT(tally.flown, 50);
  EXPECT_EQ(tally.inferred, 0);
}

TEST(PlanLift, EveryPathOverInferredGroundIsAccepted)
{
  Tally tally;
  for (unsigned seed = 0; seed < 1000 && !HasFatalFailure(); ++seed)
    checkOnce(seed, freespace::FloorFrom::Seen, tally);
  EXPECT_GT(tally.climbing, 100);
  EXPECT_GT(tally.flown, 50);
  EXPECT_GT(tally.inferred, 100);
}

}  // namespace
