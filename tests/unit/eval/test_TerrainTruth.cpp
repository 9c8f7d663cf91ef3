#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/eval/TerrainTruth.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using namespace mrpt_mapconv;
using eval::TerrainTruth;

namespace
{
constexpr double kJump = 0.03;  // [m]

sim::World worldOf(const std::string& bodies)
{
  mrpt::config::CConfigFileMemory ini;
  ini.setContent("[world]\nbounds = -0.05 -0.05 -1  1.05 0.55 3\n" + bodies);
  return sim::World::fromIni(ini, {});
}

const std::string kFloor = "[box.floor]\nmin = -1 -1 -1\nmax = 2 2 0\n";

/** 11 x 6 cells of 0.1 m, centred on 0, 0.1, …, 1 and 0, …, 0.5 m. */
const grid::GridFrame kFrame{0.1, 0, 0, 11, 6, -0.5};

TerrainTruth truthOf(const std::string& bodies)
{
  return eval::terrainTruth(worldOf(bodies), kFrame, kJump);
}

std::vector<int> rowOf(const eval::CellMask& mask, std::int32_t iy)
{
  return {mask.row(iy), mask.row(iy) + mask.frame().width};
}
std::vector<int> rowOf(const grid::Layer<std::int32_t>& layer, std::int32_t iy)
{
  return {layer.row(iy), layer.row(iy) + layer.frame().width};
}
}  // namespace

TEST(TerrainTruth, HeightsAreThoseAtTheCellsCentres)
{
  // the box covers the centres 0.4 to 0.7, which lie in the middle of cells
  const auto truth = truthOf(kFloor + "[box.b]\nmin = 0.36 -1 0\nmax = 0.74 2 0.2\n");
  for (std::int32_t ix = 0; ix < 11; ++ix)
    EXPECT_NEAR(truth.height.at(ix, 2), ix >= 4 && ix <= 7 ? 0.2 : 0, 1e-7) << ix;
}

TEST(TerrainTruth, WhatLiesBeyondTheBoundsIsNotKnown)
{
  const auto truth = eval::terrainTruth(worldOf(kFloor), {0.1, -2, 0, 4, 1, -0.5}, kJump);
  EXPECT_TRUE(std::isnan(truth.height.at(0, 0)));
  EXPECT_TRUE(std::isnan(truth.height.at(1, 0)));
  EXPECT_EQ(truth.height.at(2, 0), 0);
  EXPECT_EQ(rowOf(truth.plane, 0), (std::vector<int>{-1, -1, -1, -1})) << "one row is no plane";
}

// the face at 0.36 goes through the cell of 0.4, that at 0.74 through the cell of 0.7
TEST(TerrainTruth, CellsOfJumpsAndThoseAroundAreSetApart)
{
  const auto truth = truthOf(kFloor + "[box.b]\nmin = 0.36 -1 0\nmax = 0.74 2 0.2\n");
  EXPECT_EQ(rowOf(truth.apart, 2), (std::vector<int>{0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0}));
  const auto low = truthOf(kFloor + "[box.b]\nmin = 0.36 -1 0\nmax = 0.74 2 0.03\n");
  EXPECT_EQ(eval::count(low.apart), 0u) << "a jump of just 0.03 m";
}

TEST(TerrainTruth, CellsWithSeveralSurfacesAreSetApart)
{
  const auto truth = truthOf(kFloor + "[box.board]\nmin = 0.36 -1 1\nmax = 0.44 2 1.05\n");
  EXPECT_EQ(rowOf(truth.apart, 2), (std::vector<int>{0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0}));
  EXPECT_EQ(rowOf(truth.plane, 2), (std::vector<int>{0, 0, 0, 0, -1, 1, 1, 1, 1, 1, 1}));
}

