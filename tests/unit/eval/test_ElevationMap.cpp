#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/ElevationMap.h>
#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>
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

// --- the same, slowly
namespace
{
/** One point after the other, in double precision, each as Fankhauser's formulas say it. */
class SlowElevationMap
{
 public:
  struct Cell
  {
    double height = 0, variance = 0;
    bool fusedByThisScan = false;
  };

  SlowElevationMap(double resolution, const ElevationMapParams& params)
      : m_resolution(resolution), m_params(params)
  {
  }

  void insert(const terrain::TerrainScan& scan, const terrain::PointSigmas& sigmas)
  {
    for (auto& [key, cell] : cells) cell.fusedByThisScan = false;
    for (std::size_t i = 0; i < scan.points; ++i)
    {
      const mrpt::math::TPoint3D p(scan.x[i], scan.y[i], scan.z[i]);
      mrpt::math::TPoint3D m = scan.sensorPose.composePoint(p);
      m.z = std::floor(m.z / terrain::kHeightUnit + 0.5) * terrain::kHeightUnit;
      update(keyOf(m.x), keyOf(m.y), m.z, varianceOf(scan, sigmas, p));
    }
    for (auto it = cells.begin(); it != cells.end();)
    {
      it->second.variance = std::max(it->second.variance, m_params.minVariance);
      it = it->second.variance > m_params.maxVariance ? cells.erase(it) : std::next(it);
    }
  }

  std::map<std::pair<int, int>, Cell> cells;

 private:
  int keyOf(double metres) const
  {
    return static_cast<int>(std::floor(metres / m_resolution + 0.5));
  }

  static double heightFor(const terrain::TerrainScan& scan, const mrpt::math::TPoint3D& p,
                          double roll, double pitch)
  {
    const CPose3D& robot = scan.robotPose;
    const CPose3D turned(robot.x(), robot.y(), robot.z(), robot.yaw(), robot.pitch() + pitch,
                         robot.roll() + roll);
    return (turned + (scan.sensorPose - robot)).composePoint(p).z;
  }

  /** J_S Σ_S J_Sᵀ + J_P Σ_P J_Pᵀ, with numeric derivatives by roll and pitch. */
  static double varianceOf(const terrain::TerrainScan& scan, const terrain::PointSigmas& sigmas,
                           const mrpt::math::TPoint3D& p)
  {
    const auto rotation = scan.sensorPose.getRotationMatrix();
    const double range = p.norm();
    const double direction[] = {p.x / range, p.y / range, p.z / range};
    double ofSensor = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        const double along = direction[i] * direction[j];
        const double across = (i == j ? 1.0 : 0.0) - along;
        ofSensor += rotation(2, i) * rotation(2, j) *
                    (sigmas.range * sigmas.range * along +
                     sigmas.beam * sigmas.beam * range * range * across);
      }
    const double h = 1e-6;
    const double jacobian[] = {1, (heightFor(scan, p, h, 0) - heightFor(scan, p, -h, 0)) / (2 * h),
                               (heightFor(scan, p, 0, h) - heightFor(scan, p, 0, -h)) / (2 * h)};
    double ofPose = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) ofPose += jacobian[i] * scan.poseCovariance(i, j) * jacobian[j];
    return ofSensor + ofPose;
  }

  void update(int kx, int ky, double z, double variance)
  {
    const auto found = cells.find({kx, ky});
    if (found == cells.end())
    {
      cells[{kx, ky}] = {z, variance, false};
      return;
    }
    Cell& cell = found->second;
    if (std::abs(z - cell.height) / std::sqrt(cell.variance) >
        m_params.mahalanobisDistanceThreshold)
    {
      if (!cell.fusedByThisScan)
        cell.variance += m_params.multiHeightNoise;
      else if (z > cell.height)
        cell.height = z, cell.variance = variance;
      return;
    }
    cell.height = (cell.variance * z + variance * cell.height) / (cell.variance + variance);
    cell.variance = variance * cell.variance / (variance + cell.variance);
    cell.fusedByThisScan = true;
  }

  const double m_resolution;
  const ElevationMapParams m_params;
};

/** Steps of 0.1 m height with noise, seen by a robot that is somewhere else each time. */
struct RandomScan
{
  explicit RandomScan(std::mt19937& random)
  {
    std::uniform_real_distribution<double> share(-1, 1);
    std::normal_distribution<double> noise(0, 0.02);
    robot = CPose3D(3 * share(random), 3 * share(random), 0.5 + 0.1 * share(random),
                    3 * share(random), 0.3 * share(random), 0.3 * share(random));
    sensor = robot + CPose3D(0.2, 0.1, 0.3, 0.5, 0.4, 0.1);
    for (int i = 0; i < 3000; ++i)
    {
      mrpt::math::TPoint3D place(sensor.x() + 2 * share(random), sensor.y() + 2 * share(random), 0);
      place.z = 0.1 * std::round(2 * std::sin(place.x)) + noise(random);
      const mrpt::math::TPoint3D p = sensor.inverseComposePoint(place);
      x.push_back(static_cast<float>(p.x));
      y.push_back(static_cast<float>(p.y));
      z.push_back(static_cast<float>(p.z));
    }
  }
  terrain::TerrainScan scan() const
  {
    terrain::TerrainScan scan;
    scan.x = x.data();
    scan.y = y.data();
    scan.z = z.data();
    scan.points = x.size();
    scan.sensorPose = sensor;
    scan.robotPose = robot;
    scan.poseCovariance = terrain::PointSigmas{}.poseCovariance();
    scan.poseCovariance(0, 1) = scan.poseCovariance(1, 0) = 2e-6;
    scan.poseCovariance(1, 2) = scan.poseCovariance(2, 1) = 1e-6;
    return scan;
  }

