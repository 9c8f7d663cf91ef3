// What bad input gets: one clear line, or a correct plain map.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "HandTerrain.h"
#include "support/ThrownMessage.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;
using terrain::TerrainParams;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expectRefused(const TerrainParams& params, const std::string& name, const std::string& value)
{
  expectNames(thrownMessage<std::invalid_argument>([&] { TerrainMap(kCell, params); }), name,
              value);
}

/** A map of single cells, all as they were put. */
void expectPlain(TerrainMap& map)
{
  map.update();
  EXPECT_TRUE(map.planes().empty());
  EXPECT_EQ(map.leaves(), map.cells());
  EXPECT_TRUE(map.steps().empty());
  map.extract();
  EXPECT_TRUE(map.planes().empty());
  EXPECT_EQ(map.leaves(), map.cells());
}

std::string thrownByInsert(const HandScan& hand, TerrainMap& map)
{
  return thrownMessage<std::runtime_error>([&] { map.insert(hand.scan(), {}); });
}
}  // namespace

TEST(TerrainErrors, ResolutionMustBeOne)
{
  for (const double l : {0.0, -0.05, kNaN, kInfinity, 1e-9})
    EXPECT_THROW(TerrainMap{l}, std::invalid_argument) << l;
  expectNames(thrownMessage<std::invalid_argument>([] { TerrainMap(-0.05); }), "resolution",
              "-0.05");
}

TEST(TerrainErrors, ParametersAreNamed)
{
  TerrainParams params;
  params.hypotheses = 0;
  expectRefused(params, "hypotheses", "0");
  params = {};
  params.hypotheses = 65;
  expectRefused(params, "hypotheses", "65");
  params = {};
  params.blockCells = 0;
  expectRefused(params, "blockCells", "0");
  params = {};
  params.minPlaneCells = 2;
  expectRefused(params, "minPlaneCells", "2");
  params = {};
  params.planeTolerance = 0;
  expectRefused(params, "planeTolerance", "0");
  params = {};
  params.planeWindow = -1;
  expectRefused(params, "planeWindow", "-1");
  params = {};
  params.maxPlaneSlope = kNaN;
  expectRefused(params, "maxPlaneSlope", "nan");
  params = {};
  params.maxStep = -1;
  expectRefused(params, "maxStep", "-1");
  params = {};
  params.maxSlope = -2;
  expectRefused(params, "maxSlope", "-2");
  params = {};
  params.maxPlaneSlope = 0.4;
  expectRefused(params, "maxSlope", "0.5");
  params = {};
  params.localWindow = -3;
  expectRefused(params, "localWindow", "-3");
}

TEST(TerrainErrors, SigmasAreNamed)
{
  TerrainMap map(kCell);
  HandScan hand;
  hand.add(0, 0, 0);
  terrain::PointSigmas sigmas;
  sigmas.range = -0.5;
  expectNames(thrownMessage<std::invalid_argument>([&] { map.insert(hand.scan(), sigmas); }),
              "rangeSigma", "-0.5");
  expectNames(thrownMessage<std::invalid_argument>([&] { map.insertPoint(0, 0, 0, -2); }), "sigma",
              "-2");
  EXPECT_EQ(map.cells(), 0u);
}

TEST(TerrainErrors, CovariancesMustBeSome)
{
  TerrainMap map(kCell);
  HandScan hand;
  hand.add(0, 0, 0);
  auto scan = hand.scan();
  scan.poseCovariance(1, 1) = -1;
  EXPECT_NE(thrownMessage<std::invalid_argument>([&] { map.insert(scan, {}); }).find("roll"),
            std::string::npos);
  scan.poseCovariance(1, 1) = 0.01;
  scan.poseCovariance(0, 1) = scan.poseCovariance(1, 0) = 0.5;  // more than both variances allow
  EXPECT_THROW(map.insert(scan, {}), std::invalid_argument);
  EXPECT_EQ(map.cells(), 0u);
}

TEST(TerrainErrors, PosesMustBeFinite)
{
  TerrainMap map(kCell);
  HandScan hand;
  hand.add(0, 0, 0);
  hand.robotPose.x(kNaN);
  EXPECT_THROW(map.insert(hand.scan(), {}), std::invalid_argument);
  hand.robotPose.x(0);
  hand.sensorPose.z(kInfinity);
  EXPECT_THROW(map.insert(hand.scan(), {}), std::invalid_argument);
  EXPECT_EQ(map.cells(), 0u);
}

TEST(TerrainErrors, EmptyScansAddNothing)
{
  TerrainMap map(kCell);
  const auto inserted = map.insert(HandScan().scan(), {});
  EXPECT_EQ(inserted.inserted + inserted.notFinite + inserted.outside, 0u);
  expectPlain(map);
  EXPECT_TRUE(map.layers().height.frame().empty());
}

