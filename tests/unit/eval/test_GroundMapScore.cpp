#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/GroundMapScore.h>

#include <cmath>

using namespace mrpt_mapconv;

namespace
{
grid::Layer<float> row(const std::vector<float>& values)
{
  grid::GridFrame frame;
  frame.resolution = 0.5;
  frame.width = static_cast<std::int32_t>(values.size());
  frame.height = 1;
  grid::Layer<float> layer(frame, 0);
  layer.cells() = values;
  return layer;
}
}  // namespace

TEST(GroundMapScore, ErrorsOfMeasuredAndInferredCellsApart)
{
  aerial::GroundLayers map;
  map.ground = row({1, 2, 3, 4, 5});
  map.groundPoints = row({1, 0, 7, 0, 0});
  const auto score = eval::scoreGroundMap(map, row({1.5F, 2, 2, 1, NAN}));
  EXPECT_EQ(score.measured.cells, 2U);
  EXPECT_DOUBLE_EQ(score.measured.bias, 0.25);
  EXPECT_DOUBLE_EQ(score.measured.rms, std::sqrt((0.25 + 1) / 2));
  EXPECT_EQ(score.inferred.cells, 2U);
  EXPECT_DOUBLE_EQ(score.inferred.bias, 1.5);
  EXPECT_EQ(score.all.cells, 4U);
  EXPECT_DOUBLE_EQ(score.all.rms, std::sqrt((0.25 + 1 + 9) / 4));
}
