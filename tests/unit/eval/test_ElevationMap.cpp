#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/ElevationMap.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace mrpt_mapconv;
using eval::ElevationMap;
using eval::ElevationMapParams;
using mrpt::poses::CPose3D;

namespace
{
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kVariance = 1e-4;  // of points [m²]

/** Points in the map's frame whose heights have all the same variance. */
struct PlainScan
{
  std::vector<float> x, y, z;

  explicit PlainScan(const std::vector<std::array<float, 3>>& points)
  {
    for (const auto& p : points)
    {
      x.push_back(p[0]);
      y.push_back(p[1]);
      z.push_back(p[2]);
    }
  }
  terrain::TerrainScan scan() const
  {
    terrain::TerrainScan scan;
    scan.x = x.data();
    scan.y = y.data();
    scan.z = z.data();
    scan.points = x.size();
    scan.poseCovariance.setZero();
    scan.poseCovariance(0, 0) = kVariance;
    return scan;
  }
};

const terrain::PointSigmas kOfPoseOnly{0, 0, 0, 0, 0};

terrain::InsertedPoints insert(ElevationMap& map, const std::vector<std::array<float, 3>>& points)
{
  return map.insert(PlainScan(points).scan(), kOfPoseOnly);
}

/** Of the cell with key (0, 0). */
double heightOf(const ElevationMap& map)
{
  const auto layer = map.height();
  return static_cast<double>(layer.cells()[layer.frame().indexOfKey(0, 0)]);
}
double varianceOf(const ElevationMap& map)
{
  const auto layer = map.variance();
  return static_cast<double>(layer.cells()[layer.frame().indexOfKey(0, 0)]);
}

/** What is never limited, so that single points can be looked at. */
ElevationMapParams unlimited()
{
  ElevationMapParams params;
  params.minVariance = 0;
  params.maxVariance = std::numeric_limits<double>::infinity();
  return params;
}
}  // namespace

TEST(ElevationMap, CellsAreCentredOnMultiplesOfTheResolution)
{
  ElevationMap map(0.1);
  EXPECT_TRUE(map.frame().empty());
  insert(map, {{-0.051f, 0, 1}, {0.049f, 0, 2}, {0.051f, 0.26f, 3}});
  EXPECT_EQ(map.frame(), (grid::GridFrame{0.1, -1, 0, 3, 4, -0.5}));
  EXPECT_EQ(map.height().at(0, 0), 1);
  EXPECT_EQ(map.height().at(1, 0), 2);
  EXPECT_EQ(map.height().at(2, 3), 3);
  EXPECT_TRUE(std::isnan(map.height().at(0, 1)));
  EXPECT_TRUE(std::isnan(map.variance().at(0, 1)));
}

TEST(ElevationMap, APointsVarianceIsThatOfBeamAndPose)
{
  // a sensor 1 m above the robot, which looks along x; the point is 3 m ahead and 1 m up
  terrain::TerrainScan scan = PlainScan({}).scan();
  const float x = 3, y = 0, z = 1;
  scan.x = &x;
  scan.y = &y;
  scan.z = &z;
  scan.points = 1;
  scan.sensorPose = CPose3D(0, 0, 1, 0, 0, 0);
  scan.poseCovariance.setZero();
  scan.poseCovariance(0, 0) = 1e-4;
  scan.poseCovariance(2, 2) = 1e-6;  // pitch: the point is lifted by 3 m for 1 rad
  scan.poseCovariance(1, 1) = 4e-6;  // roll: it is straight ahead
  ElevationMap map(0.1, unlimited());
  map.insert(scan, {0.02, 0.001, 0, 0, 0});
  const double along = 0.02 * 0.02 * 1 / 10, across = 0.001 * 0.001 * 9;
  const auto layer = map.variance();
  EXPECT_NEAR(layer.cells()[layer.frame().indexOfKey(30, 0)], along + across + 1e-4 + 9e-6, 1e-7);
}

TEST(ElevationMap, PointsAreFusedByTheirVariances)
{
  ElevationMap map(0.1, unlimited());
  insert(map, {{0, 0, 1}, {0, 0, 1.01f}});
  EXPECT_NEAR(heightOf(map), 1.005, 1e-5);
  EXPECT_NEAR(varianceOf(map), kVariance / 2, 1e-8);
  insert(map, {{0, 0, 1.02f}});
  EXPECT_NEAR(heightOf(map), 1.01, 2e-5);
  EXPECT_NEAR(varianceOf(map), kVariance / 3, 1e-8);
}

TEST(ElevationMap, AFarPointOfTheSameScanReplacesALowerHeight)
{
  ElevationMap map(0.1, unlimited());
  insert(map, {{0, 0, 1}, {0, 0, 1}, {0, 0, 0.5f}});
  EXPECT_NEAR(heightOf(map), 1, 1e-6) << "lower";
  EXPECT_NEAR(varianceOf(map), kVariance / 2, 1e-8);
  insert(map, {{0, 0, 1}, {0, 0, 1.5f}});
  EXPECT_NEAR(heightOf(map), 1.5, 1e-6) << "higher";
  EXPECT_NEAR(varianceOf(map), kVariance, 1e-8);
}

