// Lifting against its brute-force twin, and every lifted point against the sphere condition.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/path/LiftPath.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/octomap.h>

#include <cmath>
#include <map>
#include <string>

#include "../oracle/LiftOracle.h"
#include "DenseSource.h"
#include "RandomGround.h"
#include "RandomMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt::math::TPoint2D;
using path::HeightRule;
using path::Infeasibility;
using path::LiftedPoint;

constexpr double kResolutions[] = {0.05, 0.07, 0.08, 0.3, 0.1};

/** How often each rule and each problem came up. */
struct Seen
{
  std::map<HeightRule, int> rules;
  std::map<Infeasibility, int> problems;
  int inferred = 0;  //!< ground robots' paths over inferred cells
};

/** A coordinate in or around cells [first, first + count): often on a cell's border or centre. */
double randomCoordinate(Rng& rng, int first, int count, double res)
{
  const int margin = chance(rng, 20) ? 3 : 0;
  const int key = pick(rng, first - margin, first + count + margin - 1);
  switch (pick(rng, 0, 3))
  {
    case 0:
      return key * res;
    case 1:
      return (key + 0.5) * res;
    default:
      return (key + uniform(rng, 0, 1)) * res;
  }
}

std::vector<TPoint2D> randomPath(Rng& rng, const grid::GridFrame& frame)
{
  std::vector<TPoint2D> points;
  for (int i = pick(rng, 0, 5); i > 0; --i)
  {
    const TPoint2D point(randomCoordinate(rng, frame.x0, frame.width, frame.resolution),
                         randomCoordinate(rng, frame.y0, frame.height, frame.resolution));
    for (int repeat = chance(rng, 20) ? pick(rng, 2, 3) : 1; repeat > 0; --repeat)
      points.push_back(point);
  }
  return points;
}

/** Parameters that fit the heights of a random map. */
void randomParams(Rng& rng, double res, freespace::ConversionParams& conversion,
                  path::LiftParams& params)
{
  params.robot = chance(rng, 85) ? freespace::Robot::Aerial : freespace::Robot::Ground;
  params.lookahead = chance(rng, 30) ? pick(rng, 0, 4) * res : uniform(rng, 0, 6) * res;
  params.heightOffset = uniform(rng, 0, chance(rng, 50) ? 4 : 30) * res;
  params.safetyRadius =
      chance(rng, 30) ? 0.5 * pick(rng, 1, 6) * res : uniform(rng, 0.1, 3.5) * res;
  params.unknownIsPassable = chance(rng, 50);
  conversion.minClearance = params.safetyRadius * (chance(rng, 30) ? 2 : uniform(rng, 2, 4));
}

/** The ground of a cell whose floor is known: where it begins, elsewhere, or not known. */
void setRandomGround(Rng& rng, double res, freespace::Layers& layers, std::size_t cell)
{
  using namespace freespace;
  const float floor = layers.floor.cells()[cell];
  const int kind = pick(rng, 0, 9);
  const bool inferred = kind > 6;
  if (kind == 0)
    layers.evidence.cells()[cell] = evidence::kOpen;
  else
    layers.evidence.cells()[cell] = inferred ? evidence::kInferred : evidence::kSeen;
  if (kind > 0)
    layers.support.cells()[cell] =
        inferred ? floor + static_cast<float>(uniform(rng, -6, 3) * res) : floor;
}

