#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <limits>

#include "TerrainFixtures.h"
#include "support/ThrownMessage.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

TEST(CTerrainGridMap2D, ANewMapIsEmptyAndUnknown)
{
  const CTerrainGridMap2D map(0.1);
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.cellSize(), 0.1);
  EXPECT_EQ(map.terrain().cells(), 0u);
  EXPECT_EQ(map.getPos(0, 0), 0.5f);
  float low = 0, high = 0;
  EXPECT_FALSE(map.getMinMaxHeight(low, high));
  EXPECT_THROW(CTerrainGridMap2D(0), std::invalid_argument);
  EXPECT_THROW(CTerrainGridMap2D(0.1, withMaxStep(-1)), std::invalid_argument);
}

TEST(CTerrainGridMap2D, TheGridShowsWhereTheTerrainIsTraversable)
{
  const auto high = stepMap(withMaxStep(0.1)), low = stepMap(withMaxStep(0.2));
  for (const float x : {-0.9f, -0.5f, 0.5f, 0.9f})
    for (const auto* map : {&high, &low}) EXPECT_GT(map->getPos(x, 0.3f), 0.9f) << x;
  for (const float x : {0.0f, 0.1f})
  {
    EXPECT_LT(high.getPos(x, 0.3f), 0.1f) << "0.15 m is too high a step";
    EXPECT_GT(low.getPos(x, 0.3f), 0.9f);
  }
  for (const float x : {-1.2f, 1.2f}) EXPECT_EQ(high.getPos(x, 0), 0.5f) << "unknown";
}

TEST(CTerrainGridMap2D, ItsCellsAreCentredOnMultiplesOfTheResolution)
{
  const auto map = stepMap();
  EXPECT_EQ(map.layers().height.frame().shift, -0.5);
  EXPECT_FLOAT_EQ(map.getXMin(), -0.95f);
  EXPECT_EQ(map.x2idx(0.0f), 9);
  EXPECT_EQ(map.x2idx(0.049f), 9);
  EXPECT_EQ(map.x2idx(0.051f), 10);
}

TEST(CTerrainGridMap2D, FindsPlanesAndTheirStep)
{
  const auto map = stepMap();
  ASSERT_EQ(map.terrain().planes().size(), 2u);
  EXPECT_LT(map.terrain().leaves(), map.terrain().cells() / 2);
  const auto steps = map.terrain().steps();
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_NEAR(steps[0].height, 0.15, 0.001);
}

TEST(CTerrainGridMap2D, IsAlsoAHeightMap)
{
  const auto map = stepMap();
  const mrpt::maps::CHeightGridMap2D_Base& heights = map;
  EXPECT_EQ(heights.dem_get_resolution(), 0.1);
  EXPECT_EQ(heights.dem_get_size_x(), static_cast<std::size_t>(map.getSizeX()));
  EXPECT_EQ(heights.dem_get_size_y(), static_cast<std::size_t>(map.getSizeY()));
  double z = -9;
  for (const double x : {-0.7, 0.7})
  {
    EXPECT_TRUE(heights.dem_get_z(x, 0.2, z));
    EXPECT_NEAR(z, x < 0 ? 0 : 0.15, 1e-3);
    const auto cx = static_cast<std::size_t>(map.x2idx(static_cast<float>(x)));
    const auto cy = static_cast<std::size_t>(map.y2idx(0.2f));
    EXPECT_TRUE(heights.dem_get_z_by_cell(cx, cy, z));
    EXPECT_NEAR(z, x < 0 ? 0 : 0.15, 1e-3);
  }
  z = -9;
  EXPECT_FALSE(heights.dem_get_z(5, 0, z));
  EXPECT_FALSE(heights.dem_get_z_by_cell(map.getSizeX(), 0, z));
  EXPECT_FALSE(heights.dem_get_z_by_cell(0, map.getSizeY(), z));
  EXPECT_EQ(z, -9);
  float low = 0, high = 0;
  ASSERT_TRUE(heights.getMinMaxHeight(low, high));
  EXPECT_NEAR(low, 0, 1e-3);
  EXPECT_NEAR(high, 0.15, 1e-3);
}

TEST(CTerrainGridMap2D, TakesSinglePoints)
{
  CTerrainGridMap2D map(0.1);
  EXPECT_TRUE(map.insertIndividualPoint(1.04, 2.04, 3));
  EXPECT_FALSE(map.isEmpty());
  double z = 0;
  ASSERT_TRUE(map.dem_get_z(0.96, 1.96, z));
  EXPECT_NEAR(z, 3, 1e-4);
  EXPECT_GT(map.getPos(1, 2), 0.9f) << "the grid follows";

  mrpt::maps::CHeightGridMap2D_Base::TPointInsertParams later;
  later.update_map_after_insertion = false;
  later.pt_z_std = 0.5;
  EXPECT_TRUE(map.insertIndividualPoint(1.5, 2, 3, later));
  EXPECT_EQ(map.getPos(1.5f, 2), 0.5f);
  map.dem_update_map();
  EXPECT_GT(map.getPos(1.5f, 2), 0.9f);
  EXPECT_NEAR(map.terrain().cell(15, 20)->variance, 0.25, 0.01);
  const double sigma = map.terrainInsertionOptions.sigmas.range;
  EXPECT_NEAR(map.terrain().cell(10, 20)->variance, sigma * sigma, 0.01 * sigma * sigma);
}