TEST(ElevationMap, AFarPointOfALaterScanAddsToTheVariance)
{
  ElevationMap map(0.1, unlimited());
  insert(map, {{0, 0, 1}, {0, 0, 1}});
  insert(map, {{0, 0, 0.5f}, {0, 0, 1.5f}});
  EXPECT_NEAR(heightOf(map), 1, 1e-6);
  EXPECT_NEAR(varianceOf(map), kVariance / 2 + 2 * 9e-6, 1e-8);
}

TEST(ElevationMap, WithoutAThresholdItIsTheWeightedMean)
{
  ElevationMapParams params = unlimited();
  params.mahalanobisDistanceThreshold = kInfinity;
  ElevationMap map(0.1, params);
  insert(map, {{0, 0, 1}, {0, 0, 2}, {0, 0, 6}});
  EXPECT_NEAR(heightOf(map), 3, 1e-5);
  EXPECT_NEAR(varianceOf(map), kVariance / 3, 1e-8);
}

TEST(ElevationMap, VariancesAreLimitedBetweenScans)
{
  ElevationMapParams params;
  params.minVariance = kVariance / 2;
  params.maxVariance = 2 * kVariance;
  params.multiHeightNoise = 1.5 * kVariance;
  ElevationMap map(0.1, params);
  insert(map, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  EXPECT_NEAR(varianceOf(map), kVariance / 2, 1e-9) << "a third without limit";
  insert(map, {{0, 0, 1.006f}});  // gain 1/3 of a variance of a half, not 1/4 of a third
  EXPECT_NEAR(heightOf(map), 1.002, 2e-5);
  insert(map, {{0, 0, 2}});
  EXPECT_TRUE(map.height().cells().size() == 1 && std::isnan(map.height().cells()[0]));
  insert(map, {{0, 0, 3}});
  EXPECT_NEAR(heightOf(map), 3, 1e-6) << "known anew";
}

TEST(ElevationMap, PointsThatAreNotFiniteAreLeftOut)
{
  ElevationMap map(0.1);
  const float nan = std::nanf("");
  const auto told =
      insert(map, {{0, 0, 1}, {nan, 0, 1}, {0, kInfinity, 1}, {0, 0, -kInfinity}, {0.1f, 0, 1}});
  EXPECT_EQ(told.inserted, 2u);
  EXPECT_EQ(told.notFinite, 3u);
  EXPECT_EQ(map.frame(), (grid::GridFrame{0.1, 0, 0, 2, 1, -0.5}));
  EXPECT_EQ(insert(map, {}).inserted, 0u);
}

TEST(ElevationMap, RefusesWhatIsNotValid)
{
  EXPECT_THROW(ElevationMap(0), std::invalid_argument);
  ElevationMapParams params;
  params.maxVariance = 1e-9;
  EXPECT_THROW(ElevationMap(0.1, params), std::invalid_argument);
  params = {};
  params.mahalanobisDistanceThreshold = std::nan("");
  EXPECT_THROW(ElevationMap(0.1, params), std::invalid_argument);
  params = {};
  params.multiHeightNoise = -1;
  EXPECT_THROW(ElevationMap(0.1, params), std::invalid_argument);
  ElevationMap map(0.001);
  EXPECT_THROW(insert(map, {{0, 0, 0}, {30, 30, 0}}), std::runtime_error) << "9e8 cells";
}

TEST(ElevationMap, FusedAPlaneStaysAPlane)
{
  ElevationMap map(0.1, unlimited());
  std::vector<std::array<float, 3>> points;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 6; ++x)
      points.push_back({0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y), 0.25f});
  insert(map, points);
  const auto& fused = map.fuse();
  EXPECT_EQ(fused.height.frame(), map.frame());
  for (std::size_t i = 0; i < 30; ++i)
  {
    EXPECT_NEAR(fused.height.cells()[i], 0.25, 1e-6);
    EXPECT_NEAR(fused.lower.cells()[i], 0.25 - 2 * std::sqrt(kVariance), 1e-6);
    EXPECT_NEAR(fused.upper.cells()[i], 0.25 + 2 * std::sqrt(kVariance), 1e-6);
  }
}

TEST(ElevationMap, FusionMixesACellWithThoseAroundIt)
{
  ElevationMap map(0.1, unlimited());
  insert(map, {{0, 0, 0}, {0.1f, 0, 1}, {0.3f, 0, 5}});
  const auto& fused = map.fuse();
  const double middle = 0.6826895, beside = 0.1573054;  // within 1 σ, from 1 to 3 σ
  EXPECT_NEAR(fused.height.at(0, 0), beside / (middle + beside), 1e-5);
  EXPECT_NEAR(fused.height.at(1, 0), middle / (middle + beside), 1e-5);
  EXPECT_NEAR(fused.lower.at(0, 0), -0.02 + 0.01, 1e-5);
  EXPECT_NEAR(fused.upper.at(0, 0), 1.02 - 0.01, 1e-5);
  EXPECT_TRUE(std::isnan(fused.height.at(2, 0))) << "no point";
  EXPECT_NEAR(fused.height.at(3, 0), 5, 1e-5) << "nothing around";
  EXPECT_NEAR(fused.upper.at(3, 0), 5.02, 1e-5);
}
