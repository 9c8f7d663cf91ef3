#include <mrpt/obs/CObservation3DRangeScan.h>

#include <functional>
#include <set>

#include "ScanShapeFixtures.h"

// Scans that are not inserted: what is said, and that the map stays exactly as it was.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

namespace
{
template <class Scan>
struct BadInputOf
{
  const char* what;
  std::function<void(CScanShapeGridMap2D&, Scan&, CPose3D&)> spoil;
  std::string says;  //!< in the exception or a warning
  bool throws = true;
};
using BadInput = BadInputOf<mrpt::obs::CObservationPointCloud>;
using Bad2DInput = BadInputOf<mrpt::obs::CObservation2DRangeScan>;

const double kNan = std::nan("");

std::vector<BadInput> badInputs()
{
  using Map = CScanShapeGridMap2D;
  using Cloud = mrpt::obs::CObservationPointCloud;
  const auto onlyPoint = [](Cloud& scan, float x, float y, float z)
  {
    scan.pointcloud->clear();
    scan.pointcloud->insertPointFast(x, y, z);
  };
  constexpr bool skipped = false;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  return {
      {"no points", [](Map&, Cloud& scan, CPose3D&) { scan.pointcloud->clear(); },
       "no usable point", skipped},
      {"no cloud", [](Map&, Cloud& scan, CPose3D&) { scan.pointcloud.reset(); }, "no usable point",
       skipped},
      {"NaN points", [=](Map&, Cloud& scan, CPose3D&) { onlyPoint(scan, nan, 1, 1); },
       "1 points with NaN", skipped},
      {"infinite points", [=](Map&, Cloud& scan, CPose3D&) { onlyPoint(scan, 1, HUGE_VALF, 1); },
       "1 points with NaN", skipped},
      {"a point at the sensor", [=](Map&, Cloud& scan, CPose3D&) { onlyPoint(scan, 0, 0, 0); },
       "no usable point", skipped},
      {"a point close to the sensor",
       [=](Map& map, Cloud& scan, CPose3D&)
       {
         onlyPoint(scan, 1e-20f, 0, 0);
         map.scanInsertionOptions.profile.reflectionFilter = false;  // warns that there is no wall
       },
       "no object between objectMinZ and objectMaxZ", skipped},
      {"only ceiling", [=](Map&, Cloud& scan, CPose3D&) { onlyPoint(scan, 1, 0, 1.2f); },
       "no object between objectMinZ and objectMaxZ", skipped},
      {"only objects behind a wall",
       [=](Map&, Cloud& scan, CPose3D&)
       {
         onlyPoint(scan, 1, 0, 1.2f);
         scan.pointcloud->insertPointFast(2, 0, 0);
       },
       "all of its objects are behind walls", skipped},
      {"sensor under the slices",
       [](Map&, Cloud& scan, CPose3D&) { scan.sensorPose = CPose3D(0, 0, -0.5); },
       "lower than all that counts", skipped},
      {"robot's pose with NaN", [](Map&, Cloud&, CPose3D& robot) { robot = CPose3D(0, kNan, 0); },
       "not finite", skipped},
      {"robot's yaw with NaN",
       [](Map&, Cloud&, CPose3D& robot) { robot = CPose3D(0, 0, 0, kNan, 0, 0); }, "not finite",
       skipped},
      {"infinite sensor pose",
       [](Map&, Cloud& scan, CPose3D&) { scan.sensorPose = CPose3D(HUGE_VAL, 0, 1); }, "not finite",
       skipped},
      {"a pose beyond all keys", [](Map&, Cloud&, CPose3D& robot) { robot = CPose3D(1e15, 0, 0); },
       "pose (1e+15, 0) is more than 1e+09 cells from the origin"},
      {"a pose that is just too far",
       [](Map& map, Cloud&, CPose3D& robot)
       {
         map.clear();
         robot = CPose3D(1e7, 0, 0);
       },
       "MRPT's float limits"},
      {"a pose with NaN must not hide a bad option",
       [](Map& map, Cloud&, CPose3D& robot)
       {
         robot = CPose3D(kNan, 0, 0);
         map.scanInsertionOptions.profile.maxRange = -1;
       },
       "maxRange = -1"},
      {"a grid above maxGridCells",
       [](Map&, Cloud&, CPose3D& robot) { robot = CPose3D(20000, 20000, 0); },
       "maxGridCells = 4e+08"},
      {"a smaller maxGridCells", [](Map& map, Cloud&, CPose3D&) { map.maxGridCells = 50; },
       "maxGridCells = 50"},
      {"maxGridCells that is NaN", [](Map& map, Cloud&, CPose3D&) { map.maxGridCells = kNan; },
       "maxGridCells = nan"},
      {"inverted object slice",
       [](Map& map, Cloud&, CPose3D&) { map.scanInsertionOptions.profile.objectMaxZ = 0.05; },
       "objectMaxZ = 0.05"},
      {"inverted structure slice",
       [](Map& map, Cloud&, CPose3D&) { map.scanInsertionOptions.profile.structureMaxZ = 1.9; },
       "structureMaxZ = 1.9"},
      {"no structure slice",
       [](Map& map, Cloud&, CPose3D&) { map.scanInsertionOptions.profile.structureMinZ = kNan; },
       "structureMinZ is missing"},
      {"maxRange of 0",
       [](Map& map, Cloud&, CPose3D&) { map.scanInsertionOptions.profile.maxRange = 0; },
       "maxRange = 0"},
      {"maxRange below 0",
       [](Map& map, Cloud&, CPose3D&) { map.scanInsertionOptions.profile.maxRange = -20; },
       "maxRange = -20"},
      {"pHit below 0.5",
       [](Map& map, Cloud&, CPose3D&) { map.scanInsertionOptions.update.pHit = 0.4; },
       "pHit = 0.4"},
      {"pMiss that is NaN",
       [](Map& map, Cloud&, CPose3D&) { map.scanInsertionOptions.update.pMiss = kNan; },
       "pMiss = nan"},
  };
}

std::vector<Bad2DInput> bad2DInputs()
{
  using Map = CScanShapeGridMap2D;
  using Scan = mrpt::obs::CObservation2DRangeScan;
  const auto allRanges = [](Scan& scan, float range)
  {
    for (std::size_t i = 0; i < scan.getScanSize(); ++i) scan.setScanRange(i, range);
  };
  constexpr bool skipped = false;
  const auto nan = static_cast<float>(kNan);
  return {
      {"no ranges", [](Map&, Scan& scan, CPose3D&) { scan.resizeScan(0); }, "no range", skipped},
      {"aperture of NaN", [=](Map&, Scan& scan, CPose3D&) { scan.aperture = nan; },
       "aperture is not an angle", skipped},
      {"aperture below 0", [](Map&, Scan& scan, CPose3D&) { scan.aperture = -1; },
       "aperture is not an angle", skipped},
      {"infinite aperture", [](Map&, Scan& scan, CPose3D&) { scan.aperture = HUGE_VALF; },
       "aperture is not an angle", skipped},
      {"ranges of NaN", [=](Map&, Scan& scan, CPose3D&) { allRanges(scan, nan); }, "no valid range",
       skipped},
      {"ranges of inf", [=](Map&, Scan& scan, CPose3D&) { allRanges(scan, HUGE_VALF); },
       "no valid range", skipped},
      {"ranges of -inf", [=](Map&, Scan& scan, CPose3D&) { allRanges(scan, -HUGE_VALF); },
       "no valid range", skipped},
      {"ranges below 0", [=](Map&, Scan& scan, CPose3D&) { allRanges(scan, -1); }, "no valid range",
       skipped},
      {"no valid ranges",
       [](Map&, Scan& scan, CPose3D&)
       {
         for (std::size_t i = 0; i < scan.getScanSize(); ++i) scan.setScanRangeValidity(i, false);
       },
       "no valid range", skipped},
      {"a valid range between those that decimation uses",
       [](Map& map, Scan& scan, CPose3D&)
       {
         map.insertionOptions.decimation = 2;
         for (std::size_t i = 0; i < scan.getScanSize(); ++i)
           scan.setScanRangeValidity(i, i % 2 == 1);
       },
       "no valid range", skipped},
      {"pose with NaN", [](Map&, Scan&, CPose3D& robot) { robot = CPose3D(kNan, 0, 0); },
       "pose is not finite", skipped},
      {"a tilted sensor",
       [](Map&, Scan& scan, CPose3D&) { scan.sensorPose = CPose3D(0, 0, 0.4, 0, 0.1, 0); },
       "tilted by more than horizontalTolerance", skipped},
      {"a sensor at another altitude",
       [](Map& map, Scan&, CPose3D&)
       {
         map.insertionOptions.useMapAltitude = true;
         map.insertionOptions.mapAltitude = 0.4f + 0.002f;
       },
       "not at mapAltitude", skipped},
      {"maxDistanceInsertion of NaN",
       [=](Map& map, Scan&, CPose3D&) { map.insertionOptions.maxDistanceInsertion = nan; },
       "maxDistanceInsertion = nan"},
      {"maxDistanceInsertion of 0",
       [](Map& map, Scan&, CPose3D&) { map.insertionOptions.maxDistanceInsertion = 0; },
       "maxDistanceInsertion = 0"},
      {"decimation of 0", [](Map& map, Scan&, CPose3D&) { map.insertionOptions.decimation = 0; },
       "decimation = 0"},
      {"a grid above maxGridCells",
       [](Map&, Scan&, CPose3D& robot) { robot = CPose3D(1e5, 1e5, 0); }, "maxGridCells = 4e+08"},
      {"a pose beyond all keys", [](Map&, Scan&, CPose3D& robot) { robot = CPose3D(1e12, 7, 0); },
       "pose (1e+12, 7) is more than 1e+09 cells from the origin"},
      {"a pose that is just too far",
       [](Map& map, Scan&, CPose3D& robot)
       {
         map.clear();
         robot = CPose3D(1e7, 0, 0);
       },
       "MRPT's float limits"},
  };
}

/** Inserts a bad scan twice. */
template <class Scan>
void expectRefused(const BadInputOf<Scan>& input, Scan scan)
{
  SCOPED_TRACE(input.what);
  auto map = mapOf(Room());
  CPose3D robot;
  scan.sensorLabel = "LIDAR";
  input.spoil(map, scan, robot);
  const auto before = bytes(map);
  const auto found = map.lastScan();
  const WarningsOf warnings(map);
  std::vector<std::string> said;
  int thrown = 0;
  for (int twice = 0; twice < 2; ++twice) try
    {
      EXPECT_FALSE(map.insertObservation(scan, robot));
      EXPECT_NE(map.lastSkip(), "");
    }
    catch (const std::exception& error)
    {
      ++thrown;
      said.push_back(error.what());
      EXPECT_EQ(said[0].find('\n'), std::string::npos) << said[0];
      EXPECT_EQ(map.lastScan().occupiedCells, found.occupiedCells) << "a refused scan is reported";
    }
  EXPECT_EQ(bytes(map), before);
  EXPECT_EQ(thrown, input.throws ? 2 : 0);
  if (!input.throws) said = warnings.texts;
  const std::set<std::string> different(said.begin(), said.end());
  EXPECT_TRUE(input.throws || different.size() == said.size()) << "each is said once";
  EXPECT_TRUE(std::any_of(said.begin(), said.end(),
                          [&](const std::string& text) {
                            return contains(text, input.says) &&
                                   (input.throws || contains(text, "'LIDAR'"));
                          }))
      << input.says << testing::PrintToString(said);
}
}  // namespace

