#include <functional>

#include "ScanShapeFixtures.h"

// Scans that are not inserted: what is said, and that the map stays exactly as it was.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::maps::fixtures;
using mrpt::poses::CPose3D;

namespace
{
struct BadInput
{
  const char* what;
  std::function<void(CScanShapeGridMap2D&, mrpt::obs::CObservationPointCloud&, CPose3D&)> spoil;
  std::string says;  //!< in the exception or the warning; empty: nothing is said
  bool throws = true;
};

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
      {"no points", [](Map&, Cloud& scan, CPose3D&) { scan.pointcloud->clear(); }, "", skipped},
      {"no cloud", [](Map&, Cloud& scan, CPose3D&) { scan.pointcloud.reset(); }, "", skipped},
      {"NaN points", [=](Map&, Cloud& scan, CPose3D&) { onlyPoint(scan, nan, 1, 1); },
       "1 points with NaN", skipped},
      {"infinite points", [=](Map&, Cloud& scan, CPose3D&) { onlyPoint(scan, 1, HUGE_VALF, 1); },
       "1 points with NaN", skipped},
      {"a point at the sensor", [=](Map&, Cloud& scan, CPose3D&) { onlyPoint(scan, 0, 0, 0); }, "",
       skipped},
      {"a point close to the sensor",
       [=](Map& map, Cloud& scan, CPose3D&)
       {
         onlyPoint(scan, 1e-20f, 0, 0);
         map.scanInsertionOptions.profile.reflectionFilter = false;  // warns that there is no wall
       },
       "", skipped},
      {"sensor under the slices",
       [](Map&, Cloud& scan, CPose3D&) { scan.sensorPose = CPose3D(0, 0, -0.5); },
       "outside the slices", skipped},
      {"sensor above the slices",
       [](Map&, Cloud& scan, CPose3D&) { scan.sensorPose = CPose3D(0, 0, 2.6); },
       "outside the slices", skipped},
      {"robot's pose with NaN", [](Map&, Cloud&, CPose3D& robot) { robot = CPose3D(0, kNan, 0); },
       "not finite", skipped},
      {"robot's yaw with NaN",
       [](Map&, Cloud&, CPose3D& robot) { robot = CPose3D(0, 0, 0, kNan, 0, 0); }, "not finite",
       skipped},
      {"infinite sensor pose",
       [](Map&, Cloud& scan, CPose3D&) { scan.sensorPose = CPose3D(HUGE_VAL, 0, 1); }, "not finite",
       skipped},
      {"a pose beyond all keys", [](Map&, Cloud&, CPose3D& robot) { robot = CPose3D(1e15, 0, 0); },
       "from the origin", skipped},
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
}  // namespace

TEST(CScanShapeGridMap2DRefuses, ARefusedScanLeavesTheMapExactlyAsItWas)
{
  const Room room, elsewhere{-9, 9, -8, 8, 2.5};  // the grid would have to grow
  for (const auto& input : badInputs())
  {
    SCOPED_TRACE(input.what);
    auto map = mapOf(room);
    auto scan = scanOf(elsewhere, CPose3D());
    CPose3D robot;
    input.spoil(map, scan, robot);
    const auto before = bytes(map);
    const WarningsOf warnings(map);
    std::string said;
    bool threw = false;
    for (int twice = 0; twice < 2; ++twice) try
      {
        EXPECT_FALSE(map.insertObservation(scan, robot));
      }
      catch (const std::exception& error)
      {
        threw = true;
        said = error.what();
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      }
    EXPECT_EQ(bytes(map), before);
    EXPECT_EQ(threw, input.throws) << said;
    if (!input.throws)
    {
      ASSERT_EQ(warnings.texts.size(), input.says.empty() ? 0u : 1u) << "each is said once";
      if (!warnings.texts.empty()) said = warnings.texts[0];
      EXPECT_EQ(contains(said, "'LIDAR'"), !input.says.empty()) << said;
    }
    EXPECT_TRUE(contains(said, input.says)) << said;
  }
}

TEST(CScanShapeGridMap2DRefuses, A2DScanAtABadPlaceLeavesTheMapExactlyAsItWas)
{
  auto map = mapOf(Room());
  const auto before = bytes(map);
  const WarningsOf warnings(map);
  const auto scan = scan2DOf(Room(), CPose3D());
  EXPECT_FALSE(map.insertObservation(scan, CPose3D(kNan, 0, 0)));
  EXPECT_EQ(warnings.texts.size(), 1u);
  for (const double far : {1e5, 1e12})
  {
    const auto said = messageOf([&] { map.insertObservation(scan, CPose3D(far, far, 0)); });
    EXPECT_TRUE(contains(said, "maxGridCells = 4e+08")) << said;
  }
  EXPECT_EQ(bytes(map), before);
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
  // a square around the longest rays, and 16 cells that MRPT wants to be there
  const auto scan = scan2DOf(room, CPose3D());
  float longest = 0;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i)
    longest = std::max(longest, scan.getScanRange(i));
  const double side = 2 * (std::floor(longest / 0.1f) + 1 + 16);
  EXPECT_EQ(smallestLimit(map, scan), side * side);
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
