// Three scans of a standing VLP-16, among things 1 to 3 m away: no ground is in sight.
#include <gtest/gtest.h>
#include <mrpt_mapconv/observation/ObservationPoints.h>
#include <mrpt_mapconv/observation/ScanLog.h>

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
  for (const auto& [observation, pose, covariance] : observation::readRawlog(kLog, {true}))
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

TEST(TerrainRealScans, PlanesAndLeavesAreConsistent)
{
  if (!std::filesystem::exists(kLog)) GTEST_SKIP() << "there is no " << kLog;
  for (const double resolution : {0.02, 0.05, 0.1, 0.3})
  {
    SCOPED_TRACE(resolution);
    TerrainMap map(resolution);
    insertScans(map);
  }
}

TEST(TerrainRealScans, PlanesLieAmongTheirCells)
{
  if (!std::filesystem::exists(kLog)) GTEST_SKIP() << "there is no " << kLog;
  TerrainMap map(0.05);
  insertScans(map);
  EXPECT_FALSE(map.planes().empty());
  for (const auto& plane : map.planes())
  {
    EXPECT_GT(plane.z, 1.8 - 0.5) << "the sensor's height is 1.8 m";
    EXPECT_LT(plane.z, 1.8 + 0.8);
    EXPECT_LE(plane.rms, map.params().planeTolerance);
    EXPECT_LE(plane.slope(), map.params().maxPlaneSlope);
  }
}
