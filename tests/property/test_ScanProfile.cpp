// The inverse sensor model against its brute-force twin, and what must not change it.
#include <gtest/gtest.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "RandomScan.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using mrpt::poses::CPose3D;
using oracle::CellKeys;
using scan::Model;
using scan::ScanProfile;

/** What a profile says, to be compared. */
struct Cells
{
  CellKeys occupied, free;

  bool operator==(const Cells& o) const { return occupied == o.occupied && free == o.free; }
};

Cells cellsOf(const ScanProfile& profile)
{
  return {keysOf(profile.occupied()), keysOf(profile.free())};
}

Cells compute(ScanProfile& profile, const RandomScan& scan)
{
  profile.compute(scan.points, scan.view, scan.resolution, scan.params);
  return cellsOf(profile);
}

Cells computeAfresh(const RandomScan& scan)
{
  ScanProfile profile;
  return compute(profile, scan);
}

/** The first cells that only one of two sets has, from the sensor's cell. */
std::string difference(const CellKeys& ours, const CellKeys& expected, const RandomScan& scan)
{
  std::ostringstream out;
  const auto list = [&](const char* name, const CellKeys& a, const CellKeys& b)
  {
    int count = 0;
    for (const auto& [kx, ky] : a)
      if (b.count({kx, ky}) == 0 && ++count <= 5)
        out << name << " (" << kx - std::floor(scan.view.sensorPose.x() / scan.resolution) << ", "
            << ky - std::floor(scan.view.sensorPose.y() / scan.resolution) << ") from the sensor; ";
    if (count > 5) out << name << " " << count << " in all; ";
  };
  list("wrong", ours, expected);
  list("missing", expected, ours);
  return out.str();
}

/** How much of the model random scans have put to the test. */
struct Seen
{
  int scans = 0, ties = 0;
  std::size_t occupied = 0, free = 0, cut = 0;
  int linesWithWall = 0, linesWithout = 0;
};

/** The smallest box around all cells. */
grid::GridFrame boxOf(const Cells& cells, double resolution)
{
  grid::GridFrame box;
  for (const CellKeys* keys : {&cells.occupied, &cells.free})
    for (const auto& [kx, ky] : *keys) box = unite(box, {resolution, kx, ky, 1, 1});
  return box;
}

void expectSame(const ScanProfile& profile, const oracle::ScanCells& expected,
                const RandomScan& scan)
{
  const Cells ours = cellsOf(profile);
  EXPECT_TRUE(ours.occupied == expected.occupied)
      << "occupied: " << difference(ours.occupied, expected.occupied, scan);
  EXPECT_TRUE(ours.free == expected.free) << "free: " << difference(ours.free, expected.free, scan);
  const scan::ProfileStatistics& statistics = profile.statistics();
  EXPECT_EQ(statistics.lines, expected.lines);
  EXPECT_EQ(statistics.linesWithWall, expected.linesWithWall);
  EXPECT_EQ(statistics.occupiedCells, expected.occupied.size());
  EXPECT_EQ(statistics.freeCells, expected.free.size());
  const grid::GridFrame box = boxOf(ours, scan.resolution), bounds = profile.bounds();
  EXPECT_EQ(bounds.empty(), box.empty());
  if (!box.empty())
  {
    EXPECT_TRUE(bounds == box);
  }
}

void compare(ScanProfile& profile, const RandomScan& scan, Seen& seen)
{
  const oracle::ScanOracle oracle(scan.points, scan.view, scan.resolution, scan.params);
  const oracle::ScanCells expected = oracle.profile();
  ++seen.scans;
  if (expected.tie)
  {
    ++seen.ties;
    return;
  }
  profile.compute(scan.points, scan.view, scan.resolution, scan.params);
  expectSame(profile, expected, scan);
  seen.occupied += expected.occupied.size();
  seen.free += expected.free.size();
  seen.cut += oracle.objectCells().size() - expected.occupied.size();
  seen.linesWithWall += expected.linesWithWall;
  seen.linesWithout += expected.lines - expected.linesWithWall;
}

void compareMany(Model model, bool filter, Lines lines, unsigned firstSeed)
{
  Seen seen;
  ScanProfile profile;  // for all of them: nothing of one scan may be left in the next
  for (unsigned seed = firstSeed; seed < firstSeed + 400 && !testing::Test::HasFailure(); ++seed)
  {
    Rng rng(seed);
    const RandomScan scan = randomScan(rng, model, filter, lines);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.text());
    compare(profile, scan, seen);
  }
  if (testing::Test::HasFailure()) return;
  EXPECT_LT(seen.ties, seen.scans / 20);
  EXPECT_GT(seen.occupied, 500u);
  EXPECT_GT(seen.free, 200u);
  EXPECT_GT(seen.linesWithout, 300);
  if (!filter)
    EXPECT_EQ(seen.linesWithWall, 0);
  else
  {
    EXPECT_GT(seen.linesWithWall, 300);
    EXPECT_GT(seen.cut, 500u);
  }
}