TEST(CScanShapeGridMap2DRefuses, ARefusedScanLeavesTheMapExactlyAsItWas)
{
  const Room elsewhere{-9, 9, -8, 8, 2.5};  // the grid would have to grow
  for (const auto& input : badInputs()) expectRefused(input, scanOf(elsewhere, CPose3D()));
}

TEST(CScanShapeGridMap2DRefuses, ARefused2DScanLeavesTheMapExactlyAsItWas)
{
  const Room elsewhere{-9, 9, -8, 8, 2.5};
  for (const auto& input : bad2DInputs()) expectRefused(input, scan2DOf(elsewhere, CPose3D()));
}

TEST(CScanShapeGridMap2DRefuses, AScanWithoutReturnsUpToItsMaxRangeForThatReason)
{
  mrpt::obs::CObservation3DRangeScan image;
  image.maxRange = 2;
  image.hasRangeImage = true;
  image.rangeUnits = 0.001f;
  image.cameraParams.ncols = image.cameraParams.nrows = 2;
  image.cameraParams.setIntrinsicParamsFromValues(2, 2, 1, 1);
  image.rangeImage_setSize(2, 2);
  image.rangeImage.fill(2000);
  auto map = mapForRooms();
  const WarningsOf warnings(map);
  EXPECT_FALSE(map.insertObservation(image, CPose3D(0, 0, 1, 0, 0, 0)));
  EXPECT_EQ(map.lastSkip(), "all of its returns are at maxRange");
}

