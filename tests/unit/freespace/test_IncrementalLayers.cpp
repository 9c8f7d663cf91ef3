// Layers that follow a map: hand-worked edits. Random ones: tests/property/test_Incremental.cpp.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::IncrementalLayers;
using test::expectCells;
using test::HandMap;
using test::kNaN;

voxel::ColumnSet columns(const std::vector<std::pair<int, int>>& keys)
{
  voxel::ColumnSet set;
  for (const auto& [kx, ky] : keys) set.insert(kx, ky);
  return set;
}

/** 5×5 free columns of 2 m at 0.1 m, the south-west one at key (0, 0). */
void flatFloor(HandMap& map)
{
  const std::vector<int> row(5, 0);
  map.floors({row, row, row, row, row});
}

TEST(IncrementalLayers, BeginEmpty)
{
  const IncrementalLayers layers(freespace::ConversionParams::paper());
  EXPECT_TRUE(layers.layers().frame().empty());
  EXPECT_EQ(layers.params().minClearance, 1.0);
}

TEST(IncrementalLayers, AnEmptyMapGivesEmptyLayers)
{
  const HandMap map(0.1);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  EXPECT_TRUE(layers.layers().frame().empty());
  EXPECT_TRUE(layers.exact(map.source()).frame().empty());
  EXPECT_FALSE(layers.update(map.source(), {}).everywhere);
  EXPECT_TRUE(layers.layers().frame().empty());
}

TEST(IncrementalLayers, RebuildLiesOnTheBoundingBox)
{
  HandMap map(0.1);
  map.free(3, -2, 0, 20).free(5, 1, 0, 20);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  EXPECT_EQ(layers.layers().frame(), (grid::GridFrame{0.1, 3, -2, 3, 4}));
}

TEST(IncrementalLayers, RebuildOnAGivenFrame)
{
  HandMap map(0.1);
  map.free(0, 0, 2, 22);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source(), grid::GridFrame{0.1, -1, 0, 3, 2});
  expectCells(layers.layers().aerial, {{-1, -1, -1}, {-1, 0, -1}});
  expectCells(layers.layers().floor, {{kNaN, kNaN, kNaN}, {kNaN, 0.2f, kNaN}});
}

TEST(IncrementalLayers, ANewWallIsFollowed)
{
  HandMap map(0.1);
  flatFloor(map);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  map.occupied(2, 2, 0, 20);
  EXPECT_FALSE(layers.update(map.source(), columns({{2, 2}})).everywhere);
  expectCells(
      layers.layers().aerial,
      {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
  EXPECT_TRUE(std::isnan(layers.layers().floor.at(2, 2)));
  EXPECT_TRUE(std::isnan(layers.layers().slope.at(2, 2)));
}

TEST(IncrementalLayers, WhatStandsUnderAFloorIsFollowed)
{
  HandMap map(0.1);
  for (const int kx : {0, 2}) map.occupied(kx, 0, -1, 0).free(kx, 0, 0, 20);
  map.free(1, 0, 12, 30);
  IncrementalLayers layers({}, 1);
  layers.rebuild(map.source());
  EXPECT_EQ(layers.layers().support.at(1, 0), 0) << "inferred";
  map.occupied(1, 0, 5, 6);  // the floor stays
  layers.update(map.source(), columns({{1, 0}}));
  EXPECT_TRUE(std::isnan(layers.layers().support.at(1, 0)));
  EXPECT_EQ(layers.layers().evidence.at(1, 0), 3);
  map.tree().deleteNode(HandMap::key(1, 0, 5));
  layers.update(map.source(), columns({{1, 0}}));
  EXPECT_EQ(layers.layers().support.at(1, 0), 0);
}

TEST(IncrementalLayers, NoGapIsSoLongThatItsSquareIsShort)
{
  HandMap map(0.05);
  for (const int kx : {-25000, 25000}) map.occupied(kx, 0, -1, 0).free(kx, 0, 0, 30);
  freespace::ConversionParams params;
  params.maxGap = 1300;  // m; the gap is 2500 m, 50 000 cells
  IncrementalLayers layers(params, 1);
  layers.rebuild(map.source());
  map.free(0, 0, 0, 30);
  layers.update(map.source(), columns({{0, 0}}));
  EXPECT_TRUE(std::isnan(layers.layers().support.at(25000, 0)));
  EXPECT_EQ(layers.layers().floor.at(25000, 0), 0);
}

TEST(IncrementalLayers, AWallsOccupancyFollowsItsNeighbour)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 20).occupied(1, 0, 0, 10).occupied(2, 0, 0, 10);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  expectCells(layers.layers().aerial, {{0, 0.5f, -1}});
  // the free space becomes [0, 10), all of it beside the wall, whose own column has not changed
  map.occupied(0, 0, 10, 20);
  layers.update(map.source(), columns({{0, 0}}));
  expectCells(layers.layers().aerial, {{0, 1, -1}});
  // and now nothing is free
  map.occupied(0, 0, 0, 10);
  layers.update(map.source(), columns({{0, 0}}));
  expectCells(layers.layers().aerial, {{-1, -1, -1}});
}

