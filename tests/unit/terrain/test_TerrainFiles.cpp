#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/terrain/TerrainFiles.h>

#include <set>

#include "TerrainMaps.h"
#include "support/TempDir.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::terrain;
using mrpt_mapconv::test::twoLevels;
using mrpt_mapconv::testing::TempDir;

TEST(TerrainFiles, LayersHaveNamesUnitsAndKinds)
{
  const TerrainLayers layers = twoLevels().layers();
  const auto all = styled(layers);
  std::string names;
  for (const auto& layer : all) names += layer.name + " [" + layer.unit + "] ";
  EXPECT_EQ(names, "height [m] sigma [m] plane [] leafSide [m] slope [m/m] traversability [] ");
  EXPECT_EQ(grid::findLayer(all, "plane").kind, grid::LayerKind::Plane);
  EXPECT_EQ(grid::findLayer(all, "traversability").layer, &layers.traversability);
  const auto leaves = styledLeaves(layers);
  EXPECT_EQ(leaves.layer, &layers.plane);
  EXPECT_EQ(leaves.squares, &layers.leafSide);
  EXPECT_EQ(leaves.shade, &layers.height);
}

/** By hand: 64 cells each, from the edge of the first to that of the last. */
TEST(TerrainFiles, PlanesAreATable)
{
  EXPECT_EQ(
      planesCsv(twoLevels().planes()),
      "plane,cells,x,y,z,slope,slopeX,slopeY,rms,xMin,yMin,xMax,yMax\n"
      "0,64,0.3500,0.3500,0.0000,0.00000,0.00000,0.00000,0.00000,-0.0500,-0.0500,0.7500,0.7500\n"
      "1,64,1.1500,0.3500,0.5000,0.00000,0.00000,0.00000,0.00000,0.7500,-0.0500,1.5500,0.7500\n");
  EXPECT_EQ(planesCsv({}), "plane,cells,x,y,z,slope,slopeX,slopeY,rms,xMin,yMin,xMax,yMax\n");
}

TEST(TerrainFiles, StepsAreATable)
{
  TerrainStep step;
  step.lower = 3;
  step.upper = 1;
  step.height = 0.15;
  step.depth = 0.3;
  step.width = 1.2;
  step.x = -1;
  step.y = 2.5;
  step.directionX = -1;
  EXPECT_EQ(stepsCsv({step}),
            "lower,upper,height,depth,width,x,y,directionX,directionY\n"
            "3,1,0.1500,0.3000,1.2000,-1.0000,2.5000,-1.0000,0.0000\n");
}

TEST(TerrainFiles, EverythingIsExported)
{
  const TempDir dir;
  const TerrainMap map = twoLevels();
  const TerrainLayers layers = map.layers();
  grid::ExportFormats formats{"layers.tif"};
  formats.pictures = formats.gridMaps = formats.rosMaps = true;
  {
    files::OutputDir out(dir.path());
    exportTerrain(out, map, layers, formats);
    out.commit();
  }
  for (const char* name :
       {"layers.tif", "height.png", "sigma.png", "plane.png", "leafSide.png", "slope.png",
        "traversability.png", "traversability.gridmap", "traversability.pgm", "traversability.yaml",
        "leaves.png", "planes.csv", "steps.csv"})
    EXPECT_TRUE(std::filesystem::exists(dir.path(name))) << name;
  EXPECT_EQ(dir.entries(), 13u);
  const auto plane = grid::readGeoTiffBand(dir.path("layers.tif"), "plane");
  EXPECT_EQ(plane.frame(), layers.plane.frame());
  EXPECT_EQ(plane.cells().at(plane.frame().indexOfKey(3, 3)), 0);
  EXPECT_EQ(plane.cells().at(plane.frame().indexOfKey(12, 3)), 1);
  EXPECT_TRUE(std::isnan(plane.cells().at(plane.frame().indexOfKey(20, 0))));
  EXPECT_EQ(grid::readGeoTiffMetadata(dir.path("layers.tif")).at("heightRule"), "fused");
}
