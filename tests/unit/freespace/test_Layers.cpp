#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::Layers;
using test::expectCells;
using test::kNaN;

TEST(Layers, BeginUnknown)
{
  const Layers layers(grid::GridFrame{0.1, -1, 4, 2, 1});
  for (const auto* layer : {&layers.floor, &layers.ceiling, &layers.slope})
    expectCells(*layer, {{kNaN, kNaN}});
  for (const auto* layer : {&layers.aerial, &layers.ground}) expectCells(*layer, {{-1, -1}});
}

TEST(Layers, AreNamedInTheOrderOfExport)
{
  Layers layers(grid::GridFrame{0.1, 0, 0, 1, 1});
  layers.floor.at(0, 0) = 1;
  layers.ceiling.at(0, 0) = 2;
  layers.slope.at(0, 0) = 3;
  layers.aerial.at(0, 0) = 4;
  layers.ground.at(0, 0) = 5;
  layers.support.at(0, 0) = 6;
  layers.evidence.at(0, 0) = 7;
  const char* names[] = {"floor", "ceiling", "slope", "aerial", "ground", "support", "evidence"};
  float value = 1;
  for (const auto& [name, layer] : layers.named())
  {
    EXPECT_EQ(name, names[static_cast<int>(value) - 1]);
    EXPECT_EQ(layer->at(0, 0), value);
    value += 1;
  }
}

TEST(Layers, SayWhatTheyShow)
{
  const Layers layers(grid::GridFrame{0.1, 0, 0, 1, 1});
  const auto named = layers.named();
  const auto styled = layers.styled();
  ASSERT_EQ(styled.size(), named.size());
  for (std::size_t i = 0; i < styled.size(); ++i)
  {
    EXPECT_EQ(styled[i].name, named[i].first);
    EXPECT_EQ(styled[i].layer, named[i].second);
    EXPECT_FALSE(styled[i].title.empty()) << styled[i].name;
    EXPECT_EQ(styled[i].unit.empty(), styled[i].kind == grid::LayerKind::Occupancy ||
                                          styled[i].kind == grid::LayerKind::Evidence);
  }
  EXPECT_EQ(layers.styled("ground").freeFor, &layers.aerial);
  EXPECT_EQ(layers.styled("aerial").freeFor, nullptr);
  EXPECT_EQ(layers.styled("slope").kind, grid::LayerKind::Slope);
  EXPECT_THROW(layers.styled("cellar"), std::invalid_argument);
}

TEST(Layers, LaidOnAnotherFrameKeepSharedCells)
{
  Layers layers(grid::GridFrame{0.1, 0, 0, 2, 2});
  for (const auto& entry : Layers::list())
    (layers.*entry.member).cells() = {1, 2, 3, 4};  // south row, then north row

  const Layers moved = layers.onFrame(grid::GridFrame{0.1, 1, -1, 3, 2});
  for (const auto& [name, layer] : moved.named())
  {
    SCOPED_TRACE(name);
    const bool isOccupancy = name == "aerial" || name == "ground";
    const float unknown = isOccupancy ? -1.0f : name == "evidence" ? 0.0f : kNaN;
    EXPECT_EQ(layer->frame().x0, 1);
    EXPECT_EQ(layer->frame().y0, -1);
    expectCells(*layer, {{2, unknown, unknown}, {unknown, unknown, unknown}});
  }
}

TEST(Layers, AreCounted)
{
  Layers layers(grid::GridFrame{0.1, 0, 0, 4, 2});
  layers.aerial.cells() = {0, 0, 0, 0.6f, 1, -1, -1, -1};
  layers.ground.cells() = {0, 1, 1, 0.6f, 1, -1, -1, -1};
  layers.floor.cells() = {1, 1, 1, kNaN, kNaN, kNaN, kNaN, kNaN};
  layers.ceiling.cells() = {3, 3, 3, kNaN, kNaN, kNaN, kNaN, kNaN};
  layers.slope.cells() = {kNaN, 2.5f, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
  const freespace::LayerStatistics count = freespace::statistics(layers);
  EXPECT_EQ(count.free, 3u);
  EXPECT_EQ(count.occupied, 2u);
  EXPECT_EQ(count.unknown, 3u);
  EXPECT_EQ(count.steep, 2u);
  EXPECT_EQ(count.slopeUnknown, 2u);
}

}  // namespace
