#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/opengl/CMesh.h>
#include <mrpt/opengl/CTexturedPlane.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/RosMap.h>

#include "support/TempDir.h"

// Frames whose cells are centred on multiples of the resolution: a key's metres are the same
// wherever a layer goes.

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::testing;
using mrpt::maps::COccupancyGridMap2D;

namespace
{
const GridFrame kCentred{0.5, -2, 4, 6, 3, -0.5};

/** Unknown, but for one occupied cell, that of the key (1, 5). */
Layer<float> oneOccupied(float others = kUnknown)
{
  Layer<float> layer(kCentred, others);
  layer.cells()[kCentred.indexOfKey(1, 5)] = 1;
  return layer;
}

void expectOneOccupiedPlace(const COccupancyGridMap2D& map)
{
  for (const float off : {-0.24f, 0.0f, 0.24f})
    EXPECT_LT(map.getPos(0.5f + off, 2.5f + off), 0.1f) << off;
  for (const float off : {-0.26f, 0.26f}) EXPECT_EQ(map.getPos(0.5f + off, 2.5f), 0.5f) << off;
}

void expectOneOccupied(const COccupancyGridMap2D& map)
{
  EXPECT_FLOAT_EQ(map.getXMin(), -1.25f);
  EXPECT_FLOAT_EQ(map.getXMax(), 1.75f);
  EXPECT_FLOAT_EQ(map.getYMin(), 1.75f);
  EXPECT_FLOAT_EQ(map.getYMax(), 3.25f);
  ASSERT_EQ(map.getSizeX(), 6u);
  ASSERT_EQ(map.getSizeY(), 3u);
  EXPECT_EQ(map.x2idx(0.5f), 3);
  EXPECT_EQ(map.y2idx(2.5f), 1);
  EXPECT_FLOAT_EQ(map.idx2x(3), 0.5f);
  expectOneOccupiedPlace(map);
}
}  // namespace

TEST(ShiftedFrames, CellsAreCentredOnMultiplesOfTheResolution)
{
  EXPECT_EQ(kCentred.xMin(), -1.25);
  EXPECT_EQ(kCentred.xMax(), 1.75);
  EXPECT_EQ(kCentred.yMin(), 1.75);
  EXPECT_EQ(kCentred.yMax(), 3.25);
  EXPECT_EQ(kCentred.centreOf(-2), -1.0);
  EXPECT_EQ(kCentred.edgeOf(0), -0.25);
  const GridFrame plain{0.5, -2, 4, 6, 3};
  EXPECT_EQ(plain.centreOf(-2), -0.75);
  EXPECT_NE(plain, kCentred);
}

TEST(ShiftedFrames, AreUnitedWithTheirLikesOnly)
{
  const GridFrame other{0.5, 3, 2, 4, 1, -0.5}, both{0.5, -2, 2, 9, 5, -0.5};
  EXPECT_EQ(unite(kCentred, other), both);
  EXPECT_EQ(unite(kCentred, GridFrame()), kCentred);
  EXPECT_THROW(unite(kCentred, {0.5, 3, 2, 4, 1}), std::invalid_argument);
}

TEST(ShiftedFrames, StayShiftedWhereAPartIsTaken)
{
  const GridFrame cell{0.5, 1, 5, 1, 1, -0.5};
  EXPECT_EQ(knownFrame(oneOccupied(), LayerKind::Occupancy), cell);
  const auto layer = oneOccupied();
  EXPECT_EQ(shownFrame({{"x", &layer, "", "", LayerKind::Occupancy}}).shift, -0.5);
  EXPECT_EQ(layer.onFrame(cell, 0).cells().at(0), 1);
}

TEST(ShiftedFrames, ComeBackFromAGeoTiff)
{
  const TempDir dir;
  for (const double resolution : {0.02, 0.05, 0.07, 1.0 / 3})
  {
    const GridFrame frame{resolution, -12345, 678, 3, 2, -0.5};
    Layer<float> layer(frame, 0);
    layer.at(2, 1) = 7;
    writeGeoTiff(dir.path("x.tif"), {{"height", &layer}});
    const auto read = readGeoTiffBand(dir.path("x.tif"), "height");
    EXPECT_EQ(read.frame(), frame) << resolution;
    EXPECT_EQ(read.cells(), layer.cells());
  }
}