TEST(CScanShapeGridMap2DRefuses, EachReasonIsSaidOnceForEachSensor)
{
  auto map = mapForRooms();
  const WarningsOf warnings(map);
  mrpt::obs::CObservationPointCloud empty;
  for (const char* label : {"FRONT", "REAR", "FRONT"})
  {
    empty.sensorLabel = label;
    EXPECT_FALSE(map.insertObservation(empty, CPose3D()));
    EXPECT_EQ(map.lastSkip(), "it has no usable point");
    EXPECT_FALSE(map.insertObservation(empty, CPose3D(kNan, 0, 0)));
    EXPECT_EQ(map.lastSkip(), "its pose is not finite");
  }
  EXPECT_EQ(warnings.texts.size(), 4u) << testing::PrintToString(warnings.texts);
  EXPECT_TRUE(map.insertObservation(scanOf(Room(), CPose3D()), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "");
}

/** MRPT's grid takes a ray of NaN for one of maxDistanceInsertion, and crashes on one of -inf. */
TEST(CScanShapeGridMap2DRefuses, BadRaysOfA2DScanCountAsInvalid)
{
  for (const float bad : {static_cast<float>(kNan), HUGE_VALF, -HUGE_VALF, -1.0f})
  {
    SCOPED_TRACE(bad);
    const auto clean = scan2DOf(Room(), CPose3D());
    auto spoilt = clean, invalid = clean;
    for (std::size_t i = 20; i < 50; ++i)
    {
      spoilt.setScanRange(i, bad);
      invalid.setScanRangeValidity(i, false);
    }
    auto map = mapForRooms(), expected = mapForRooms();
    const WarningsOf warnings(map);
    for (int twice = 0; twice < 2; ++twice)
    {
      ASSERT_TRUE(map.insertObservation(spoilt, CPose3D()));
      ASSERT_TRUE(expected.insertObservation(invalid, CPose3D()));
    }
    EXPECT_EQ(map.frame(), expected.frame());
    EXPECT_EQ(map.getRawMap(), expected.getRawMap());
    ASSERT_EQ(warnings.texts.size(), 1u);
    EXPECT_TRUE(contains(warnings.texts[0], "NaN, infinite or negative")) << warnings.texts[0];
  }
}

namespace
{
/** The smallest maxGridCells with which a map takes a scan; expects that its grid never has more.
 */
double smallestLimit(const CScanShapeGridMap2D& map, const mrpt::obs::CObservation& scan)
{
  auto unlimited = map;
  EXPECT_TRUE(unlimited.insertObservation(scan, CPose3D()));
  const auto isEnough = [&](double limit)
  {
    auto tried = map;
    tried.maxGridCells = limit;
    try
    {
      tried.insertObservation(scan, CPose3D());
    }
    catch (const std::runtime_error&)
    {
      return false;
    }
    EXPECT_LE(static_cast<double>(tried.getRawMap().size()), limit);
    return true;
  };
  double low = 1, high = static_cast<double>(unlimited.getRawMap().size());
  while (high - low > 1)
  {
    const double middle = std::floor((low + high) / 2);
    (isEnough(middle) ? high : low) = middle;
  }
  return high;
}
}  // namespace

/** There need not be room for the margin. */
TEST(CScanShapeGridMap2DRefuses, NoGridThatIsAsLargeAsItMayBe)
{
  const Room room{-9, 9, -8, 8, 2.5};
  const auto map = mapForRooms();
  const double limit = smallestLimit(map, scanOf(room, CPose3D()));
  // by hand: walls on the border of two cells
  EXPECT_NEAR(limit, 181 * 161, 181 + 161);
  auto unlimited = map, limited = map;
  limited.maxGridCells = limit;
  for (auto* each : {&unlimited, &limited})
    ASSERT_TRUE(each->insertObservation(scanOf(room, CPose3D()), CPose3D()));
  expectSameCells(limited, unlimited);
  // the ends of the rays and the sensor, and 16 cells that MRPT wants to be there
  const auto scan = scan2DOf(Room{-9.04, 9.04, -8.04, 8.04, 2.5}, CPose3D());
  double xLow = 0, xHigh = 0, yLow = 0, yHigh = 0;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
  {
    const double angle = scan.aperture * (static_cast<double>(i) / 271 - 0.5);
    const double x = std::cos(angle) * scan.getScanRange(i);
    const double y = std::sin(angle) * scan.getScanRange(i);
    xLow = std::min(xLow, x), xHigh = std::max(xHigh, x);
    yLow = std::min(yLow, y), yHigh = std::max(yHigh, y);
  }
  const auto cells = [](double low, double high)
  { return std::floor(high / 0.1) - std::floor(low / 0.1) + 1 + 2 * 16; };
  EXPECT_EQ(smallestLimit(map, scan), cells(xLow, xHigh) * cells(yLow, yHigh));
}

TEST(CScanShapeGridMap2DRefuses, TooFarForMrptsFloatsIsAnErrorAndTheMapStaysAsItWas)
{
  auto map = mapForRooms(0.001);
  map.scanInsertionOptions.profile.maxRange = 3;
  const auto before = bytes(map);
  const CPose3D robot(50000.0123, 0, 0);
  const Room room{49999.5, 50000.5, -0.5, 0.5, 2.5};
  const auto said = messageOf([&] { map.insertObservation(scanOf(room, robot), robot); });
  EXPECT_TRUE(contains(said, "MRPT's float limits cannot hold")) << said;
  EXPECT_EQ(bytes(map), before);
}
