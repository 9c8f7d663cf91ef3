#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <filesystem>
#include <fstream>

#include "StepScans.h"
#include "step_grid/CStepGridMap2D.h"
#include "support/TempDir.h"

// What MRPT wants of a map class, asked of one that is little more than its algorithm.

using namespace step_grid;
using namespace step_grid::testing;
using mrpt::poses::CPose3D;
using mrpt_mapconv::testing::TempDir;

namespace
{
CStepGridMap2D kerbMap()
{
  CStepGridMap2D map(0.1);
  EXPECT_TRUE(map.insertObservation(kerbScan(), CPose3D()));
  return map;
}

/** By hand: the high kerb is a step, the low one and the floor are free. */
void expectKerbs(const CStepGridMap2D& map)
{
  EXPECT_LT(map.getPos(0.55f, 0.25f), 0.1f);
  EXPECT_GT(map.getPos(-0.55f, 0.25f), 0.9f);
  EXPECT_GT(map.getPos(0.05f, -0.35f), 0.9f);
  EXPECT_EQ(map.getPos(3, 0), 0.5f);
  EXPECT_FALSE(map.isEmpty());
}

mrpt::maps::CMultiMetricMap fromIni(const std::string& text)
{
  const mrpt::config::CConfigFileMemory ini(text);
  mrpt::maps::TSetOfMetricMapInitializers makers;
  makers.loadFromConfigFile(ini, "map");
  mrpt::maps::CMultiMetricMap maps;
  maps.setListOfMaps(makers);
  return maps;
}
}  // namespace

TEST(CStepGridMap2D, ShowsSteps) { expectKerbs(kerbMap()); }

TEST(CStepGridMap2D, ComesFromAnIniFile)
{
  const auto maps = fromIni(
      "[map]\nstepGrid_count = 1\n"
      "[map_stepGrid_00_creationOpts]\nresolution = 0.2\n"
      "[map_stepGrid_00_insertOpts]\nmaxStep = 0.05\nmaxRange = 7\n"
      "[map_stepGrid_00_likelihoodOpts]\nLF_decimation = 3\n");
  const auto map = maps.mapByClass<CStepGridMap2D>();
  ASSERT_TRUE(map);
  EXPECT_EQ(map->cellSize(), 0.2);
  EXPECT_EQ(map->insertionParams.maxStep, 0.05);
  EXPECT_EQ(map->insertionParams.maxRange, 7);
  EXPECT_EQ(map->likelihoodOptions.LF_decimation, 3u);
  EXPECT_TRUE(maps.mapByClass<mrpt::maps::COccupancyGridMap2D>());
}

TEST(CStepGridMap2D, RefusesBadIniValues)
{
  const auto message = [](const std::string& key)
  {
    return mrpt_mapconv::testing::messageOf<std::exception>(
        [&] { fromIni("[map]\nstepGrid_count = 1\n[map_stepGrid_00_insertOpts]\n" + key + "\n"); });
  };
  EXPECT_NE(message("maxStep = high").find("maxStep = 'high'"), std::string::npos);
  EXPECT_NE(message("maxStep = -1").find("maxStep = -1"), std::string::npos);
}

TEST(CStepGridMap2D, ComesBackFromAStream)
{
  auto map = kerbMap();
  map.insertionParams.maxStep = 0.3;
  map.insertionParams.maxRange = 5;
  map.likelihoodOptions.LF_useSquareDist = true;
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << map;
  stream.Seek(0);
  const auto object = archive.ReadObject();
  auto read = std::dynamic_pointer_cast<CStepGridMap2D>(object);
  ASSERT_TRUE(read);
  expectKerbs(*read);
  EXPECT_TRUE(read->getRawMap() == map.getRawMap());
  EXPECT_EQ(read->cellSize(), 0.1);
  EXPECT_EQ(read->insertionParams.maxStep, 0.3);
  EXPECT_EQ(read->insertionParams.maxRange, 5);
  EXPECT_TRUE(read->likelihoodOptions.LF_useSquareDist);
  // it goes on as the other does
  read->insertObservation(kerbScan(1), CPose3D());
  map.insertObservation(kerbScan(1), CPose3D());
  EXPECT_TRUE(read->getRawMap() == map.getRawMap());
}