/** Floors and ceilings of any height, with holes and walls. */
freespace::Layers randomLayers(Rng& rng, double res)
{
  const grid::GridFrame frame{res, pick(rng, -40, 40), pick(rng, -40, 40), pick(rng, 1, 25),
                              pick(rng, 1, 25)};
  freespace::Layers layers(frame);
  const int holes = chance(rng, 40) ? 0 : pick(rng, 0, 6), walls = pick(rng, 0, 100);
  const double rough = uniform(rng, 0, 8) * res, room = uniform(rng, 1, 12) * res;
  for (std::size_t cell = 0; cell < frame.size(); ++cell)
    if (chance(rng, holes))
      layers.aerial.cells()[cell] = chance(rng, walls) ? 0.7f : grid::kUnknown;
    else
    {
      layers.aerial.cells()[cell] = grid::kFree;
      layers.floor.cells()[cell] = static_cast<float>(uniform(rng, -rough, rough));
      layers.ceiling.cells()[cell] =
          layers.floor.cells()[cell] + static_cast<float>(room + uniform(rng, 0, 10 * res));
      setRandomGround(rng, res, layers, cell);
    }
  return layers;
}

/** The input's points must be there, in order, with evenly spaced ones between, at most a cell
 * apart. */
void expectDensified(const std::vector<TPoint2D>& input, const std::vector<LiftedPoint>& dense,
                     double res)
{
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < dense.size(); ++i)
    if (dense[i].isInput) at.push_back(i);
  ASSERT_EQ(at.size(), input.size());
  if (input.empty()) return;
  EXPECT_EQ(at.front(), 0u);
  EXPECT_EQ(at.back(), dense.size() - 1);
  for (std::size_t k = 0; k < input.size(); ++k)
  {
    EXPECT_EQ(dense[at[k]].position.x, input[k].x);
    EXPECT_EQ(dense[at[k]].position.y, input[k].y);
    if (k == 0) continue;
    const TPoint2D from = input[k - 1], way = input[k] - from;
    const auto steps = static_cast<double>(at[k] - at[k - 1]);
    EXPECT_LE(way.norm(), steps * res * (1 + 1.001e-9));
    EXPECT_TRUE(steps == 1 || way.norm() > (steps - 1) * res) << "more points than needed";
    for (std::size_t i = at[k - 1]; i < at[k]; ++i)
    {
      const double share = static_cast<double>(i - at[k - 1]) / steps;
      EXPECT_NEAR(dense[i].position.x, from.x + share * way.x, 1e-9 * res);
      EXPECT_NEAR(dense[i].position.y, from.y + share * way.y, 1e-9 * res);
    }
  }
}

void expectSame(const LiftedPoint& ours, const LiftedPoint& expected)
{
  EXPECT_EQ(ours.problem, expected.problem);
  EXPECT_EQ(ours.rule, expected.rule);
  EXPECT_EQ(std::isnan(ours.position.z), std::isnan(expected.position.z));
  if (!std::isnan(expected.position.z))
  {
    // heights that differ by less count as one, see liftPath()
    EXPECT_NEAR(ours.position.z, expected.position.z, 1.001e-5);
  }
}

/** What a point that can be reached promises, whichever height was taken. */
void expectSphereIsClear(const LiftedPoint& point, const oracle::LiftOracle& oracle,
                         bool unknownIsPassable)
{
  for (const oracle::CellDemand& demand : oracle.demands(point.position.x, point.position.y))
  {
    const bool passable = demand.runs.empty() && unknownIsPassable && !demand.occupied;
    EXPECT_TRUE(passable || oracle::LiftOracle::satisfied(demand, point.position.z))
        << "z " << point.position.z << ", cell at " << demand.centre.asString();
  }
}

/** What a point stopped by a cell names must be the nearest of its kind. */
void expectNearestObstacle(const LiftedPoint& point, const oracle::LiftOracle& oracle)
{
  double nearest = 1e9, named = 1e9;
  for (const oracle::CellDemand& demand : oracle.demands(point.position.x, point.position.y))
  {
    if (!demand.runs.empty() || demand.occupied != (point.problem == Infeasibility::Wall)) continue;
    nearest = std::min(nearest, demand.distance);
    if ((demand.centre - point.obstacle).norm() < 1e-9) named = demand.distance;
  }
  EXPECT_NEAR(named, nearest, 1e-7);  // squares were compared: half of the digits
}