TEST(ScanProfile, AgreesWithTheOracleOnSmallScans)
{
  unsigned firstSeed = 1;
  for (const Model model : {Model::WholeShape, Model::ClosestPoint})
    for (const bool filter : {true, false})
      for (const Lines lines : {Lines::Default, Lines::Few, Lines::Odd, Lines::Fours, Lines::Many})
      {
        compareMany(model, filter, lines, firstSeed);
        firstSeed += 1000;
      }
}

/** A sensor none of whose lines passes by a corner so closely that rounding decides. */
scan::Viewpoint clearViewpoint(Rng& rng, double resolution, const scan::ProfileParams& params)
{
  scan::ProfileParams lines = params;  // no more than the lines, to beyond any cell
  lines.reflectionFilter = false;
  lines.sectors = oracle::ScanOracle::lineCount(resolution, params);
  lines.maxRange = 1.1 * params.maxRange;
  while (true)
  {
    const scan::Viewpoint view = randomViewpoint(rng, resolution, params);
    scan::Viewpoint level;
    level.sensorPose = CPose3D(view.sensorPose.x(), view.sensorPose.y(), 0.5, 0, 0, 0);
    const auto end = static_cast<float>(1.05 * params.maxRange);
    if (!oracle::ScanOracle({{end, 0, 0}}, level, resolution, lines).profile().tie) return view;
  }
}

/** Places of 20 m and a few thousand points. */
RandomScan bigScan(Rng& rng, Model model, bool filter, Lines lines)
{
  RandomScan scan;
  scan.resolution = 0.05;
  scan.params = randomParams(rng, scan.resolution, model, filter, lines);
  scan.params.minRange = 0.3;
  scan.params.maxRange = 20;
  scan.view = clearViewpoint(rng, scan.resolution, scan.params);
  for (const int radius : {400, 100, 30})
    for (const auto& point : randomPoints(rng, scan.view, scan.resolution, scan.params, radius))
      if (point.norm() < 20.9) scan.points.push_back(point);
  return scan;
}

TEST(ScanProfile, AgreesWithTheOracleOnBigScans)
{
  Seen seen;
  ScanProfile profile;
  std::size_t points = 0;
  constexpr Lines kLines[] = {Lines::Default, Lines::Odd, Lines::Many};
  for (unsigned seed = 1; seed <= 12 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    const RandomScan scan = bigScan(rng, seed % 4 == 0 ? Model::ClosestPoint : Model::WholeShape,
                                    seed % 5 != 0, kLines[seed % 3]);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.text());
    compare(profile, scan, seen);
    points += scan.points.size();
  }
  EXPECT_GE(seen.scans - seen.ties, 6);
  EXPECT_GT(points, 12 * 2000u);
}

/** All sorts of scans; a number of lines that is divisible by 4 if wanted. */
RandomScan anyScan(unsigned seed, bool fours)
{
  constexpr Lines kAny[] = {Lines::Default, Lines::Fours, Lines::Few, Lines::Odd, Lines::Many};
  Rng rng(seed);
  const Lines lines = kAny[pick(rng, 0, fours ? 1 : 4)];
  const Model model = chance(rng, 60) ? Model::WholeShape : Model::ClosestPoint;
  return randomScan(rng, model, chance(rng, 75), lines);
}

bool isTie(const RandomScan& scan)
{
  return oracle::ScanOracle(scan.points, scan.view, scan.resolution, scan.params).profile().tie;
}

CellKeys shifted(const CellKeys& cells, int dx, int dy)
{
  CellKeys result;
  for (const auto& [kx, ky] : cells) result.emplace(kx + dx, ky + dy);
  return result;
}

TEST(ScanProfile, IsTheSameWhenTheWorldIsMovedByWholeCells)
{
  for (unsigned seed = 1; seed <= 300 && !HasFailure(); ++seed)
  {
    RandomScan scan = anyScan(seed, false);
    if (isTie(scan)) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.text());
    const Cells there = computeAfresh(scan);
    Rng rng(seed);
    const int dx = pick(rng, -3000, 3000), dy = pick(rng, -3000, 3000);
    const double dz = uniform(rng, -5, 5);
    scan.view.baseZ += dz;
    scan.view.sensorPose.x_incr(dx * scan.resolution);
    scan.view.sensorPose.y_incr(dy * scan.resolution);
    scan.view.sensorPose.z_incr(dz);
    const Cells here = computeAfresh(scan);
    EXPECT_TRUE(here.occupied == shifted(there.occupied, dx, dy));
    EXPECT_TRUE(here.free == shifted(there.free, dx, dy));
  }
}

/** Turned about the origin by a quarter of a circle. */
CellKeys turned(const CellKeys& cells)
{
  CellKeys result;
  for (const auto& [kx, ky] : cells) result.emplace(-ky - 1, kx);
  return result;
}

