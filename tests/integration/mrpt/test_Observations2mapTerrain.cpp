#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdlib>

#include "unit/maps/TerrainFixtures.h"

// The stock program observations2map with our terrain map, from its ini file and our plugin.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;

namespace
{
const std::string kIniFile =
    std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/terrainGrid/observations2map.ini";
const std::string kPreload =
    "LD_PRELOAD=libmrpt_mapconv.so LD_LIBRARY_PATH=\"$(dirname '" MRPT_MAPCONV_LIBRARY "')\" ";

/** A step of 0.15 m between the cells at x = 0.05 and 0.1, and one 2 m farther on. */
std::string stepsSimpleMap(const TempDir& dir)
{
  mrpt::maps::CSimpleMap map;
  for (const double x : {0.0, 2.0})
  {
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(std::make_shared<mrpt::obs::CObservationPointCloud>(stepScan(0.075f)));
    mrpt::poses::CPose3DPDFGaussian pose;
    pose.mean = mrpt::poses::CPose3D(x, 0, 0);
    map.insert(pose, *frame);
  }
  const auto file = dir.file("steps.simplemap");
  EXPECT_TRUE(map.saveToFile(file));
  return file;
}

int build(const TempDir& dir, const std::string& ini, const std::string& preload = kPreload)
{
  const auto simplemap = stepsSimpleMap(dir);
  return std::system(("cd '" + dir.path() + "' && " + preload + "observations2map '" + ini + "' '" +
                      simplemap + "' out </dev/null >log 2>&1")
                         .c_str());
}

/** The ini file with another value. */
std::string iniWith(const TempDir& dir, const std::string& from, const std::string& to)
{
  auto ini = readBytes(kIniFile);
  EXPECT_NE(ini.find(from), std::string::npos);
  ini.replace(ini.find(from), from.size(), to);
  writeBytes(dir.file("other.ini"), ini);
  return dir.file("other.ini");
}

CTerrainGridMap2D savedMap(const TempDir& dir)
{
  mrpt::io::CFileGZInputStream file(dir.file("out_gridmap_no00.gridmap"));
  CTerrainGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  return map;
}
}  // namespace

TEST(Observations2mapTerrain, BuildsOurMapFromItsIniWithThePluginPreloaded)
{
  const TempDir dir;
  ASSERT_EQ(build(dir, iniWith(dir, "maxStep        = 0.2", "maxStep        = 0.1")), 0)
      << readBytes(dir.file("log"));
  const auto map = savedMap(dir);
  EXPECT_EQ(map.cellSize(), 0.05);
  double z = 0;
  for (const auto& [x, height] : {std::pair{-0.5, 0.0}, {0.5, 0.15}, {1.5, 0.0}, {2.5, 0.15}})
  {
    ASSERT_TRUE(map.dem_get_z(x, 0.3, z)) << x;
    EXPECT_NEAR(z, height, 0.002) << x;
    EXPECT_GT(map.getPos(static_cast<float>(x), 0.3f), 0.9f) << x;
  }
  for (const float x : {0.05f, 0.1f, 2.05f, 2.1f}) EXPECT_LT(map.getPos(x, 0.3f), 0.1f) << x;
  EXPECT_EQ(map.getPos(4, 0), 0.5f);
  for (const char* ending : {"_layers.tif", "_leaves.png", "_planes.csv", "_steps.csv"})
    EXPECT_TRUE(std::filesystem::exists(
        dir.file(std::string("out_mrpt_mapconv__CTerrainGridMap2D_00") + ending)))
        << ending;
}

TEST(Observations2mapTerrain, KnowsNothingOfOurMapWithoutThePlugin)
{
  const TempDir dir;
  build(dir, kIniFile, "");
  EXPECT_FALSE(std::filesystem::exists(dir.file("out_gridmap_no00.gridmap")));
}

TEST(Observations2mapTerrain, SaysWhichIniValueIsWrong)
{
  const TempDir dir;
  EXPECT_NE(build(dir, iniWith(dir, "hypotheses     = 12", "hypotheses     = many")), 0);
  const auto said = readBytes(dir.file("log"));
  EXPECT_TRUE(contains(said, "section 'MappingApplication_terrainGrid_00_terrainOpts'")) << said;
  EXPECT_TRUE(contains(said, "hypotheses = 'many'")) << said;
}