TEST(TerrainErrors, OnePointIsAPlainMap)
{
  TerrainMap map(kCell);
  HandScan hand;
  hand.add(1, 1, 0.5);
  map.insert(hand.scan(), {});
  expectPlain(map);
  EXPECT_EQ(map.cells(), 1u);
  EXPECT_EQ(map.at(1, 1)->height, 0.5);
  EXPECT_EQ(map.at(1, 1)->plane, -1);
}

TEST(TerrainErrors, PointsThatAreNotFiniteAreLeftOut)
{
  TerrainMap map(kCell);
  HandScan hand;
  hand.sensorPose = mrpt::poses::CPose3D(3, 3, 0, 0, 0, 0);
  for (const double bad : {kNaN, kInfinity, -kInfinity})
  {
    hand.add(bad, 0, 0);
    hand.add(0, bad, 0);
    hand.add(0, 0, bad);
  }
  hand.add(1, 1, 1);
  const auto inserted = map.insert(hand.scan(), {});
  EXPECT_EQ(inserted.notFinite, 9u);
  EXPECT_EQ(inserted.inserted, 1u);
  EXPECT_EQ(map.cells(), 1u);
  map.insertPoint(kNaN, 0, 0, 0.1);
  map.insertPoint(0, 0, kInfinity, 0.1);
  EXPECT_EQ(map.cells(), 1u);
}

TEST(TerrainErrors, CellsOnOneLineAreAPlainMap)
{
  TerrainMap map(kCell), diagonal(kCell);
  for (int i = -50; i < 50; ++i)
  {
    put(map, i, 7, 0);
    put(diagonal, i, i, 0);
  }
  expectPlain(map);
  expectPlain(diagonal);
}

TEST(TerrainErrors, VerticalWallsAloneAreAPlainMap)
{
  TerrainMap map(kCell);
  for (int i = 0; i < 60; ++i)
    for (double z = 0; z < 3; z += 0.05)
    {
      put(map, i, 0, z);
      put(map, 0, i, z);
    }
  map.update();
  EXPECT_EQ(map.cells(), 119u);
  // two lines that meet, of one mean height: cells of a plane by its definition
  EXPECT_LE(map.planes().size(), 1u);
  TerrainMap one(kCell);
  for (int i = 0; i < 60; ++i)
    for (double z = 0; z < 3; z += 0.05) put(one, i, 0, z);
  expectPlain(one);
}

TEST(TerrainErrors, RubbleIsAPlainMap)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 60, 60, [](int x, int y) { return 0.37 * ((x * 7 + y * 13) % 11); });
  expectPlain(map);
  EXPECT_EQ(map.cells(), 61u * 61u);
}

TEST(TerrainErrors, TooSteepPlanesAreAPlainMap)
{
  TerrainMap map(kCell);
  putAll(map, 0, 0, 30, 30, [](int x, int) { return 1.5 * kCell * x; });
  expectPlain(map);
}

TEST(TerrainErrors, PointsBeyondTheKeysAreRefusedAndTheMapIsAsItWas)
{
  TerrainMap map(kCell);
  put(map, 0, 0, 1);
  HandScan hand;
  hand.add(1, 1, 1);
  hand.add(1e9, 1, 1);
  EXPECT_NE(thrownByInsert(hand, map).find("1000000000.0"), std::string::npos);
  HandScan high;
  high.add(1, 1, 70000);
  EXPECT_NE(thrownByInsert(high, map).find("70000.0"), std::string::npos);
  HandScan far;
  far.sensorPose = mrpt::poses::CPose3D(1e15, 0, 0, 0, 0, 0);
  far.add(1, 1, 1);
  EXPECT_NE(thrownByInsert(far, map), "");
  EXPECT_THROW(map.insertPoint(0, -1e9, 0, 0.1), std::runtime_error);
  EXPECT_THROW(map.insertPoint(0, 0, -1e9, 0.1), std::runtime_error);
  EXPECT_EQ(map.cells(), 1u);
}

TEST(TerrainErrors, TheLastKeysAreGood)
{
  TerrainMap map(kCell);
  const double last = ((1 << 30) - 2) * kCell;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) map.insertPoint(last - i * kCell, -last + j * kCell, 100, 0.01);
  map.update();
  EXPECT_EQ(map.cells(), 100u);
  ASSERT_EQ(map.planes().size(), 1u);
  EXPECT_NEAR(map.at(last, -last)->height, 100, 1e-3);
}

/** A robot that is lost takes its window with it, or is refused; nothing else. */
TEST(TerrainErrors, ALocalWindowBeyondTheKeysIsRefused)
{
  TerrainParams params;
  params.localWindow = 4;
  TerrainMap map(kCell, params);
  put(map, 0, 0, 1);
  HandScan lost;
  lost.robotPose = mrpt::poses::CPose3D(1e15, 0, 0, 0, 0, 0);
  EXPECT_THROW(map.insert(lost.scan(), {}), std::runtime_error);
  EXPECT_EQ(map.cells(), 1u);
}
