#include <gtest/gtest.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt_mapconv/grid/PlaneColors.h>
#include <mrpt_mapconv/terrain/TerrainScene.h>

#include "TerrainMaps.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::terrain;
using mrpt::opengl::CSetOfTriangles;
using mrpt_mapconv::test::twoLevels;

namespace
{
mrpt::opengl::CSetOfObjects sceneOf(const TerrainMap& map, const TTerrainSceneOptions& options = {})
{
  mrpt::opengl::CSetOfObjects scene;
  drawLeaves(map, map.layers().plane, options, scene);
  return scene;
}

template <class Object>
std::shared_ptr<Object> named(mrpt::opengl::CSetOfObjects& scene, const std::string& name)
{
  return std::dynamic_pointer_cast<Object>(scene.getByName(name));
}
}  // namespace

TEST(TerrainScene, ALeafIsASquareOfItsPlanesColour)
{
  const TerrainMap map = twoLevels();
  auto scene = sceneOf(map);
  const auto planes = named<CSetOfTriangles>(scene, "planes");
  ASSERT_TRUE(planes);
  ASSERT_EQ(planes->getTrianglesCount(), 4u) << "two leaves of 8 x 8 cells";
  const grid::picture::PlaneColors colors(map.layers().plane);
  for (std::size_t i = 0; i < 4; ++i)
  {
    mrpt::opengl::TTriangle triangle;
    planes->getTriangle(i, triangle);
    const bool isUpper = triangle.z(0) > 0.25f;
    const auto& color = colors.of(isUpper ? 1 : 0);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      EXPECT_NEAR(triangle.z(corner), isUpper ? 0.5f : 0.0f, 1e-4f);
      EXPECT_NEAR(std::abs(triangle.x(corner) - (isUpper ? 1.15f : 0.35f)), 0.4f, 1e-5f);
      EXPECT_NEAR(std::abs(triangle.y(corner) - 0.35f), 0.4f, 1e-5f);
      EXPECT_EQ(triangle.r(corner), color.R);
      EXPECT_EQ(triangle.g(corner), color.G);
    }
  }
  const auto outlines = named<mrpt::opengl::CSetOfLines>(scene, "outlines");
  ASSERT_TRUE(outlines);
  EXPECT_EQ(outlines->getLineCount(), 8u);
}

TEST(TerrainScene, ACellWithoutAPlaneIsALevelGreySquare)
{
  auto scene = sceneOf(twoLevels());
  const auto cells = named<CSetOfTriangles>(scene, "cells");
  ASSERT_TRUE(cells);
  ASSERT_EQ(cells->getTrianglesCount(), 2u);
  mrpt::opengl::TTriangle triangle;
  cells->getTriangle(0, triangle);
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    EXPECT_NEAR(triangle.z(corner), 2, 1e-4f);
    EXPECT_NEAR(std::abs(triangle.x(corner) - 2), 0.05f, 1e-5f);
    EXPECT_EQ(triangle.r(corner), triangle.b(corner));
  }
}

TEST(TerrainScene, LeavesAreTiltedAsTheirPlanes)
{
  TerrainMap map(0.1);
  for (std::int32_t ky = 0; ky < 8; ++ky)
    for (std::int32_t kx = 0; kx < 8; ++kx) map.insertPoint(0.1 * kx, 0.1 * ky, 0.05 * kx, 0.01);
  map.update();
  ASSERT_EQ(map.planes().size(), 1u);
  auto scene = sceneOf(map);
  const auto planes = named<CSetOfTriangles>(scene, "planes");
  ASSERT_TRUE(planes);
  ASSERT_EQ(planes->getTrianglesCount(), 2u);
  mrpt::opengl::TTriangle triangle;
  planes->getTriangle(0, triangle);
  for (std::size_t corner = 0; corner < 3; ++corner)
    EXPECT_NEAR(triangle.z(corner), 0.5f * triangle.x(corner), 1e-3f);
}

TEST(TerrainScene, ShowsWhatItIsTold)
{
  TTerrainSceneOptions options;
  options.showOutlines = false;
  auto leaves = sceneOf(twoLevels(), options);
  EXPECT_TRUE(leaves.getByName("planes"));
  EXPECT_FALSE(leaves.getByName("outlines"));
  EXPECT_TRUE(sceneOf(TerrainMap(0.1)).empty());
}

TEST(TerrainScene, TheLegendNamesThePlanes)
{
  mrpt::opengl::COpenGLScene scene;
  drawLegend(twoLevels(), *scene.getViewport());
  mrpt::opengl::COpenGLViewport empty;
  EXPECT_GT(scene.getViewport()->getTextMessages().messages.size(), 0u);
}
