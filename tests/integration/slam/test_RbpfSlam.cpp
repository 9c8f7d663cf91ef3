#include <fstream>

#include "SlamLog.h"

// Stock rbpf-slam: poses from the 2D scans by a particle filter, our map from the 3D scans.

using namespace mrpt_mapconv::testing;

namespace
{
constexpr bool kInStartFrame = true;

/** The beginning of a final map's files. */
std::string finalMap(const std::string& map) { return "LOG_RBPF-SLAM/finalMap_" + map; }

/** \param map2D the 2D map's number */
void runRbpfSlam(const SlamLog& log, const std::string& ini, const std::string& map2D)
{
  ASSERT_EQ(log.run(withPlugin() + "rbpf-slam " + ini + " frames.rawlog"), 0) << log.said();
  EXPECT_FALSE(isUniform(log.file(finalMap("mrpt__maps__COccupancyGridMap2D_" + map2D + ".png"))));
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
  const SlamLog log;
  ASSERT_NO_FATAL_FAILURE(runRbpfSlam(log, configFile("freeSpaceGrid/rbpf-slam.ini"), "00"));
  log.expectRight(finalMap("mrpt_mapconv__CFreeSpaceGridMap2D_01_layers.tif"), kInStartFrame);
}

TEST(RbpfSlam, HasAnEmptyMapWithoutThe3DScans)
{
  SlamLog log;
  log.remove3D();
  ASSERT_NO_FATAL_FAILURE(runRbpfSlam(log, configFile("freeSpaceGrid/rbpf-slam.ini"), "00"));
  const auto ours = log.file(finalMap("mrpt_mapconv__CFreeSpaceGridMap2D_01"));
  EXPECT_TRUE(isUniform(ours + ".png"));
  EXPECT_FALSE(std::filesystem::exists(ours + "_layers.tif"));
}

/** Averaging the particles' maps, the program resizes the first grid of each behind its back. With
 * MRPT's own name for the 2D map, that is ours. */
TEST(RbpfSlam, MapsRightWhenItResizesOurGrid)
{
  SlamLog log;
  auto ini =
      readBytes(std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/freeSpaceGrid/rbpf-slam.ini");
  ini = changedIni(log, ini, "COccupancyGridMap2D_", "occupancyGrid_");
  ini = changedIni(log, ini, "LOG_FREQUENCY        = 100", "LOG_FREQUENCY        = 7");
  ini = changedIni(log, ini, "GENERATE_LOG_INFO    = false", "GENERATE_LOG_INFO    = true");
  changedIni(log, ini, "sampleSize         = 20", "sampleSize         = 6");
  ASSERT_NO_FATAL_FAILURE(runRbpfSlam(log, "changed.ini", "01"));
  ASSERT_TRUE(std::filesystem::exists(log.file("LOG_RBPF-SLAM/EMMI_gridmap_007.png")))
      << "no maps were averaged\n"
      << log.said();
  log.expectRight(finalMap("mrpt_mapconv__CFreeSpaceGridMap2D_00_layers.tif"), kInStartFrame);
}
