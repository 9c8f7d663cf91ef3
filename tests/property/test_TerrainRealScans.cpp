// Three scans of a VLP-16 in a street.
#include <gtest/gtest.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "TerrainChecks.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using terrain::TerrainMap;

const std::string kLog = std::string(MRPT_MAPCONV_SHARED_DIR) + "/vlp16_3scans.rawlog";

void insertScans(TerrainMap& map)
{
  for (const auto& [observation, pose] : observation::readRawlog(kLog, {true}))
  {
    const auto seen = observation::sensorPoints(*observation, pose);
    ASSERT_TRUE(seen);
    ASSERT_GT(seen->points.size(), 1000u);
    terrain::TerrainScan scan;
    scan.x = &seen->points.front().x;
    scan.y = &seen->points.front().y;
    scan.z = &seen->points.front().z;
    scan.stride = sizeof(seen->points.front()) / sizeof(float);
    scan.points = seen->points.size();
    scan.sensorPose = seen->sensorPose;
    scan.robotPose = pose;
    scan.poseCovariance = terrain::PointSigmas().poseCovariance();
    EXPECT_EQ(map.insert(scan, {}).inserted, scan.points);
    map.update(2);
    expectInvariants(map);
  }
}
}  // namespace

TEST(TerrainRealScans, TheStreetIsOneLargeLevelPlane)
{
  if (!std::filesystem::exists(kLog)) GTEST_SKIP() << "there is no " << kLog;
  TerrainMap map(0.2);
  insertScans(map);
  ASSERT_FALSE(map.planes().empty());
  const auto street =
      *std::max_element(map.planes().begin(), map.planes().end(),
                        [](const auto& a, const auto& b) { return a.cells < b.cells; });
  EXPECT_GT(street.cells, 1000);
  EXPECT_LT(street.slope(), 0.1);
  EXPECT_LT(street.rms, map.params().planeTolerance);
  for (const auto& plane : map.planes())
    std::printf("plane: %lld cells, slope %.3f, z %.2f, rms %.4f\n",
                static_cast<long long>(plane.cells), plane.slope(), plane.z, plane.rms);
}

TEST(TerrainRealScans, AreConsistentAtEachResolutionOfThePaper)
{
  if (!std::filesystem::exists(kLog)) GTEST_SKIP() << "there is no " << kLog;
  for (const double resolution : {0.05, 0.1, 0.3})
  {
    SCOPED_TRACE(resolution);
    TerrainMap map(resolution);
    insertScans(map);
  }
}
