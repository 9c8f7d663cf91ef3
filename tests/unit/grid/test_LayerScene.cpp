#include <gtest/gtest.h>
#include <mrpt/opengl/CMesh.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <cmath>

using namespace mrpt_mapconv::grid;
using mrpt::opengl::CSetOfObjects;

namespace
{
const GridFrame kFrame{0.5, -2, 4, 3, 2};

Layer<float> heights()
{
  Layer<float> layer(kFrame, 1.0f);
  layer.at(2, 0) = -3.0f;
  layer.at(0, 1) = NAN;
  return layer;
}

StyledLayer styled(const Layer<float>& layer) { return {"floor", &layer, "Floor", "m"}; }
}  // namespace

TEST(LayerScene, ASurfaceGoesThroughTheCellsCentres)
{
  const auto floor = heights();
  CSetOfObjects scene;
  drawSurface(styled(floor), styled(floor), scene);
  const auto mesh = std::dynamic_pointer_cast<mrpt::opengl::CMesh>(scene.getByName("floor"));
  ASSERT_TRUE(mesh);
  EXPECT_FLOAT_EQ(mesh->getxMin(), -0.75f);
  EXPECT_FLOAT_EQ(mesh->getxMax(), 0.25f);
  EXPECT_FLOAT_EQ(mesh->getyMin(), 2.25f);
  EXPECT_FLOAT_EQ(mesh->getyMax(), 2.75f);
  mrpt::math::CMatrixF z, mask;
  mesh->getZ(z);
  mesh->getMask(mask);
  EXPECT_EQ(z(0, 0), 1.0f);  // x along the rows
  EXPECT_EQ(z(2, 0), -3.0f);
  EXPECT_EQ(mask(2, 0), 1.0f);
  EXPECT_EQ(mask(0, 1), 0.0f) << "a cell without a height is a hole";
}

TEST(LayerScene, ARowOfCellsIsNoSurface)
{
  const Layer<float> row(GridFrame{0.5, 0, 0, 5, 1}, 1.0f);
  CSetOfObjects scene;
  drawSurface(styled(row), styled(row), scene);
  EXPECT_TRUE(scene.empty());
}

TEST(LayerScene, OccupancyLiesBelowTheHeights)
{
  const auto floor = heights();
  const Layer<float> occupancy(kFrame, kFree);
  EXPECT_DOUBLE_EQ(heightBelow(floor), -3.5);
  CSetOfObjects scene;
  drawLayers({styled(floor), {"aerial", &occupancy, "", "", LayerKind::Occupancy}}, occupancy,
             scene);
  ASSERT_EQ(scene.size(), 2u);
  EXPECT_TRUE(scene.getByName("floor"));
  ASSERT_TRUE(scene.getByName("occupancy"));
  EXPECT_DOUBLE_EQ(scene.getByName("occupancy")->getPoseZ(), -3.5);
}

TEST(LayerScene, OccupancyAloneLiesAtZero)
{
  const Layer<float> occupancy(kFrame, kFree);
  CSetOfObjects scene;
  drawLayers({{"aerial", &occupancy, "", "", LayerKind::Occupancy}}, occupancy, scene);
  ASSERT_EQ(scene.size(), 1u);
  EXPECT_DOUBLE_EQ(scene.getByName("occupancy")->getPoseZ(), 0);
}