  std::vector<float> x, y, z;
  CPose3D robot, sensor;
};

void expectSame(const ElevationMap& fast, const SlowElevationMap& slow)
{
  const auto height = fast.height(), variance = fast.variance();
  std::size_t known = 0;
  for (const float cell : height.cells()) known += std::isfinite(cell) ? 1 : 0;
  ASSERT_EQ(known, slow.cells.size());
  for (const auto& [key, cell] : slow.cells)
  {
    ASSERT_TRUE(fast.frame().containsKey(key.first, key.second));
    const auto index = fast.frame().indexOfKey(key.first, key.second);
    ASSERT_NEAR(height.cells()[index], cell.height, 1e-4) << key.first << " " << key.second;
    ASSERT_NEAR(variance.cells()[index], cell.variance, 1e-2 * cell.variance);
  }
}

void compareWithSlowOne(double resolution, const ElevationMapParams& params)
{
  const unsigned seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  ElevationMap fast(resolution, params);
  SlowElevationMap slow(resolution, params);
  const terrain::PointSigmas sigmas;
  for (int i = 0; i < 8; ++i)
  {
    const RandomScan scan(random);
    EXPECT_EQ(fast.insert(scan.scan(), sigmas).inserted, 3000u);
    slow.insert(scan.scan(), sigmas);
    expectSame(fast, slow);
  }
}

/** Of all known cells around one. */
struct SlowFusion
{
  SlowFusion(const grid::Layer<float>& heights, const grid::Layer<float>& variances,
             std::int32_t ix, std::int32_t iy)
  {
    const auto inCell = [](int offset)
    {
      const auto upTo = [](double cells) { return 0.5 * std::erfc(-cells / 0.5 / std::sqrt(2)); };
      return upTo(offset + 0.5) - upTo(offset - 0.5);
    };
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
      {
        const std::int32_t x = ix + dx, y = iy + dy;
        if (x < 0 || y < 0 || x >= heights.frame().width || y >= heights.frame().height) continue;
        if (std::isnan(heights.at(x, y))) continue;
        const double weight = inCell(dx) * inCell(dy), h = heights.at(x, y);
        const double reach = 2 * std::sqrt(variances.at(x, y));
        weights += weight;
        mean += weight * h;
        lower.emplace_back(h - reach, weight);
        upper.emplace_back(h + reach, weight);
      }
    mean /= weights;
  }

  /** Linear between the values; the lowest has probability 0, the highest 1. */
  double quantile(std::vector<std::pair<double, double>> values, double probability) const
  {
    std::sort(values.begin(), values.end());
    double before = 0;
    for (std::size_t i = 1; i < values.size(); ++i)
    {
      const double here = before + values[i].second / (weights - values[0].second);
      if (here >= probability)
        return values[i - 1].first +
               (values[i].first - values[i - 1].first) * (probability - before) / (here - before);
      before = here;
    }
    return values.back().first;
  }

  double weights = 0, mean = 0;
  std::vector<std::pair<double, double>> lower, upper;
};
}  // namespace

TEST(ElevationMap, UpdatesAreThoseOfTheSlowOne)
{
  for (const double resolution : {0.02, 0.1, 0.37}) compareWithSlowOne(resolution, {});
  ElevationMapParams kalman;
  kalman.mahalanobisDistanceThreshold = kInfinity;
  compareWithSlowOne(0.1, kalman);
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

TEST(ElevationMap, FusionIsThatOfTheSlowOne)
{
  std::mt19937 random(11);
  ElevationMap map(0.01);
  for (int i = 0; i < 3; ++i)
  {
    const RandomScan scan(random);
    map.insert(scan.scan(), {});
    const auto& fused = map.fuse();
    const auto heights = map.height(), variances = map.variance();
    ASSERT_EQ(fused.height.frame(), heights.frame());
    for (std::int32_t iy = 0; iy < heights.frame().height; ++iy)
      for (std::int32_t ix = 0; ix < heights.frame().width; ++ix)
      {
        ASSERT_EQ(std::isnan(fused.height.at(ix, iy)), std::isnan(heights.at(ix, iy)));
        if (std::isnan(heights.at(ix, iy))) continue;
        const SlowFusion slow(heights, variances, ix, iy);
        ASSERT_NEAR(fused.height.at(ix, iy), slow.mean, 1e-5);
        ASSERT_NEAR(fused.lower.at(ix, iy), slow.quantile(slow.lower, 0.01), 1e-5);
        ASSERT_NEAR(fused.upper.at(ix, iy), slow.quantile(slow.upper, 0.99), 1e-5);
      }
  }
}