TEST(ShiftedFrames, ARosMapHasItsCornerBesideTheCellsCentre)
{
  const TempDir dir;
  writeRosMap(dir.path("m.pgm"), dir.path("m.yaml"), "m.pgm", oneOccupied());
  EXPECT_TRUE(contains(readBytes(dir.path("m.yaml")), "origin: [-1.25, 1.75, 0]"));
}

TEST(ShiftedFrames, AGridMapFindsEachPlaceInItsCell)
{
  COccupancyGridMap2D map;
  copyToGridMap(oneOccupied(), map);
  expectOneOccupied(map);
}

/** MRPT reads no other limits than multiples of the resolution. */
TEST(ShiftedFrames, AGridMapFileHasEachCellAsFour)
{
  const TempDir dir;
  writeGridMap(dir.path("m.gridmap"), oneOccupied());
  mrpt::io::CFileGZInputStream file(dir.path("m.gridmap"));
  COccupancyGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  EXPECT_FLOAT_EQ(map.getResolution(), 0.25f);
  EXPECT_FLOAT_EQ(map.getXMin(), -1.25f);
  EXPECT_FLOAT_EQ(map.getYMax(), 3.25f);
  EXPECT_EQ(map.getSizeX(), 12u);
  expectOneOccupiedPlace(map);
}

/** The same cells half a cell farther on, with a path that goes along, are the same picture but for
 * the numbers. */
TEST(ShiftedFrames, APictureHasPathsWhereTheyAre)
{
  const auto discOf = [](const Layer<float>& layer, double x, double y)
  {
    const StyledLayer styled{"x", &layer, "x", "", LayerKind::Occupancy};
    const auto with = drawLayer(styled, {{{x, y}, {x + 0.5, y}}, "way"}, layer.frame());
    const auto without = drawLayer(styled, {{{-9, -9}}, "way"}, layer.frame());
    mrpt::math::TPoint2D sum;
    double count = 0;
    for (int row = 0; row < static_cast<int>(with.getHeight()); ++row)
      for (int column = 0; column < static_cast<int>(with.getWidth()); ++column)
        if (*with(static_cast<unsigned>(column), static_cast<unsigned>(row), 0) !=
            *without(static_cast<unsigned>(column), static_cast<unsigned>(row), 0))
        {
          sum += {static_cast<double>(column), static_cast<double>(row)};
          ++count;
        }
    return sum * (1 / count);
  };
  const Layer<float> centred(kCentred, kFree), plain({0.5, -2, 4, 6, 3}, kFree);
  const auto a = discOf(centred, 0, 2.5), b = discOf(plain, 0.25, 2.75);
  EXPECT_NEAR(a.x, b.x, 1.5);
  EXPECT_NEAR(a.y, b.y, 1.5);
}

TEST(ShiftedFrames, ASceneHasSurfaceAndOccupancyInPlace)
{
  const auto layer = oneOccupied(0);
  mrpt::opengl::CSetOfObjects scene;
  const StyledLayer height{"height", &layer, "Height", "m"};
  drawSurface(height, height, scene);
  const auto mesh = std::dynamic_pointer_cast<mrpt::opengl::CMesh>(scene.getByName("height"));
  ASSERT_TRUE(mesh);
  EXPECT_FLOAT_EQ(mesh->getxMin(), -1.0f);
  EXPECT_FLOAT_EQ(mesh->getyMax(), 3.0f);

  drawOccupancy(layer, 0, true, scene);
  const auto occupancy =
      std::dynamic_pointer_cast<mrpt::opengl::CSetOfObjects>(scene.getByName("occupancy"));
  ASSERT_TRUE(occupancy);
  const auto plane = occupancy->getByClass<mrpt::opengl::CTexturedPlane>();
  ASSERT_TRUE(plane);
  float xMin = 0, xMax = 0, yMin = 0, yMax = 0;
  plane->getPlaneCorners(xMin, xMax, yMin, yMax);
  EXPECT_FLOAT_EQ(xMin, -1.25f);
  EXPECT_FLOAT_EQ(yMax, 3.25f);
}
