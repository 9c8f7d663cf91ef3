#include "SlamLog.h"

// Stock icp-slam: poses from the 2D scans, our map from the 3D scans.

using namespace mrpt_mapconv::testing;

namespace
{
/** \param inStartFrame actions and frames do not say where the robot starts: the map's frame is
 * there. Observations do, since odometry has absolute poses. */
double shareRightAfter(const SlamLog& log, const std::string& rawlog, bool inStartFrame)
{
  EXPECT_EQ(log.run(withPlugin() + "icp-slam " + configFile("icp-slam.ini") + " " + rawlog), 0)
      << log.said();
  return log.shareRight(
      "LOG_ICP-SLAM/_finalmaps_.txt_mrpt_mapconv__CFreeSpaceGridMap2D_01_layers.tif", inStartFrame);
}
}  // namespace

TEST(IcpSlam, MapsObservationsAsTheyAre)
{
  const double share = shareRightAfter(SlamLog(), "scans.rawlog", false);
  RecordProperty("shareRight", std::to_string(share));
  EXPECT_GE(share, 0.9);
}

TEST(IcpSlam, MapsActionsAndFramesAsTheyAre)
{
  const double share = shareRightAfter(SlamLog(), "frames.rawlog", true);
  RecordProperty("shareRight", std::to_string(share));
  EXPECT_GE(share, 0.9);
}

TEST(IcpSlam, HasNoMapWithoutThe3DScans)
{
  SlamLog log;
  log.remove3D();
  EXPECT_LT(shareRightAfter(log, "scans.rawlog", false), 0.9);
  EXPECT_LT(shareRightAfter(log, "frames.rawlog", true), 0.9);
}
