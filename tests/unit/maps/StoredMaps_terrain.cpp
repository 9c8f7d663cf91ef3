#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include "StoredMaps.h"

namespace mrpt_mapconv::fixtures
{
using mrpt::poses::CPose3D;

namespace
{
terrain::TTerrainOptions storedTerrainOptions()
{
  terrain::TTerrainOptions options;
  options.params.heightRule = terrain::HeightRule::Maximum;
  options.params.planeTolerance = 0.0625;
  options.params.planeWindow = 0.5;
  options.params.hypotheses = 8;
  options.params.blockCells = 4;
  options.params.minPlaneCells = 6;
  options.params.maxPlaneSlope = 0.75;
  options.params.maxSlope = 0.25;
  options.params.maxStep = 0.125;
  options.params.localWindow = 8;
  return options;
}

void setOptions(CTerrainGridMap2D& map)
{
  map.maxGridCells = 1e5;
  auto& limits = map.terrainInsertionOptions.limits;
  limits.maxRange = 16;
  limits.minHeight = -4;
  limits.maxHeight = 1.5;
  auto& sigmas = map.terrainInsertionOptions.sigmas;
  sigmas.range = 0.03125;
  sigmas.beam = 0.0625;
  sigmas.height = 0.125;
  sigmas.roll = 0.5;
  sigmas.pitch = 0.25;
  map.renderingOptions.showLeaves = false;
  map.renderingOptions.showOutlines = false;
}
}  // namespace

CTerrainGridMap2D storedTerrainMap()
{
  CTerrainGridMap2D map(0.25, storedTerrainOptions());
  setOptions(map);
  mrpt::obs::CObservationPointCloud scan;
  scan.sensorPose = CPose3D(0, 0, 1, 0, 0, 0);
  scan.pointcloud = mrpt::maps::CSimplePointsMap::Create();
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 4; ++y)
      scan.pointcloud->insertPoint(0.25f * static_cast<float>(x), 0.25f * static_cast<float>(y),
                                   x < 4 ? -1 : -0.5f);
  for (const double x : {0.0, 0.25})
    EXPECT_TRUE(map.insertObservation(scan, CPose3D(x, 0, 0, 0, 0, 0)));
  setGridOptions(map);  // at last: they forbid to insert
  return map;
}

void expectStoredTerrainOptions(const CTerrainGridMap2D& map)
{
  EXPECT_EQ(0.25, map.cellSize());
  EXPECT_EQ(1e5, map.maxGridCells);
  const terrain::TerrainParams& params = map.terrain().params();
  EXPECT_EQ(terrain::HeightRule::Maximum, params.heightRule);
  EXPECT_EQ(0.0625, params.planeTolerance);
  EXPECT_EQ(0.5, params.planeWindow);
  EXPECT_EQ(8, params.hypotheses);
  EXPECT_EQ(4, params.blockCells);
  EXPECT_EQ(6, params.minPlaneCells);
  EXPECT_EQ(0.75, params.maxPlaneSlope);
  EXPECT_EQ(0.25, params.maxSlope);
  EXPECT_EQ(0.125, params.maxStep);
  EXPECT_EQ(8, params.localWindow);
  EXPECT_EQ(16, map.terrainInsertionOptions.limits.maxRange);
  EXPECT_EQ(-4, map.terrainInsertionOptions.limits.minHeight);
  EXPECT_EQ(1.5, map.terrainInsertionOptions.limits.maxHeight);
  EXPECT_EQ(0.03125, map.terrainInsertionOptions.sigmas.range);
  EXPECT_EQ(0.0625, map.terrainInsertionOptions.sigmas.beam);
  EXPECT_EQ(0.125, map.terrainInsertionOptions.sigmas.height);
  EXPECT_EQ(0.5, map.terrainInsertionOptions.sigmas.roll);
  EXPECT_EQ(0.25, map.terrainInsertionOptions.sigmas.pitch);
  EXPECT_FALSE(map.renderingOptions.showLeaves);
  EXPECT_FALSE(map.renderingOptions.showOutlines);
  expectGridOptions(map);
}

/** Of two points in a cell the higher one counts, so that the step stays before the key 4. */
void expectStoredTerrainCells(const CTerrainGridMap2D& map)
{
  EXPECT_FALSE(map.isEmpty());
  const grid::GridFrame frame = map.layers().height.frame();
  ASSERT_EQ((grid::GridFrame{0.25, 0, 0, 9, 4, -0.5}), frame);
  EXPECT_EQ(36u, map.terrain().cells());
  EXPECT_EQ(2u, map.terrain().planes().size());
  EXPECT_EQ(6u, map.terrain().leaves()) << "two of 4 x 4 cells, and four cells at the key 8";
  EXPECT_EQ(-0.125f, map.getXMin());
  EXPECT_EQ(2.125f, map.getXMax());
  for (std::int32_t ky = 0; ky < 4; ++ky)
    for (std::int32_t kx = 0; kx < 9; ++kx)
    {
      SCOPED_TRACE(kx);
      const auto at = frame.indexOfKey(kx, ky);
      EXPECT_NEAR(kx < 4 ? 0 : 0.5, map.layers().height.cells()[at], 1e-6);
      EXPECT_EQ(kx < 4 ? 0 : 1, map.layers().plane.cells()[at]);
      EXPECT_EQ(kx < 8 ? 1.0f : 0.25f, map.layers().leafSide.cells()[at]);
      EXPECT_EQ(kx == 3 || kx == 4 ? -127 : 127, static_cast<int>(map.getRawMap()[at]));
      EXPECT_EQ(kx == 0 || kx == 8 ? 1u : 2u, map.terrain().cell(kx, ky)->points);
    }
}

}  // namespace mrpt_mapconv::fixtures