TEST(CTerrainGridMap2D, RefusesSinglePointsThatItCannotHold)
{
  auto map = stepMap();
  const auto before = map;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(map.insertIndividualPoint(nan, 0, 0));
  EXPECT_FALSE(map.insertIndividualPoint(0, 0, nan));
  EXPECT_FALSE(map.insertIndividualPoint(1e12, 0, 0));
  EXPECT_FALSE(map.insertIndividualPoint(1e5, 1e5, 0)) << "more than maxGridCells";
  expectSameTerrain(map, before);
}

TEST(CTerrainGridMap2D, LeavesOutWhatLiesBeyondItsLimits)
{
  CTerrainGridMap2D map(0.1);
  auto& limits = map.terrainInsertionOptions.limits;
  double z = 0;
  ASSERT_TRUE(map.insertObservation(stepScan(), CPose3D()));
  ASSERT_TRUE(map.dem_get_z(0.4, 0.4, z));
  EXPECT_NEAR(z, 0.15, 1e-3) << "and not between the floor and the ceiling";

  map.clear();
  limits.maxHeight = 0.1;
  ASSERT_TRUE(map.insertObservation(stepScan(), CPose3D()));
  EXPECT_FALSE(map.dem_get_z(0.4, 0.4, z));
  EXPECT_TRUE(map.dem_get_z(-0.4, 0.4, z));

  map.clear();  // heights are above the robot's base
  ASSERT_TRUE(map.insertObservation(stepScan(), CPose3D(0, 0, 50, 0, 0, 0)));
  EXPECT_TRUE(map.dem_get_z(-0.4, 0.4, z));
  EXPECT_NEAR(z, 50, 1e-3);

  map.clear();
  limits.minHeight = 0.05;
  limits.maxHeight = 0.2;
  ASSERT_TRUE(map.insertObservation(stepScan(), CPose3D()));
  EXPECT_FALSE(map.dem_get_z(-0.4, 0.4, z));

  map.clear();
  limits = {};
  limits.maxRange = 1.1;
  ASSERT_TRUE(map.insertObservation(stepScan(), CPose3D()));
  EXPECT_TRUE(map.dem_get_z(0.2, 0.2, z));
  EXPECT_FALSE(map.dem_get_z(-0.8, 0.2, z));
}

TEST(CTerrainGridMap2D, BelievesTheSigmasOfItsOptions)
{
  CTerrainGridMap2D sure(0.1), unsure(0.1);
  unsure.terrainInsertionOptions.sigmas.height = 0.5;
  for (auto* map : {&sure, &unsure}) map->insertObservation(stepScan(), CPose3D());
  const auto a = sure.terrain().cell(5, 5), b = unsure.terrain().cell(5, 5);
  ASSERT_TRUE(a && b);
  EXPECT_GT(b->variance, 100 * a->variance);
}

TEST(CTerrainGridMap2D, SaysWhyAScanIsSkipped)
{
  auto map = stepMap();
  const auto before = map;
  EXPECT_FALSE(map.insertObservation(stepScan(), CPose3D(std::nan(""), 0, 0)));
  EXPECT_EQ(map.lastSkip(), "its pose is not finite");
  map.terrainInsertionOptions.limits.maxRange = 0.1;
  EXPECT_FALSE(map.insertObservation(stepScan(), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "it has no point within maxRange, minHeight and maxHeight");
  mrpt::obs::CObservationPointCloud empty;
  empty.pointcloud = mrpt::maps::CSimplePointsMap::Create();
  EXPECT_FALSE(map.insertObservation(empty, CPose3D()));
  EXPECT_EQ(map.lastSkip(), "it has no usable point");
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservation2DRangeScan(), CPose3D()));
  expectSameTerrain(map, before);
}

TEST(CTerrainGridMap2D, ARefusedScanLeavesTheMapAsItWas)
{
  auto map = stepMap();
  const auto before = map;
  const auto refused = [&](const CPose3D& pose)
  { return test::thrownMessage<std::exception>([&] { map.insertObservation(stepScan(), pose); }); };
  EXPECT_NE(refused(CPose3D(1e5, 1e5, 0)).find("maxGridCells = 1e+08"), std::string::npos);
  EXPECT_NE(refused(CPose3D(1e12, 0, 0)).find("too far"), std::string::npos);
  map.maxGridCells = 400;
  EXPECT_NE(refused(CPose3D()).find("maxGridCells = 400: the layers would have 20 x 21 = 420"),
            std::string::npos)
      << refused(CPose3D());
  map.maxGridCells = 1e8;
  map.terrainInsertionOptions.sigmas.range = -1;
  EXPECT_NE(refused(CPose3D()).find("rangeSigma = -1"), std::string::npos);
  expectSameTerrain(map, before);
}

