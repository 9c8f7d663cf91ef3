#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>

#include <limits>
#include <stdexcept>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using test::expectCells;
using test::HandMap;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/** Four columns from z key -2 upwards: at 0.25 m from -0.5 m to 1 m. */
void expectProjection(double zMin, double zMax, const std::vector<float>& row)
{
  SCOPED_TRACE("z from " + std::to_string(zMin) + " to " + std::to_string(zMax));
  HandMap map(0.25);
  map.column(0, 0, -2, "ffffff");
  map.column(1, 0, -2, "ff#fff");
  map.column(2, 0, -2, "#....f");
  map.column(3, 0, -2, ".....#");
  expectCells(freespace::projectFixed(map.source(), zMin, zMax, 1), {row});
}

TEST(FixedProjection, WholeHeight)
{
  expectProjection(-kInfinity, kInfinity, {0, 1, 1, 1});
  expectProjection(-100, 100, {0, 1, 1, 1});
}

TEST(FixedProjection, OccupiedBeatsFreeBeatsUnknown)
{
  // voxels -2 and -1: the occupied voxel of the second column is out of reach
  expectProjection(-0.5, 0, {0, 0, 1, -1});
  expectProjection(0, 1, {0, 1, 0, 1});
  expectProjection(0.25, 0.75, {0, 0, -1, -1});
}

TEST(FixedProjection, VoxelsThatOnlyTouchTheIntervalDoNotCount)
{
  // voxel 0, [0, 0.25) m, is the second column's occupied one
  expectProjection(0.25, 0.5, {0, 0, -1, -1});
  expectProjection(-0.25, 0, {0, 0, -1, -1});
}

TEST(FixedProjection, VoxelsThatReachIntoTheIntervalCount)
{
  expectProjection(0.2, 0.5, {0, 1, -1, -1});
  expectProjection(-0.25, 0.01, {0, 1, -1, -1});
  expectProjection(0.1, 0.15, {0, 1, -1, -1});  // an interval inside the voxel
}

TEST(FixedProjection, HalfInfiniteIntervals)
{
  expectProjection(-kInfinity, -0.25, {0, 0, 1, -1});
  expectProjection(0.75, kInfinity, {0, 0, 0, 1});
}

TEST(FixedProjection, AboveAndBelowTheMapNothingIsKnown)
{
  expectProjection(1, 2, {-1, -1, -1, -1});
  expectProjection(-3, -0.5, {-1, -1, -1, -1});
  expectProjection(1e6, 1e9, {-1, -1, -1, -1});
}

TEST(FixedProjection, HeightsNamedInDecimalsLieOnFaces)
{
  HandMap map(0.1);
  map.column(0, 0, 0, "ff#f#");
  // 3·0.1 is a little more than 0.3 in double: voxel 2 must not reach over its top face
  expectCells(freespace::projectFixed(map.source(), 0.3, 0.4, 1), {{0}});
  expectCells(freespace::projectFixed(map.source(), 0.0, 0.2, 1), {{0}});

  // 2.1/0.3 is a little more than 7 in double: voxel 7 must not be reached from below
  HandMap coarse(0.3);
  coarse.column(0, 0, 6, "f#");
  expectCells(freespace::projectFixed(coarse.source(), 0.3, 2.1, 1), {{0}});
}

TEST(FixedProjection, LiesOnTheBoundingBoxOfAllKnownVoxels)
{
  HandMap map(0.1);
  map.free(-3, 5, 0, 1).occupied(0, 6, 90, 91);
  const grid::Layer<float> layer = freespace::projectFixed(map.source(), 0, 1, 1);
  EXPECT_EQ(layer.frame(), (grid::GridFrame{0.1, -3, 5, 4, 2}));
  expectCells(layer, {{-1, -1, -1, -1}, {0, -1, -1, -1}});
}

TEST(FixedProjection, BadIntervalsAreErrors)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  HandMap map(0.1);
  map.free(0, 0, 0, 1);
  EXPECT_THROW(freespace::projectFixed(map.source(), 1, 1), std::invalid_argument);
  EXPECT_THROW(freespace::projectFixed(map.source(), 2, 1), std::invalid_argument);
  EXPECT_THROW(freespace::projectFixed(map.source(), nan, 1), std::invalid_argument);
  EXPECT_THROW(freespace::projectFixed(map.source(), 0, nan), std::invalid_argument);
}

TEST(FixedProjection, AMapWithoutKnownVoxelsIsAnError)
{
  const HandMap map(0.1);
  EXPECT_THROW(freespace::projectFixed(map.source(), 0, 1), std::runtime_error);
}

}  // namespace