TEST(TerrainTruth, PlanesAreConnectedCellsAtOneHeight)
{
  // a wall from south to north: the floor on both sides of it, and its top
  const auto truth = truthOf(kFloor + "[box.b]\nmin = 0.36 -1 0\nmax = 0.74 2 0.2\n");
  ASSERT_EQ(truth.planes.size(), 3u);
  for (std::int32_t iy = 0; iy < 6; ++iy)
    EXPECT_EQ(rowOf(truth.plane, iy), (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2}));
  const auto& top = truth.planes[1];
  EXPECT_EQ(top.cells, 24);
  EXPECT_NEAR(top.x, 0.55, 1e-9);
  EXPECT_NEAR(top.y, 0.25, 1e-9);
  EXPECT_NEAR(top.z, 0.2, 1e-9);
  EXPECT_EQ(top.slopeX, 0);
  EXPECT_EQ(top.slopeY, 0);
  EXPECT_EQ(top.rms, 0);
  EXPECT_NEAR(top.xMin, 0.35, 1e-9);
  EXPECT_NEAR(top.xMax, 0.75, 1e-9);
  EXPECT_NEAR(top.yMin, -0.05, 1e-9);
  EXPECT_NEAR(top.yMax, 0.55, 1e-9);
  EXPECT_EQ(top.firstX, 4);
  EXPECT_EQ(top.firstY, 0);
}

TEST(TerrainTruth, CellsAtOneHeightThatTouchInACornerAreTwoPlanes)
{
  const auto truth = truthOf(kFloor + "[box.a]\nmin = -1 -1 0\nmax = 0.45 0.25 0.2\n" +
                             "[box.b]\nmin = 0.45 0.25 0\nmax = 2 2 0.2\n");
  EXPECT_EQ(truth.planes.size(), 4u);
  EXPECT_NE(truth.plane.at(4, 2), truth.plane.at(5, 3));
  EXPECT_NE(truth.plane.at(5, 2), truth.plane.at(4, 3));
}

TEST(TerrainTruth, ARampAndATiltedPlateArePlanes)
{
  const auto truth =
      truthOf(kFloor + "[ramp.r]\nmin = 0.35 -1 0\nmax = 0.85 0.25 0.1\ndirection = +x\n" +
              "[heightField.p]\nmin = 0.35 0.25\nmax = 0.95 0.65\ncell = 1\nsolid = below\n" +
              "base = 0.1\ngradient = 0.05 -0.1\n");
  const auto& ramp = truth.planes.at(static_cast<std::size_t>(truth.plane.at(5, 1)));
  EXPECT_EQ(ramp.cells, 5 * 3);
  EXPECT_NEAR(ramp.slopeX, 0.2, 1e-9);
  EXPECT_NEAR(ramp.slopeY, 0, 1e-9);
  EXPECT_NEAR(ramp.heightAt(0.6, 0), 0.05, 1e-9);
  const auto& plate = truth.planes.at(static_cast<std::size_t>(truth.plane.at(5, 4)));
  EXPECT_EQ(plate.cells, 6 * 3);
  EXPECT_NEAR(plate.slopeX, 0.05, 1e-6);
  EXPECT_NEAR(plate.slopeY, -0.1, 1e-6);
  EXPECT_NEAR(plate.heightAt(0, 0), 0.1, 1e-6);
}

TEST(TerrainTruth, ACurvedSurfaceHasNoPlanes)
{
  const auto truth = truthOf("[sphere.s]\ncentre = 0.5 0.25 -3\nradius = 4\n");
  EXPECT_TRUE(truth.planes.empty());
  EXPECT_GT(truth.height.at(5, 2), 0.99f);
}

TEST(TerrainTruth, RefusesAJumpThatIsNone)
{
  EXPECT_THROW(eval::terrainTruth(worldOf(kFloor), kFrame, -1), std::invalid_argument);
  EXPECT_THROW(eval::terrainTruth(worldOf(kFloor), kFrame, std::nan("")), std::invalid_argument);
}