TEST(CTerrainGridMap2D, TheOrderOfScansDoesNotMatter)
{
  CTerrainGridMap2D a(0.1), b(0.1);
  for (const float x : {0.0f, 1.0f, 2.0f}) a.insertObservation(stepScan(x), CPose3D());
  for (const float x : {2.0f, 0.0f, 1.0f}) b.insertObservation(stepScan(x), CPose3D());
  EXPECT_EQ(a.terrain().cells(), b.terrain().cells());
  for (std::int32_t ky = -10; ky <= 10; ++ky)
    for (std::int32_t kx = -10; kx <= 30; ++kx)
    {
      const auto of = [&](const CTerrainGridMap2D& map) { return map.terrain().cell(kx, ky); };
      ASSERT_TRUE(of(a) && of(b));
      ASSERT_EQ(of(a)->height, of(b)->height);
      ASSERT_EQ(of(a)->points, of(b)->points);
    }
}

TEST(CTerrainGridMap2D, ALocalWindowForgetsWhatIsFarBehind)
{
  terrain::TTerrainOptions options;
  options.params.localWindow = 4;
  CTerrainGridMap2D map(0.1, options);
  map.insertObservation(stepScan(), CPose3D());
  EXPECT_GT(map.getPos(-0.5f, 0), 0.9f);
  map.insertObservation(stepScan(), CPose3D(5000, 0, 0));  // too far for layers that hold both
  EXPECT_EQ(map.getPos(-0.5f, 0), 0.5f);
  EXPECT_GT(map.getPos(4999.5f, 0), 0.9f);
  EXPECT_EQ(map.terrain().planes().size(), 2u);
}

TEST(CTerrainGridMap2D, ClearForgetsTheCellsAndKeepsTheOptions)
{
  auto map = stepMap(withMaxStep(0.1));
  map.terrainInsertionOptions.limits.maxRange = 7;
  map.clear();
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.terrain().cells(), 0u);
  EXPECT_TRUE(map.layers().height.frame().empty());
  EXPECT_EQ(map.terrain().params().maxStep, 0.1);
  EXPECT_EQ(map.terrainInsertionOptions.limits.maxRange, 7);
  map.insertObservation(stepScan(), CPose3D());
  expectSameTerrain(map, stepMap(withMaxStep(0.1)));
}

TEST(CTerrainGridMap2D, ACopyIsIndependent)
{
  auto map = stepMap();
  mrpt::maps::CMultiMetricMap particle;
  particle.maps.push_back(std::make_shared<CTerrainGridMap2D>(map));
  const mrpt::maps::CMultiMetricMap copied(particle);
  CTerrainGridMap2D assigned(0.3);
  assigned = map;
  map.clear();
  expectSameTerrain(*copied.mapByClass<CTerrainGridMap2D>(), stepMap());
  expectSameTerrain(assigned, stepMap());
  EXPECT_EQ(assigned.cellSize(), 0.1);
}

TEST(CTerrainGridMap2D, AGridResizedBehindItsBackIsLaidOutAnew)
{
  auto map = stepMap();
  const auto right = map.getRawMap();
  map.resizeGrid(-50, 50, -50, 50);
  const CTerrainGridMap2D copy(map);
  EXPECT_TRUE(copy.getRawMap() == right);
  map.auxParticleFilterCleanUp();
  EXPECT_TRUE(map.getRawMap() == right);
  EXPECT_FLOAT_EQ(map.getXMin(), -0.95f);
  map.setSize(-0.9f, 1.1f, -1, 1.1f, 0.1f);  // as many cells, half a cell farther on
  map.auxParticleFilterCleanUp();
  EXPECT_TRUE(map.getRawMap() == right);
  EXPECT_FLOAT_EQ(map.getXMin(), -0.95f);
}

TEST(CTerrainGridMap2D, DescribesItselfInNumbersAndLayers)
{
  const auto map = stepMap();
  const auto text = map.describe();
  EXPECT_EQ(text.name, "terrain");
  const std::pair<std::string, std::string> planes{"planes", "2"}, steps{"steps", "1"};
  EXPECT_EQ(std::count(text.lines.begin(), text.lines.end(), planes), 1);
  EXPECT_EQ(std::count(text.lines.begin(), text.lines.end(), steps), 1);
  const std::pair<std::string, std::string> layer{"height", "Height [m]"};
  EXPECT_EQ(std::count(text.lines.begin(), text.lines.end(), layer), 1);
  EXPECT_EQ(text.values.at(0).first, "knownCells");
  EXPECT_EQ(std::get<std::int32_t>(text.values.at(0).second),
            static_cast<std::int32_t>(map.terrain().cells()));
  EXPECT_NE(map.asString().find("2 planes"), std::string::npos);
}
