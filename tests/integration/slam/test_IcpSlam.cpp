#include "SlamLog.h"

// Stock icp-slam: poses from the 2D scans, our map from the 3D scans.

using namespace mrpt_mapconv::testing;

namespace
{
const std::string kMap2D = "LOG_ICP-SLAM/_finalmaps_.txt_mrpt__maps__COccupancyGridMap2D_00";
const std::string kOurMap = "LOG_ICP-SLAM/_finalmaps_.txt_mrpt_mapconv__CFreeSpaceGridMap2D_01";

void runIcpSlam(const SlamLog& log, const std::string& rawlog)
{
  ASSERT_EQ(
      log.run(withPlugin() + "icp-slam " + configFile("freeSpaceGrid/icp-slam.ini") + " " + rawlog),
      0)
      << log.said();
  EXPECT_FALSE(isUniform(log.file(kMap2D + ".png"))) << rawlog;
}
}  // namespace

TEST(IcpSlam, MapsObservationsAsTheyAre)
{
  const SlamLog log;
  ASSERT_NO_FATAL_FAILURE(runIcpSlam(log, "scans.rawlog"));
  constexpr bool inStartFrame = false;  // odometry's poses are absolute
  log.expectRight(kOurMap + "_layers.tif", inStartFrame);
}

TEST(IcpSlam, MapsActionsAndFramesAsTheyAre)
{
  const SlamLog log;
  ASSERT_NO_FATAL_FAILURE(runIcpSlam(log, "frames.rawlog"));
  constexpr bool inStartFrame = true;  // they do not say where the robot starts
  log.expectRight(kOurMap + "_layers.tif", inStartFrame);
}

TEST(IcpSlam, HasAnEmptyMapWithoutThe3DScans)
{
  SlamLog log;
  log.remove3D();
  for (const char* rawlog : {"scans.rawlog", "frames.rawlog"})
  {
    std::filesystem::remove_all(log.file("LOG_ICP-SLAM"));
    ASSERT_NO_FATAL_FAILURE(runIcpSlam(log, rawlog));
    EXPECT_TRUE(isUniform(log.file(kOurMap + ".png"))) << rawlog;
    EXPECT_FALSE(std::filesystem::exists(log.file(kOurMap + "_layers.tif"))) << rawlog;
  }
}
