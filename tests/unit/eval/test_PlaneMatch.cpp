#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/PlaneMatch.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;
using eval::Agreement;

namespace
{
Layer<std::int32_t> planes(std::vector<std::int32_t> cells)
{
  Layer<std::int32_t> layer(GridFrame{0.5, 0, 0, static_cast<std::int32_t>(cells.size()), 1}, -1);
  layer.cells() = std::move(cells);
  return layer;
}

constexpr float N = NAN;

/** All cells are known. */
Agreement matched(const std::vector<float>& map, const std::vector<std::int32_t>& truth,
                  std::size_t minCells = 2)
{
  return eval::matchPlanes(row(map), row(std::vector<float>(map.size(), 0)), planes(truth),
                           {0.8, minCells});
}

void expect(const Agreement& a, std::size_t right, std::size_t wrong, std::size_t found,
            std::size_t missed)
{
  EXPECT_EQ(a.right, right);
  EXPECT_EQ(a.wrong, wrong);
  EXPECT_EQ(a.found, found);
  EXPECT_EQ(a.missed, missed);
}
}  // namespace

TEST(PlaneMatch, EqualPlanesAreFound)
{
  const Agreement match = matched({7, 7, 7, 3, 3}, {0, 0, 0, 1, 1});
  expect(match, 2, 0, 2, 0);
  EXPECT_EQ(match.precision(), 1);
  EXPECT_EQ(match.recall(), 1);
}

TEST(PlaneMatch, FourFifthsOfEitherAreEnough)
{
  // of five cells one has no plane, and one belongs to the wrong one
  expect(matched({0, 0, 0, 0, N}, {0, 0, 0, 0, 0}), 1, 0, 1, 0);
  expect(matched({0, 0, 0, N, N}, {0, 0, 0, 0, 0}), 0, 1, 0, 1);
  // the map's plane has five cells, of which the true one has four, and then three
  expect(matched({0, 0, 0, 0, 0}, {0, 0, 0, 0, 1}, 2), 1, 0, 1, 0);
  expect(matched({0, 0, 0, 0, 0}, {0, 0, 0, 1, 1}, 2), 0, 1, 0, 2);
}

TEST(PlaneMatch, ASplitPlaneIsMissedAndBothHalvesAreWrong)
{
  expect(matched({0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 0, 0}), 0, 2, 0, 1);
}

TEST(PlaneMatch, SmallPlanesAreNotCounted)
{
  expect(matched({0, 0, 0, 1}, {0, 0, 0, 1}, 2), 1, 0, 1, 0);
  expect(matched({0, 0, 0, 1}, {0, 0, 0, 1}, 4), 0, 0, 0, 0);
  // four true cells count, but of the map's plane only three are among them
  expect(matched({0, 0, 0, 0, N}, {0, 0, 0, 0, 0}, 5), 0, 0, 1, 0);
}

TEST(PlaneMatch, OnlyKnownCellsWithATruePlaneAreJudged)
{
  const std::vector<float> map = {0, 0, N, N, 1, 1, 1};
  const std::vector<std::int32_t> truth = {0, 0, 0, 0, -1, -1, -1};
  expect(matched(map, truth), 0, 1, 0, 1);
  const auto heights = row({0, 0, N, N, 0, 0, 0});
  expect(eval::matchPlanes(row(map), heights, planes(truth), {0.8, 2}), 1, 0, 1, 0);
}

TEST(PlaneMatch, LayersMayHaveTheirOwnFrames)
{
  const auto map = row({0, 0, 0}, 1), heights = row({0, 0, 0}, 1);
  expect(eval::matchPlanes(map, heights, planes({0, 0, 0, 0}), {0.8, 2}), 1, 0, 1, 0);
}

TEST(PlaneMatch, HalfOfAPlaneIsNoOverlap)
{
  for (const double overlap : {0.5, 1.01, std::nan("")})
    EXPECT_THROW(eval::matchPlanes(row({0}), row({0}), planes({0}), {overlap, 1}),
                 std::invalid_argument)
        << overlap;
}