TEST(CStepGridMap2D, IsDrawn)
{
  mrpt::opengl::CSetOfObjects scene;
  kerbMap().getVisualizationInto(scene);
  EXPECT_TRUE(scene.getByName("height"));
  EXPECT_TRUE(scene.getByName("occupancy"));
  mrpt::opengl::CSetOfObjects nothing;
  CStepGridMap2D(0.1).getVisualizationInto(nothing);
  EXPECT_TRUE(nothing.empty());
}

TEST(CStepGridMap2D, IsSaved)
{
  const TempDir dir;
  kerbMap().saveMetricMapRepresentationToFile(dir.path("m"));
  for (const char* name :
       {"m.png", "m_limits.txt", "m_layers.tif", "m_height.png", "m_occupancy.png", "m_times.csv"})
    EXPECT_TRUE(std::filesystem::exists(dir.path(name))) << name;
  EXPECT_EQ(dir.entries(), 6u);
  const auto steps = mrpt_mapconv::grid::readGeoTiffBand(dir.path("m_layers.tif"), "occupancy");
  EXPECT_EQ(steps.cells()[steps.frame().indexOfKey(5, 2)], 1);
}

TEST(CStepGridMap2D, IsCopied)
{
  auto map = kerbMap();
  mrpt::maps::CMultiMetricMap particle;
  particle.maps.push_back(std::make_shared<CStepGridMap2D>(map));
  const mrpt::maps::CMultiMetricMap copied(particle);
  CStepGridMap2D assigned(0.3);
  assigned = map;
  map.clear();
  EXPECT_TRUE(map.isEmpty());
  expectKerbs(*copied.mapByClass<CStepGridMap2D>());
  expectKerbs(assigned);
  EXPECT_EQ(assigned.cellSize(), 0.1);
}

TEST(CStepGridMap2D, SurvivesThatMrptResizesItsGrid)
{
  auto map = kerbMap();
  const auto right = map.getRawMap();
  map.resizeGrid(-50, 50, -50, 50);
  const CStepGridMap2D copy(map);
  EXPECT_TRUE(copy.getRawMap() == right);
  map.auxParticleFilterCleanUp();
  EXPECT_TRUE(map.getRawMap() == right);
  map.setSize(-20, 20, -20, 20, 0.1f);
  map.insertObservation(kerbScan(), CPose3D());
  EXPECT_TRUE(map.getRawMap() == right);
}

TEST(CStepGridMap2D, SaysWhatItSkips)
{
  auto map = kerbMap();
  map.insertionParams.maxRange = 0.5;
  EXPECT_FALSE(map.insertObservation(kerbScan(), CPose3D()));
  EXPECT_EQ(map.lastSkip(), "it has no point within maxRange");
}

/** As the maps of a particle filter are made. */
TEST(CStepGridMap2D, SaysOnceForAllMapsOfADefinitionWhatTheySkip)
{
  const mrpt::config::CConfigFileMemory ini(
      "[map]\nstepGrid_count = 1\n[map_stepGrid_00_insertOpts]\nmaxRange = 0.5\n");
  mrpt::maps::TSetOfMetricMapInitializers makers;
  makers.loadFromConfigFile(ini, "map");
  std::size_t warnings = 0;
  for (int particle = 0; particle < 3; ++particle)
  {
    mrpt::maps::CMultiMetricMap maps;
    maps.setListOfMaps(makers);
    const auto map = maps.mapByClass<CStepGridMap2D>();
    map->log().logRegisterCallback([&](std::string_view, const mrpt::system::VerbosityLevel level,
                                       std::string_view, const mrpt::Clock::time_point)
                                   { warnings += level == mrpt::system::LVL_WARN; });
    EXPECT_FALSE(map->insertObservation(kerbScan(), CPose3D()));
  }
  EXPECT_EQ(warnings, 1u);
}

/** A class costs about 150 lines beside its algorithm: what LayerGridMap2D does not do for it. */
TEST(CStepGridMap2D, HasAtMost150Lines)
{
  std::size_t lines = 0;
  for (const char* ending : {".h", ".cpp"})
  {
    std::ifstream file(std::string(MRPT_MAPCONV_SOURCE_DIR) +
                       "/tests/map_class/step_grid/CStepGridMap2D" + ending);
    ASSERT_TRUE(file);
    for (std::string line; std::getline(file, line);) ++lines;
  }
  EXPECT_GT(lines, 50u);
  EXPECT_LE(lines, 150u);
}
