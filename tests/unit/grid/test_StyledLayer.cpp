#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <cmath>
#include <stdexcept>

using namespace mrpt_mapconv::grid;

TEST(StyledLayer, UnknownCellsAreThoseOfTheKind)
{
  EXPECT_TRUE(std::isnan(unknownCell(LayerKind::Height)));
  EXPECT_TRUE(std::isnan(unknownCell(LayerKind::Slope)));
  EXPECT_EQ(unknownCell(LayerKind::Occupancy), -1.0f);
  EXPECT_TRUE(std::isnan(unknownCell(LayerKind::Plane)));
}

TEST(StyledLayer, KindsHaveNames)
{
  EXPECT_STREQ(nameOf(LayerKind::Height), "height");
  EXPECT_STREQ(nameOf(LayerKind::Slope), "slope");
  EXPECT_STREQ(nameOf(LayerKind::Occupancy), "occupancy");
  EXPECT_STREQ(nameOf(LayerKind::Plane), "plane");
}

TEST(StyledLayer, IsFoundByName)
{
  const Layer<float> a, b;
  const std::vector<StyledLayer> layers{{"a", &a}, {"b", &b}};
  EXPECT_EQ(findLayer(layers, "b").layer, &b);
  try
  {
    findLayer(layers, "c");
    FAIL() << "there is none";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(), "there is no layer 'c'");
  }
}
