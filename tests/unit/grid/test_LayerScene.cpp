#include <gtest/gtest.h>
#include <mrpt/opengl/CMesh.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/PictureColors.h>

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

namespace
{
/** A ground robot's layer on kFrame: free, inferred, drop edge; step, frontier, free. */
struct Ground
{
  Layer<float> occupancy{kFrame, kFree}, aerial{kFrame, kFree}, evidence{kFrame, 1},
      drops{kFrame, 0};

  Ground()
  {
    evidence.at(1, 0) = kInferredGround;
    occupancy.at(2, 0) = drops.at(2, 0) = 1;
    occupancy.at(0, 1) = 1;
    occupancy.at(1, 1) = kUnknown;
  }
  StyledLayer styled() const
  {
    return {"ground", &occupancy, "", "", LayerKind::Occupancy, &aerial, &evidence, &drops};
  }
};

bool isSame(const mrpt::img::TColor& a, const mrpt::img::TColor& b)
{
  return a.R == b.R && a.G == b.G && a.B == b.B;
}
}  // namespace

TEST(LayerScene, ASurfaceMayShowWhereAGroundRobotMayGo)
{
  const Layer<float> level(kFrame, 1.0f);
  const Ground ground;
  CSetOfObjects scene;
  drawSurface(styled(level), ground.styled(), scene);
  const auto mesh = std::dynamic_pointer_cast<mrpt::opengl::CMesh>(scene.getByName("floor"));
  ASSERT_TRUE(mesh);
  const auto pixel = [&](unsigned x, unsigned y)
  {
    const auto& image = mesh->getTextureImage();
    const auto channel = [&](unsigned i) { return image.at<std::uint8_t>(y, x, i); };
    return mrpt::img::TColor(channel(2), channel(1), channel(0));  // x along the rows, BGR
  };
  EXPECT_TRUE(isSame(pixel(0, 0), pixel(2, 1))) << "free cells have the colour of their height";
  EXPECT_FALSE(isSame(pixel(0, 0), pixel(1, 0)));
  EXPECT_GT(pixel(1, 0).R, pixel(0, 0).R) << "lighter where the ground is inferred";
  EXPECT_TRUE(isSame(pixel(2, 0), picture::kDropColor));
  EXPECT_TRUE(isSame(pixel(0, 1), picture::kSteepColor));
  EXPECT_TRUE(isSame(pixel(1, 1), picture::kFrontierColor));
}

TEST(LayerScene, TheLegendNamesTheColoursThatThereAre)
{
  Ground ground;
  const auto lines = [&ground]
  {
    mrpt::opengl::COpenGLScene scene;
    drawLegend(ground.styled(), *scene.getViewport());
    return scene.getViewport()->getTextMessages().messages.size();
  };
  EXPECT_EQ(lines(), 4u);
  ground.drops.at(2, 0) = 0;
  EXPECT_EQ(lines(), 3u) << "without a drop edge";
  ground.evidence.at(1, 0) = 1;
  ground.occupancy.at(1, 1) = kFree;
  ground.occupancy.at(2, 0) = ground.occupancy.at(0, 1) = kFree;
  EXPECT_EQ(lines(), 0u) << "only heights";
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
