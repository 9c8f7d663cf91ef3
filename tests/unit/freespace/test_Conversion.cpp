// Frame, voxel states, free ranges, floor and ceiling; errors and warnings of a whole conversion.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include <limits>
#include <stdexcept>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::ConversionParams;
using freespace::Layers;
using test::expectCells;
using test::HandMap;
using test::kNaN;

ConversionParams withClearance(double minClearance)
{
  auto params = ConversionParams::paper();
  params.minClearance = minClearance;
  return params;
}

// ---- frame

TEST(ConversionFrame, IsTheBoundingBoxOfAllKnownVoxels)
{
  HandMap map(0.1);
  map.free(-2, 7, 0, 1).occupied(2, 3, 500, 501);
  const grid::GridFrame frame = freespace::frameOf(map.source());
  EXPECT_EQ(frame.x0, -2);
  EXPECT_EQ(frame.y0, 3);
  EXPECT_EQ(frame.width, 5);
  EXPECT_EQ(frame.height, 5);
  EXPECT_EQ(frame.resolution, 0.1);
  const Layers layers = map.convert(ConversionParams::paper());
  for (const auto& [name, layer] : layers.named()) EXPECT_EQ(layer->frame(), frame) << name;
}

TEST(ConversionFrame, CellEdgesLieOnVoxelFaces)
{
  HandMap map(0.08);
  map.free(-25, 0, 0, 1).free(99, 49, 0, 1);
  const grid::GridFrame frame = freespace::frameOf(map.source());
  EXPECT_DOUBLE_EQ(frame.xMin(), -2.0);
  EXPECT_DOUBLE_EQ(frame.xMax(), 8.0);
  EXPECT_DOUBLE_EQ(frame.yMin(), 0.0);
  EXPECT_DOUBLE_EQ(frame.yMax(), 4.0);
}

TEST(ConversionFrame, ACellPerFinestVoxelOfAPrunedLeaf)
{
  HandMap map(0.1);
  for (int ky = 4; ky < 8; ++ky)
    for (int kx = -4; kx < 0; ++kx) map.free(kx, ky, 8, 12);
  ASSERT_EQ(map.tree().getNumLeafNodes(), 1u) << "the cube was meant to become one leaf";
  const Layers layers = map.convert(withClearance(0.4));
  EXPECT_EQ(layers.frame(), (grid::GridFrame{0.1, -4, 4, 4, 4}));
  const std::vector<float> bottom(4, 0.8f), top(4, 1.2f);
  expectCells(layers.floor, {bottom, bottom, bottom, bottom});
  expectCells(layers.ceiling, {top, top, top, top});
}

// ---- voxel states

TEST(ConversionStates, ALeafOnTheThresholdIsOccupied)
{
  HandMap map(0.1);
  for (int kz = 0; kz < 3; ++kz)
  {
    map.tree().setNodeValue(HandMap::key(0, 0, kz), 0.0f);  // p = 0.5, OctoMap's threshold
    map.tree().setNodeValue(HandMap::key(1, 0, kz), -0.01f);
  }
  expectCells(map.convert(withClearance(0.3)).aerial, {{1, 0}});
}

TEST(ConversionStates, TheTreesOwnThresholdDecides)
{
  HandMap map(0.1);
  map.tree().setOccupancyThres(0.8);  // log-odds 1.39
  for (int kz = 0; kz < 3; ++kz)
  {
    map.tree().setNodeValue(HandMap::key(0, 0, kz), 1.3f);
    map.tree().setNodeValue(HandMap::key(1, 0, kz), 1.5f);
  }
  expectCells(map.convert(withClearance(0.3)).aerial, {{0, 1}});
}

TEST(ConversionStates, MissingLeavesAreNeitherFreeNorOccupied)
{
  HandMap map(0.1);
  map.column(0, 0, 0, "fff");
  map.column(1, 0, 0, "..........#");  // only keeps the column known
  map.column(2, 0, 0, "f.f");
  const Layers layers = map.convert(withClearance(0.3));
  expectCells(layers.aerial, {{0, -1, -1}});
  expectCells(layers.floor, {{0, kNaN, kNaN}});
}

TEST(ConversionStates, InnerNodesNeverCount)
{
  HandMap map(0.1);
  // lazy insertion leaves inner nodes with log-odds 0, which the tree would call occupied
  for (int kz = 0; kz < 3; ++kz) map.tree().setNodeValue(HandMap::key(0, 0, kz), -0.4f, true);
  map.tree().setNodeValue(HandMap::key(1, 0, 3), 0.85f, true);
  expectCells(map.convert(withClearance(0.3)).floor, {{0, kNaN}});
  expectCells(map.convert(withClearance(0.3)).aerial, {{0, -1}});
  map.tree().updateInnerOccupancy();  // now they are occupied because a child is
  expectCells(map.convert(withClearance(0.3)).floor, {{0, kNaN}});
  expectCells(map.convert(withClearance(0.3)).aerial, {{0, -1}});
}

// ---- free ranges

TEST(ConversionRuns, ARunIsKeptFromTheClearanceOn)
{
  HandMap map(0.1);
  map.free(0, 0, 5, 14).free(1, 0, 5, 15).free(2, 0, 5, 16);  // 0.9, 1.0 and 1.1 m
  const Layers layers = map.convert(withClearance(1.0));
  expectCells(layers.floor, {{kNaN, 0.5f, 0.5f}});
  expectCells(layers.ceiling, {{kNaN, 1.5f, 1.6f}});
}

