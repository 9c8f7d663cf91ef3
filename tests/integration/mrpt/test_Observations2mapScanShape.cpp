#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <cstdlib>

#include "unit/maps/ScanShapeFixtures.h"

// The stock program observations2map with our scan-shape map, from its ini file and our plugin.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

namespace
{
const std::string kIniFile =
    std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/scanShapeGrid/observations2map.ini";
const std::string kPreload =
    "LD_PRELOAD=libmrpt_mapconv.so LD_LIBRARY_PATH=\"$(dirname '" MRPT_MAPCONV_LIBRARY "')\" ";
const std::string kSaved = "out_mrpt_mapconv__CScanShapeGridMap2D_00_occupancy.tif";

/** Four key frames in a room, each with a 2D scan and, if asked for, a 3D scan. */
std::string roomSimpleMap(const TempDir& dir, const Room& room, bool with3D)
{
  mrpt::maps::CSimpleMap map;
  for (int i = 0; i < 4; ++i)
  {
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.mean = CPose3D(0.3 * i, 0.1 * i, 0, 0.2 * i, 0, 0);
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(scan2DOf(room, pose.mean)));
    if (with3D)
      frame->insert(std::make_shared<mrpt::obs::CObservationPointCloud>(scanOf(room, pose.mean)));
    map.insert(pose, *frame);
  }
  const auto file = dir.file("room.simplemap");
  EXPECT_TRUE(map.saveToFile(file));
  return file;
}

int build(const TempDir& dir, const std::string& ini, const std::string& simplemap)
{
  return std::system(("cd '" + dir.path() + "' && " + kPreload + "observations2map '" + ini +
                      "' '" + simplemap + "' out </dev/null >log 2>&1")
                         .c_str());
}

CScanShapeGridMap2D savedMap(const TempDir& dir)
{
  mrpt::io::CFileGZInputStream file(dir.file("out_gridmap_no00.gridmap"));
  CScanShapeGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  return map;
}
}  // namespace

TEST(Observations2mapScanShape, BuildsOurMapFromItsIniWithThePluginPreloaded)
{
  const TempDir dir;
  const Room room{-3, 4, -2, 2.5, 2.5};
  ASSERT_EQ(build(dir, kIniFile, roomSimpleMap(dir, room, true)), 0) << readBytes(dir.file("log"));
  const auto map = savedMap(dir);
  EXPECT_EQ(map.frame().resolution, 0.05);
  // by hand: four times free are 12/16 of log-odds, beyond the walls unknown
  for (const auto& [x, y] : {std::pair{1.52f, 0.f}, {1.f, -1.f}, {-0.5f, 1.2f}, {-2.5f, -1.5f}})
    EXPECT_NEAR(map.getPos(x, y), 0.6792f, 0.001f) << x << ' ' << y;
  std::size_t walls = 0;
  for (float along = -1.8f; along <= 1.85f; along += 0.1f)
    for (const float x : {-3.02f, -2.98f, 3.98f, 4.02f})
      walls += static_cast<std::size_t>(map.getPos(x, along) < 0.5f);
  EXPECT_GE(walls, 74u);  // two walls of 3.7 m, a cell thick or two
  EXPECT_EQ(map.getPos(4.2f, 0), 0.5f);
  EXPECT_EQ(map.getPos(0, -2.2f), 0.5f);

  const auto band = grid::readGeoTiffBand(dir.file(kSaved), "occupancy");
  EXPECT_EQ(band.frame(), map.frame());
}

TEST(Observations2mapScanShape, KnowsNothingWithoutThe3DScans)
{
  const TempDir dir;
  ASSERT_EQ(build(dir, kIniFile, roomSimpleMap(dir, Room(), false)), 0)
      << readBytes(dir.file("log"));
  const auto occupancy = grid::readGeoTiffBand(dir.file(kSaved), "occupancy");
  ASSERT_FALSE(occupancy.cells().empty());
  for (const float cell : occupancy.cells()) ASSERT_TRUE(std::isnan(cell)) << cell;
}

TEST(Observations2mapScanShape, SaysWhichIniValueIsWrong)
{
  const TempDir dir;
  auto ini = readBytes(kIniFile);
  const std::string good = "structureMinZ    = 2.1";
  ASSERT_NE(ini.find(good), std::string::npos);
  ini.replace(ini.find(good), good.size(), "structureMinZ    = two");
  writeBytes(dir.file("bad.ini"), ini);
  EXPECT_NE(build(dir, dir.file("bad.ini"), roomSimpleMap(dir, Room(), true)), 0);
  const auto said = readBytes(dir.file("log"));
  EXPECT_TRUE(contains(said, "section 'MappingApplication_scanShapeGrid_00_insertOpts'")) << said;
  EXPECT_TRUE(contains(said, "structureMinZ = 'two'")) << said;
}