TEST(IncrementalLayers, AWallBesideAChangeKeepsItsOtherNeighbour)
{
  // the free column is two cells from the change, so that nobody needs to read it anew; keys well
  // inside of a block of columns
  HandMap map(0.1);
  map.free(10, 10, 0, 20).occupied(11, 10, 0, 15).occupied(12, 10, 0, 3);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  expectCells(layers.layers().aerial, {{0, 0.75f, -1}});
  map.occupied(12, 10, 3, 4);
  layers.update(map.source(), columns({{12, 10}}));
  expectCells(layers.layers().aerial, {{0, 0.75f, -1}});
}

TEST(IncrementalLayers, TheSlopeFollowsWithinItsWindow)
{
  HandMap map(0.1);
  const std::vector<int> row(7, 0);
  map.floors({row, row, row}, 40);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  for (int ky = 0; ky < 3; ++ky) map.occupied(6, ky, 0, 4);  // a floor 4 voxels higher
  layers.update(map.source(), columns({{6, 0}, {6, 1}, {6, 2}}));
  const std::vector<float> slopes{0, 0, 0, 0, 0.8f, 1.2f, 2};
  expectCells(layers.layers().slope, {slopes, slopes, slopes}, 2e-6f);
}

TEST(IncrementalLayers, StepsFollowOneCellAround)
{
  HandMap map(0.1);
  flatFloor(map);
  auto params = freespace::ConversionParams::paper();
  params.maxStep = 0.2;
  IncrementalLayers layers(params, 1);
  layers.rebuild(map.source());
  map.occupied(1, 1, 0, 3);
  layers.update(map.source(), columns({{1, 1}}));
  expectCells(
      layers.layers().ground,
      {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {1, 1, 1, 0, 0}, {1, 1, 1, 0, 0}, {1, 1, 1, 0, 0}});
  map.free(1, 1, 0, 3);
  layers.update(map.source(), columns({{1, 1}}));
  const std::vector<float> free(5, 0);
  expectCells(layers.layers().ground, {free, free, free, free, free});
}

TEST(IncrementalLayers, TheFrameGrowsAndKeepsWhatItHad)
{
  HandMap map(0.1);
  flatFloor(map);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  map.free(-1, 2, 3, 23);
  EXPECT_TRUE(layers.update(map.source(), columns({{-1, 2}})).everywhere);
  const grid::GridFrame frame = layers.layers().frame();
  EXPECT_LE(frame.x0, -1);
  EXPECT_GE(frame.xEnd(), 5);
  EXPECT_EQ(layers.layers().floor.cells()[frame.indexOfKey(-1, 2)], 0.3f);
  EXPECT_EQ(layers.layers().floor.cells()[frame.indexOfKey(4, 4)], 0.0f);

  const freespace::Layers exact = layers.exact(map.source());
  EXPECT_EQ(exact.frame(), (grid::GridFrame{0.1, -1, 0, 6, 5}));
  expectCells(exact.aerial, {{-1, 0, 0, 0, 0, 0},
                             {-1, 0, 0, 0, 0, 0},
                             {0, 0, 0, 0, 0, 0},
                             {-1, 0, 0, 0, 0, 0},
                             {-1, 0, 0, 0, 0, 0}});
}

TEST(IncrementalLayers, AShrunkMapHasSmallerExactLayers)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 20).free(1, 0, 0, 20);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  map.tree().clear();
  map.free(1, 0, 0, 20);
  layers.update(map.source(), columns({{0, 0}}));
  expectCells(layers.layers().aerial, {{-1, 0}});
  EXPECT_EQ(layers.exact(map.source()).frame(), (grid::GridFrame{0.1, 1, 0, 1, 1}));
}

TEST(IncrementalLayers, AClearedMapIsUnknown)
{
  HandMap map(0.1);
  map.free(0, 0, 0, 20).occupied(1, 0, 0, 20);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  map.tree().clear();
  layers.update(map.source(), columns({{0, 0}, {1, 0}}));
  for (const float cell : layers.layers().aerial.cells()) EXPECT_EQ(cell, -1.0f);
  for (const float cell : layers.layers().floor.cells()) EXPECT_TRUE(std::isnan(cell));
  EXPECT_TRUE(layers.exact(map.source()).frame().empty());
}

TEST(IncrementalLayers, ClearForgetsEverything)
{
  HandMap map(0.1);
  flatFloor(map);
  IncrementalLayers layers(freespace::ConversionParams::paper(), 1);
  layers.rebuild(map.source());
  layers.clear();
  EXPECT_TRUE(layers.layers().frame().empty());
  EXPECT_TRUE(layers.layers().aerial.cells().empty());
}

TEST(IncrementalLayers, AnnouncedColumnsWithNothingInThemDoNotMakeTheFrameGrow)
{
  HandMap map(1.0);
  map.column(0, 0, 0, "#fff");
  IncrementalLayers followed;
  voxel::ColumnSet changed;
  changed.insert(0, 0);
  changed.insert(2000, 1000);
  changed.insert(-30000, 30000);
  EXPECT_TRUE(followed.update(map.source(), changed).everywhere);
  EXPECT_EQ(followed.layers().frame(), (grid::GridFrame{1.0, 0, 0, 1, 1}));
  voxel::ColumnSet nothing;
  nothing.insert(500, 500);
  EXPECT_FALSE(followed.update(map.source(), nothing).everywhere);
  EXPECT_EQ(followed.layers().frame().size(), 1u);
}

}  // namespace