TEST(ConversionRuns, AClearanceBetweenVoxelsNeedsTheNextWholeOne)
{
  HandMap map(0.3);
  map.free(0, 0, 0, 3).free(1, 0, 0, 4);  // 0.9 and 1.2 m
  const Layers layers = map.convert(withClearance(1.0));
  expectCells(layers.floor, {{kNaN, 0}});
  expectCells(layers.ceiling, {{kNaN, 1.2f}});
}

TEST(ConversionRuns, RoundingOfTheQuotientLosesNoRun)
{
  HandMap map(0.08);
  map.free(0, 0, 0, 6).free(1, 0, 0, 7);  // 0.56/0.08 is 7.000000000000001 in double
  expectCells(map.convert(withClearance(0.56)).ceiling, {{kNaN, 0.56f}});
}

TEST(ConversionRuns, WithoutClearanceOneVoxelIsEnough)
{
  HandMap map(0.1);
  map.column(0, 0, -1, "#f#").column(1, 0, -1, "###");
  const Layers layers = map.convert(withClearance(0));
  expectCells(layers.floor, {{0, kNaN}});
  expectCells(layers.ceiling, {{0.1f, kNaN}});
}

TEST(ConversionRuns, LowestAndHighestKeptRunCount)
{
  HandMap map(0.1);
  map.column(0, 0, 0, "ff#fff#ff##ffff#ff");  // kept: [3, 6) and [11, 15)
  map.column(1, 0, 0, "ffff.....ff.ff");      // kept: [0, 4)
  map.column(2, 0, 0, "#ff.ff.ff#ff");        // none
  const Layers layers = map.convert(withClearance(0.3));
  expectCells(layers.floor, {{0.3f, 0, kNaN}});
  expectCells(layers.ceiling, {{1.5f, 0.4f, kNaN}});
}

TEST(ConversionRuns, OccupiedAndUnknownVoxelsBothEndARun)
{
  HandMap map(0.1);
  map.column(0, 0, 0, "fff#fff").column(1, 0, 0, "fff.fff").column(2, 0, 0, "fffffff");
  expectCells(map.convert(withClearance(0.4)).floor, {{kNaN, kNaN, 0}});
  expectCells(map.convert(withClearance(0.7)).floor, {{kNaN, kNaN, 0}});
  expectCells(map.convert(withClearance(0.8)).floor, {{kNaN, kNaN, kNaN}});
}

TEST(ConversionRuns, HeightsBelowZeroAndLongRuns)
{
  HandMap map(0.1);
  map.free(0, 0, -30, -20);
  map.free(1, 0, -130, 200);  // crosses every 64-voxel border in between
  map.free(2, 0, 60, 68).free(2, 0, 120, 136);
  map.free(3, 0, 0, 64).occupied(3, 0, 64, 65);
  const Layers layers = map.convert(withClearance(0.8));
  expectCells(layers.floor, {{-3, -13, 6, 0}});
  expectCells(layers.ceiling, {{-2, 20, 13.6f, 6.4f}});
}

TEST(ConversionRuns, RunsAcrossWordBorders)
{
  // columns are kept in words of 64 voxels; one of these runs goes from one word into the next
  HandMap map(0.1);
  map.free(0, 0, -36, -28).free(1, 0, -4, 4).free(2, 0, 28, 36).free(3, 0, 60, 68);
  const Layers layers = map.convert(withClearance(0.8));
  expectCells(layers.floor, {{-3.6f, -0.4f, 2.8f, 6}});
  expectCells(layers.ceiling, {{-2.8f, 0.4f, 3.6f, 6.8f}});
}

TEST(ConversionRuns, HeightsAreMetresOfTheMapFrame)
{
  HandMap map(0.07);
  map.free(0, 0, 21, 42);
  const Layers layers = map.convert(ConversionParams::paper());
  // the face of voxel k lies at k times the voxel size, rounded once to double and once to float
  EXPECT_EQ(layers.floor.at(0, 0), static_cast<float>(1.47));
  EXPECT_EQ(layers.ceiling.at(0, 0), static_cast<float>(2.94));
}

// ---- errors

TEST(ConversionErrors, AMapWithoutKnownVoxels)
{
  const HandMap map(0.1);
  EXPECT_THROW(freespace::frameOf(map.source()), std::runtime_error);
  EXPECT_THROW(map.convert(ConversionParams::paper()), std::runtime_error);
}

TEST(ConversionErrors, AMapWithoutAKeptRunIsNone)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 9).occupied(1, 1, 0, 9);
  const Layers layers = map.convert(ConversionParams::paper());
  for (const auto* layer : {&layers.floor, &layers.ceiling, &layers.slope})
    expectCells(*layer, {{kNaN, kNaN}, {kNaN, kNaN}});
  for (const auto* layer : {&layers.aerial, &layers.ground})
    expectCells(*layer, {{-1, -1}, {-1, -1}});
  const freespace::LayerStatistics count = freespace::statistics(layers);
  EXPECT_EQ(count.free, 0u);
  EXPECT_EQ(count.unknown, 4u);
}

TEST(ConversionErrors, ParametersAreCheckedFirst)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 20);
  auto params = ConversionParams::paper();
  params.minOccupancy = 1.1;
  EXPECT_THROW(map.convert(params), std::invalid_argument);
  params = withClearance(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(map.convert(params), std::invalid_argument);
  EXPECT_THROW(freespace::IncrementalLayers(params, 1), std::invalid_argument);
  // before the map is looked at
  EXPECT_THROW(HandMap(0.1).convert(params), std::invalid_argument);
}

TEST(ConversionErrors, ARunHigherThanAnyMapIsNotKept)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 200);
  expectCells(map.convert(withClearance(1e9)).aerial, {{-1}});
  expectCells(map.convert(withClearance(1e300)).aerial, {{-1}});
}

}  // namespace