TEST(ScanProfile, TurnsWithTheWorldByRightAngles)
{
  const CPose3D quarter(0, 0, 0, std::acos(-1.0) / 2, 0, 0);
  for (unsigned seed = 1; seed <= 300 && !HasFailure(); ++seed)
  {
    RandomScan scan = anyScan(seed, true);
    if (isTie(scan)) continue;
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.text());
    Cells expected = computeAfresh(scan);
    for (int quarters = 1; quarters <= 3; ++quarters)
    {
      scan.view.sensorPose = quarter + scan.view.sensorPose;
      expected = {turned(expected.occupied), turned(expected.free)};
      EXPECT_TRUE(computeAfresh(scan) == expected) << "after " << quarters * 90 << " degrees";
    }
  }
}

TEST(ScanProfile, KeepsNothingOfTheScanBefore)
{
  ScanProfile reused;
  for (unsigned seed = 1; seed <= 300 && !HasFailure(); ++seed)
  {
    const RandomScan scan = anyScan(seed, false);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.text());
    EXPECT_TRUE(compute(reused, scan) == computeAfresh(scan));
  }
}

TEST(ScanProfile, DoesNotDependOnTheOrderOfPoints)
{
  for (unsigned seed = 1; seed <= 100 && !HasFailure(); ++seed)
  {
    RandomScan scan = anyScan(seed, false);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.text());
    const Cells expected = computeAfresh(scan);
    std::reverse(scan.points.begin(), scan.points.end());
    EXPECT_TRUE(computeAfresh(scan) == expected);
    scan.points.insert(scan.points.end(), scan.points.begin(), scan.points.end());
    EXPECT_TRUE(computeAfresh(scan) == expected) << "each point twice";
  }
}

/** A grid that holds all random scans of one resolution. */
struct Grid
{
  grid::GridFrame frame;
  std::vector<std::int8_t> cells;

  explicit Grid(double resolution) : frame{resolution, -200, -200, 400, 400}, cells(frame.size(), 0)
  {
  }
  void insert(const ScanProfile& profile, const scan::LogOddsUpdate& update)
  {
    update.apply(profile, frame, cells.data());
  }
};

/** Scans of one map: the same resolution and parameters, different places. */
std::vector<RandomScan> scansOfOneMap(unsigned seed, int count)
{
  Rng rng(seed);
  std::vector<RandomScan> scans;
  scans.push_back(randomScan(rng, chance(rng, 60) ? Model::WholeShape : Model::ClosestPoint,
                             chance(rng, 75), Lines::Default));
  while (static_cast<int>(scans.size()) < count)
  {
    RandomScan next = scans.front();
    next.view = randomViewpoint(rng, next.resolution, next.params);
    next.points = randomPoints(rng, next.view, next.resolution, next.params, pick(rng, 2, 12));
    scans.push_back(std::move(next));
  }
  return scans;
}

Grid gridOf(const std::vector<RandomScan>& scans, const scan::LogOddsUpdate& update)
{
  Grid grid(scans.front().resolution);
  ScanProfile profile;
  for (const RandomScan& scan : scans)
  {
    profile.compute(scan.points, scan.view, scan.resolution, scan.params);
    grid.insert(profile, update);
  }
  return grid;
}

TEST(ScanProfile, AnotherOrderOfScansGivesTheSameGrid)
{
  scan::UpdateParams params;
  params.pHit = 0.5156, params.pMiss = 0.4844;
  const scan::LogOddsUpdate update(params);
  ASSERT_EQ(update.hit(), 1);
  ASSERT_EQ(update.miss(), 1);
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::vector<RandomScan> scans = scansOfOneMap(seed, 50);
    const Grid inOrder = gridOf(scans, update);
    EXPECT_GT(std::count_if(inOrder.cells.begin(), inOrder.cells.end(), [](int c) { return c; }),
              100);
    Rng rng(seed);
    for (std::size_t i = scans.size() - 1; i > 0; --i)
      std::swap(scans[i], scans[static_cast<std::size_t>(pick(rng, 0, static_cast<int>(i)))]);
    EXPECT_TRUE(gridOf(scans, update).cells == inOrder.cells);
  }
}

TEST(ScanProfile, EveryCellChangesAtMostOncePerScan)
{
  const scan::LogOddsUpdate update;
  ScanProfile profile;
  for (unsigned seed = 1; seed <= 100 && !HasFailure(); ++seed)
  {
    const RandomScan scan = anyScan(seed, false);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scan.text());
    const Cells cells = compute(profile, scan);
    Grid grid(scan.resolution);
    grid.insert(profile, update);
    for (int ky = grid.frame.y0; ky < grid.frame.yEnd(); ++ky)
      for (int kx = grid.frame.x0; kx < grid.frame.xEnd(); ++kx)
      {
        const int expected = cells.occupied.count({kx, ky}) != 0 ? -update.hit()
                             : cells.free.count({kx, ky}) != 0   ? update.miss()
                                                                 : 0;
        ASSERT_EQ(grid.cells[grid.frame.indexOfKey(kx, ky)], expected)
            << "cell (" << kx << ", " << ky << ")";
      }
  }
}

}  // namespace