void compare(const std::vector<TPoint2D>& input, const freespace::Layers& layers,
             const freespace::ConversionParams& conversion, const path::LiftParams& params,
             const voxel::VoxelSource* voxels, const oracle::DenseMap* dense, Seen& seen)
{
  const path::LiftedPath lifted = path::liftPath(input, layers, conversion, params, voxels);
  const bool aerial = params.robot == freespace::Robot::Aerial;
  EXPECT_EQ(lifted.slabsChecked, aerial && voxels != nullptr);
  expectDensified(input, lifted.points, layers.frame().resolution);
  const oracle::LiftOracle oracle(layers, conversion, params, dense);
  const std::vector<LiftedPoint> expected = oracle.lift(lifted.points);
  bool feasible = true;
  for (std::size_t i = 0; i < expected.size() && !testing::Test::HasFailure(); ++i)
  {
    const LiftedPoint& point = lifted.points[i];
    SCOPED_TRACE("point " + std::to_string(i) + " of " + std::to_string(expected.size()) + ", " +
                 point.position.asString());
    expectSame(point, expected[i]);
    EXPECT_EQ(lifted.describeProblem(i).empty(), point.problem == Infeasibility::None);
    if (aerial && point.problem == Infeasibility::None)
      expectSphereIsClear(point, oracle, params.unknownIsPassable);
    if (point.problem == Infeasibility::Wall || point.problem == Infeasibility::Unknown)
      expectNearestObstacle(point, oracle);
    ++seen.rules[point.rule];
    ++seen.problems[point.problem];
    if (feasible && point.problem != Infeasibility::None)
    {
      feasible = false;
      EXPECT_EQ(lifted.firstProblem(), i);
    }
  }
  EXPECT_EQ(lifted.feasible(), feasible);
  // parts of a way that only touch a cell are left out
  const double inferred = aerial ? 0 : oracle.inferredLength(lifted.points);
  EXPECT_NEAR(lifted.inferredLength, inferred,
              1e-5 * layers.frame().resolution * static_cast<double>(lifted.points.size()));
  seen.inferred += inferred > 0;
}

TEST(LiftPath, AgreesWithTheOracleOnRandomHeights)
{
  Seen seen;
  for (unsigned seed = 1; seed <= 600 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const double res = kResolutions[seed % 5];
    freespace::ConversionParams conversion;
    path::LiftParams params;
    randomParams(rng, res, conversion, params);
    const freespace::Layers layers = randomLayers(rng, res);
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int i = 0; i < 4; ++i)
      compare(randomPath(rng, layers.frame()), layers, conversion, params, nullptr, nullptr, seen);
  }
  for (const HeightRule rule :
       {HeightRule::FloorAhead, HeightRule::SphereFloor, HeightRule::SphereCeiling})
    EXPECT_GT(seen.rules[rule], 500) << "rule " << static_cast<int>(rule);
  EXPECT_EQ(seen.rules[HeightRule::SphereSlab], 0) << "the layers show no slabs";
  for (const Infeasibility problem :
       {Infeasibility::OffMap, Infeasibility::NoFloor, Infeasibility::UnseenGround,
        Infeasibility::Wall, Infeasibility::Unknown, Infeasibility::NoHeight})
    EXPECT_GT(seen.problems[problem], 100) << "problem " << static_cast<int>(problem);
  EXPECT_GT(seen.inferred, 100);
}

