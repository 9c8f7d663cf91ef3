#include <mrpt_mapconv/grid/GeoTiff.h>

#include <cmath>
#include <fstream>

#include "SlamLog.h"

// Stock programs with our scan-shape map: poses from the 2D scans, the map from the 3D scans.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
const std::string kClass = "mrpt_mapconv__CScanShapeGridMap2D_";
const std::string kIcpMap = "LOG_ICP-SLAM/_finalmaps_.txt_" + kClass + "01";
const std::string kRbpfMap = "LOG_RBPF-SLAM/finalMap_" + kClass + "01";
const std::string kPfMap = "LOG_PF_000_0040000/map_" + kClass + "00";

/** \return the program's exit status */
int runStock(const SlamLog& log, const std::string& program, const std::string& ini,
             const std::string& files)
{
  return log.run(withPlugin() + program + " " + ini + " " + files);
}

void expectUnknown(const SlamLog& log, const std::string& map)
{
  const auto occupancy = grid::readGeoTiffBand(log.file(map + "_occupancy.tif"), "occupancy");
  ASSERT_FALSE(occupancy.cells().empty());
  for (const float cell : occupancy.cells()) ASSERT_TRUE(std::isnan(cell)) << map << ' ' << cell;
}

/** The ini file for pf-localization that takes the map of observations2map instead. */
std::string iniForSavedMap(const SlamLog& log)
{
  auto ini =
      readBytes(std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/scanShapeGrid/pf-localization.ini");
  const std::string from = "scans.simplemap\n";
  const auto at = ini.find("= " + from);
  EXPECT_NE(at, std::string::npos);
  std::ofstream(log.file("saved.ini"))
      << ini.replace(at + 2, from.size(), "out_gridmap_no00.gridmap\n");
  return "saved.ini";
}

std::string iniOf(const std::string& program)
{
  return configFile("scanShapeGrid/" + program + ".ini");
}
}  // namespace

TEST(ScanShapeMaps, IcpSlamMapsRight)
{
  const SlamLog log;
  for (const bool frames : {false, true})
  {
    std::filesystem::remove_all(log.file("LOG_ICP-SLAM"));
    const std::string rawlog = frames ? "frames.rawlog" : "scans.rawlog";
    ASSERT_EQ(runStock(log, "icp-slam", iniOf("icp-slam"), rawlog), 0) << log.said();
    // odometry's poses are absolute, actions do not say where the robot starts
    const bool inStartFrame = frames;
    log.expectRightShape(kIcpMap + "_occupancy.tif", inStartFrame);
  }
}

TEST(ScanShapeMaps, RbpfSlamMapsRight)
{
  const SlamLog log;
  ASSERT_EQ(runStock(log, "rbpf-slam", iniOf("rbpf-slam"), "frames.rawlog"), 0) << log.said();
  constexpr bool inStartFrame = true;
  log.expectRightShape(kRbpfMap + "_occupancy.tif", inStartFrame);
}

TEST(ScanShapeMaps, PfLocalizationFindsItselfInTheMapOfASimpleMapAndInASavedOne)
{
  const SlamLog log;
  ASSERT_EQ(runStock(log, "pf-localization", iniOf("pf-localization"), "frames.rawlog"), 0)
      << log.said();
  EXPECT_LT(log.errorOfEstimate(), 0.3) << log.said();
  log.expectRightShape(kPfMap + "_occupancy.tif", false);

  ASSERT_EQ(runStock(log, "observations2map", iniOf("observations2map"), "scans.simplemap out"), 0)
      << log.said();
  std::filesystem::remove_all(log.file("LOG_PF_000_0040000"));
  ASSERT_EQ(runStock(log, "pf-localization", iniForSavedMap(log), "frames.rawlog"), 0)
      << log.said();
  EXPECT_LT(log.errorOfEstimate(), 0.3) << log.said();
  EXPECT_TRUE(std::filesystem::exists(log.file(kPfMap + "_occupancy.tif")));
}

TEST(ScanShapeMaps, WithoutThe3DScansNothingIsKnown)
{
  SlamLog log;
  log.remove3D();
  ASSERT_EQ(runStock(log, "icp-slam", iniOf("icp-slam"), "scans.rawlog"), 0) << log.said();
  expectUnknown(log, kIcpMap);
  ASSERT_EQ(runStock(log, "rbpf-slam", iniOf("rbpf-slam"), "frames.rawlog"), 0) << log.said();
  expectUnknown(log, kRbpfMap);
  ASSERT_EQ(runStock(log, "observations2map", iniOf("observations2map"), "scans.simplemap out"), 0)
      << log.said();
  expectUnknown(log, "out_" + kClass + "00");
  for (const auto& ini : {iniOf("pf-localization"), iniForSavedMap(log)})
  {
    EXPECT_NE(runStock(log, "pf-localization", ini, "frames.rawlog"), 0);
    EXPECT_NE(log.said().find("Assert condition failed: nFreeCells"), std::string::npos)
        << log.said();
  }
}
