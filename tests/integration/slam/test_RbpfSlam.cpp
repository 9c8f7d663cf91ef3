#include <fstream>

#include "SlamLog.h"

// Stock rbpf-slam: poses from the 2D scans by a particle filter, our map from the 3D scans.

using namespace mrpt_mapconv::testing;

namespace
{
double shareRightAfter(const SlamLog& log, const std::string& ini, const std::string& map)
{
  EXPECT_EQ(log.run(withPlugin() + "rbpf-slam " + ini + " frames.rawlog"), 0) << log.said();
  return log.shareRight("LOG_RBPF-SLAM/finalMap_mrpt_mapconv__" + map + "_layers.tif", true);
}

/** The ini file with another text at one place, written into the log's folder. */
std::string changedIni(const SlamLog& log, std::string text, const std::string& from,
                       const std::string& to)
{
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  std::ofstream(log.file("changed.ini")) << text;
  return text;
}
}  // namespace

TEST(RbpfSlam, MapsActionsAndFramesAsTheyAre)
{
  const double share =
      shareRightAfter(SlamLog(), configFile("rbpf-slam.ini"), "CFreeSpaceGridMap2D_01");
  RecordProperty("shareRight", std::to_string(share));
  EXPECT_GE(share, 0.9);
}

TEST(RbpfSlam, HasNoMapWithoutThe3DScans)
{
  SlamLog log;
  log.remove3D();
  EXPECT_LT(shareRightAfter(log, configFile("rbpf-slam.ini"), "CFreeSpaceGridMap2D_01"), 0.9);
}

/** Averaging the particles' maps, the program resizes the first grid of each behind its back. With
 * MRPT's own name for the 2D map, that is ours. */
TEST(RbpfSlam, MapsRightWhenItResizesOurGrid)
{
  SlamLog log;
  auto ini = readBytes(std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/rbpf-slam.ini");
  ini = changedIni(log, ini, "COccupancyGridMap2D_", "occupancyGrid_");
  ini = changedIni(log, ini, "LOG_FREQUENCY        = 100", "LOG_FREQUENCY        = 7");
  ini = changedIni(log, ini, "GENERATE_LOG_INFO    = false", "GENERATE_LOG_INFO    = true");
  changedIni(log, ini, "sampleSize         = 20", "sampleSize         = 6");
  const double share = shareRightAfter(log, "changed.ini", "CFreeSpaceGridMap2D_00");
  ASSERT_TRUE(std::filesystem::exists(log.file("LOG_RBPF-SLAM/EMMI_gridmap_007.png")))
      << "no maps were averaged\n"
      << log.said();
  RecordProperty("shareRight", std::to_string(share));
  EXPECT_GE(share, 0.9);
}