/** A few storeys of different heights in every column, hardly a wall: slabs are what matters. */
oracle::DenseMap randomStoreys(Rng& rng)
{
  oracle::DenseMap map;
  map.x0 = pick(rng, -70, 40), map.y0 = pick(rng, -70, 40), map.z0 = pick(rng, -40, 10);
  map.nx = pick(rng, 1, 40), map.ny = pick(rng, 1, 40), map.nz = pick(rng, 20, 90);
  map.voxels.assign(static_cast<std::size_t>(map.nx * map.ny * map.nz), oracle::Voxel::Free);
  const int floors = pick(rng, 0, 3), bumps = pick(rng, 0, 3), gaps = pick(rng, 0, 100);
  for (int floor = 0; floor < floors; ++floor)
  {
    const int height = pick(rng, 0, map.nz - 1), thickness = pick(rng, 1, 3);
    for (int iy = 0; iy < map.ny; ++iy)
      for (int ix = 0; ix < map.nx; ++ix)
      {
        if (chance(rng, gaps)) continue;
        const int begin = height + pick(rng, -bumps, bumps);
        const auto state = chance(rng, 80) ? oracle::Voxel::Occupied : oracle::Voxel::Unknown;
        for (int iz = std::max(0, begin); iz < std::min(map.nz, begin + thickness); ++iz)
          map.at(ix, iy, iz) = state;
      }
  }
  return map;
}

TEST(LiftPath, AgreesWithTheOracleOnRandomVoxelMaps)
{
  Seen seen;
  for (unsigned seed = 1; seed <= 400 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const double res = kResolutions[seed % 5];
    octomap::OcTree tree(res);
    if (chance(rng, 70))
      fillTree(rng, randomStoreys(rng), false, tree);
    else
      randomTree(rng, randomShape(rng), tree);
    const voxel::OctreeSource<octomap::OcTree> source(tree);
    const oracle::DenseMap dense = oracle::denseMap(tree);
    freespace::ConversionParams conversion;
    path::LiftParams params;
    randomParams(rng, res, conversion, params);
    const freespace::Layers layers = freespace::convert(source, conversion, 1);
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int i = 0; i < 4; ++i)
      compare(randomPath(rng, layers.frame()), layers, conversion, params, &source, &dense, seen);
  }
  for (const HeightRule rule : {HeightRule::FloorAhead, HeightRule::SphereFloor,
                                HeightRule::SphereCeiling, HeightRule::SphereSlab})
    EXPECT_GT(seen.rules[rule], 300) << "rule " << static_cast<int>(rule);
  for (const Infeasibility problem :
       {Infeasibility::OffMap, Infeasibility::NoFloor, Infeasibility::Wall, Infeasibility::Unknown,
        Infeasibility::NoHeight})
    EXPECT_GT(seen.problems[problem], 50) << "problem " << static_cast<int>(problem);
}

TEST(LiftPath, AgreesWithTheOracleOnGroundThatIsInferred)
{
  Seen seen;
  int floating = 0, buried = 0;
  for (unsigned seed = 1; seed <= 300 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const double res = kResolutions[seed % 5];
    const oracle::DenseMap dense = randomGround(rng, res);
    const DenseSource source(dense);
    freespace::ConversionParams conversion = randomGroundParams(rng, res);
    conversion.reading = {};  // the oracle takes the map as it is
    path::LiftParams params;
    params.robot = chance(rng, 80) ? freespace::Robot::Ground : freespace::Robot::Aerial;
    params.lookahead = uniform(rng, 0, 6) * res;
    params.heightOffset = uniform(rng, 0, 4) * res;
    params.safetyRadius = conversion.minClearance * uniform(rng, 0.1, 0.5);
    const freespace::Layers layers = freespace::convert(source, conversion, 1);
    for (std::size_t cell = 0; cell < layers.frame().size(); ++cell)
    {
      floating += layers.support.cells()[cell] > layers.floor.cells()[cell];
      buried += layers.support.cells()[cell] < layers.floor.cells()[cell];
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (int i = 0; i < 4; ++i)
      compare(randomPath(rng, layers.frame()), layers, conversion, params, &source, &dense, seen);
  }
  EXPECT_GT(floating, 1000);
  EXPECT_GT(buried, 1000);
  EXPECT_GT(seen.inferred, 100);
  EXPECT_GT(seen.problems[Infeasibility::UnseenGround], 1000);
}

}  // namespace
