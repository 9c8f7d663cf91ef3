#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdlib>

#include "unit/maps/FreeSpaceMapFixtures.h"

// The stock program observations2map, driven only by its ini file and our plugin.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;

namespace
{
const std::string kIniFile =
    std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/freeSpaceGrid/observations2map.ini";
const std::string kIni = "'" + kIniFile + "'";
const std::string kPreload =
    "LD_PRELOAD=libmrpt_mapconv.so LD_LIBRARY_PATH=\"$(dirname '" MRPT_MAPCONV_LIBRARY "')\" ";

/** Four scans of a room of 6 × 6 m whose middle is (0, 0), taken 0.1 m apart along x. */
std::string roomSimpleMap(const TempDir& dir)
{
  mrpt::maps::CSimpleMap map;
  for (int i = 0; i < 4; ++i)
  {
    auto scan = std::make_shared<mrpt::obs::CObservationPointCloud>(roomScan(0));
    for (std::size_t p = 0; p < scan->pointcloud->size(); ++p)
    {
      float x = 0, y = 0, z = 0;
      scan->pointcloud->getPoint(p, x, y, z);
      scan->pointcloud->setPoint(p, x - 0.1f * static_cast<float>(i), y, z);
    }
    scan->sensorPose = mrpt::poses::CPose3D(0, 0, 1);
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(scan);
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.mean = mrpt::poses::CPose3D(0.1 * i, 0, 0);
    map.insert(pose, *frame);
  }
  const auto file = dir.file("room.simplemap");
  EXPECT_TRUE(map.saveToFile(file));
  return file;
}

int run(const std::string& command, const TempDir& dir)
{
  return std::system(("cd " + dir.path() + " && " + command + " </dev/null >log 2>&1").c_str());
}

void expectRoom(const std::string& gridmap)
{
  mrpt::io::CFileGZInputStream file(gridmap);
  ASSERT_TRUE(file.fileOpenCorrectly()) << gridmap;
  CFreeSpaceGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  EXPECT_FALSE(map.isEmpty());
  // by hand: the floor is free, the walls at x, y = ±3 m are occupied, beyond is unknown
  for (const auto& [x, y] : {std::pair{1.5f, 0.f}, {1.f, -1.f}, {-0.5f, 1.2f}})
    EXPECT_GT(map.getPos(x, y), 0.9f) << x << ' ' << y;
  std::size_t walls = 0;
  for (float along = -2; along <= 2; along += 0.1f)
    for (const float wall : {-3.05f, -2.95f, 2.95f, 3.05f})
      walls += static_cast<std::size_t>(map.getPos(wall, along) < 0.5f) +
               static_cast<std::size_t>(map.getPos(along, wall) < 0.5f);
  EXPECT_GT(walls, 80u);  // 4 walls of 4 m
  EXPECT_EQ(map.getPos(3.5f, 0), 0.5f);
  const auto& floor = map.layers().floor;
  EXPECT_NEAR(floor.at(15 - floor.frame().x0, -floor.frame().y0), 0, 0.11);  // at (1.5, 0)
}
}  // namespace

TEST(Observations2map, BuildsOurMapFromItsIniWithThePluginPreloaded)
{
  const TempDir dir;
  const auto simplemap = roomSimpleMap(dir);
  ASSERT_EQ(run(kPreload + "observations2map " + kIni + " " + simplemap + " out", dir), 0)
      << readBytes(dir.file("log"));
  expectRoom(dir.file("out_gridmap_no00.gridmap"));
  EXPECT_TRUE(
      std::filesystem::exists(dir.file("out_mrpt_mapconv__CFreeSpaceGridMap2D_00_layers.tif")));
}

TEST(Observations2map, RunsThroughMapconv)
{
  const TempDir dir;
  const auto simplemap = roomSimpleMap(dir);
  ASSERT_EQ(run(std::string("'" MAPCONV_PROGRAM "'") + " run -- observations2map " + kIni + " " +
                    simplemap + " out",
                dir),
            0)
      << readBytes(dir.file("log"));
  expectRoom(dir.file("out_gridmap_no00.gridmap"));
}

TEST(Observations2map, KnowsNothingOfOurMapWithoutThePlugin)
{
  const TempDir dir;
  const auto simplemap = roomSimpleMap(dir);
  run("observations2map " + kIni + " " + simplemap + " out", dir);
  EXPECT_FALSE(std::filesystem::exists(dir.file("out_gridmap_no00.gridmap")));
}

TEST(Observations2map, SaysWhichIniValueIsWrong)
{
  const TempDir dir;
  const auto simplemap = roomSimpleMap(dir);
  auto ini = readBytes(kIniFile);
  const std::string good = "slopeWindow  = 2";
  ASSERT_NE(ini.find(good), std::string::npos);
  ini.replace(ini.find(good), good.size(), "slopeWindow  = two");
  writeBytes(dir.file("bad.ini"), ini);
  EXPECT_NE(run(kPreload + "observations2map bad.ini " + simplemap + " out", dir), 0);
  const auto said = readBytes(dir.file("log"));
  EXPECT_TRUE(contains(said, "MappingApplication_freeSpaceGrid_00_conversionOpts")) << said;
  EXPECT_TRUE(contains(said, "slopeWindow = 'two'")) << said;
}
