#include <gtest/gtest.h>
#include <mrpt/version.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "StoredMaps.h"
#include "support/ScanFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::maps::CMultiMetricMap;
using mrpt::serialization::CSerializable;

// Maps that somebody has saved must load for ever, as they were, and a map must be saved with the
// same bytes: tests/stored_streams holds what released versions have written, a folder for each
// that wrote other bytes than the one before. All of them must load; maps are saved as the newest
// has it. To write the files of a new version, run these tests with MAPCONV_WRITE_STORED=its
// folder; those of a version that is out stay as they are.

namespace
{
/** The folders with streams, the newest last. */
std::vector<std::string> folders()
{
  std::vector<std::string> all;
  for (const auto& folder :
       std::filesystem::directory_iterator(MRPT_MAPCONV_SOURCE_DIR "/tests/stored_streams"))
    all.push_back(folder.path().string() + "/");
  std::sort(all.begin(), all.end());
  return all;
}

/** What a version has stored. */
class StoredVersion : public ::testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(Streams, StoredVersion, ::testing::ValuesIn(folders()));

std::string textOf(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

CSerializable::Ptr load(const std::string& file)
{
  const std::string stored = readBytes(file);
  CSerializable::Ptr object;
  mrpt::serialization::OctetVectorToObject({stored.begin(), stored.end()}, object);
  return object;
}

template <class Map>
std::shared_ptr<Map> loadAs(const std::string& file)
{
  auto map = std::dynamic_pointer_cast<Map>(load(file));
  EXPECT_TRUE(map) << file;
  return map;
}

void expectSameBytes(const std::string& expected, const std::string& actual,
                     const std::string& file)
{
  EXPECT_EQ(expected.size(), actual.size()) << file;
  const auto different =
      std::mismatch(expected.begin(), expected.end(), actual.begin(), actual.end()).first;
  EXPECT_TRUE(expected == actual) << file << " differs from byte "
                                  << std::distance(expected.begin(), different) << " on";
}

bool hasTerrain(const std::string& folder) { return folder.find("v0.1") == std::string::npos; }

/** The bytes of MRPT's own parts, a grid and its options, are MRPT's to change. */
bool bytesAreMrpt258s() { return MRPT_VERSION == 0x258; }
}  // namespace

TEST(StoredStreams, AMapMadeAnewHasTheStoredBytes)
{
  if (!bytesAreMrpt258s()) GTEST_SKIP() << "the streams hold objects of MRPT 2.5.8";
  const char* folder = std::getenv("MAPCONV_WRITE_STORED");
  for (const auto& [file, make] : storedStreams())
  {
    const std::string made = textOf(bytes(*make()));
    if (folder) writeBytes(std::string(folder) + "/" + file, made);
    expectSameBytes(readBytes(folders().back() + file), made, file);
  }
}

TEST(StoredStreams, ALoadedMapIsSavedWithTheSameBytes)
{
  if (!bytesAreMrpt258s()) GTEST_SKIP() << "the streams hold objects of MRPT 2.5.8";
  for (const auto& [file, make] : storedStreams())
  {
    const std::string path = folders().back() + file;
    const auto object = load(path);
    ASSERT_TRUE(object) << path;
    expectSameBytes(readBytes(path), textOf(bytes(*object)), path);
  }
}

TEST_P(StoredVersion, AnEmptyFreeSpaceMapHasTheDefaults)
{
  const auto map = loadAs<CFreeSpaceGridMap2D>(GetParam() + "freespace_empty.bin");
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->isEmpty());
  EXPECT_EQ(0.1, map->octree().getResolution());
  EXPECT_EQ(freespace::Robot::Ground, map->conversionOptions().robot);
  EXPECT_EQ(1.0, map->conversionOptions().params.minClearance);
  EXPECT_EQ(0.5, map->conversionOptions().params.minOccupancy);
  EXPECT_EQ(2, map->conversionOptions().params.slopeWindow);
  EXPECT_EQ(2.0, map->conversionOptions().params.maxSlope);
  const bool isOlder = GetParam() != folders().back();
  const auto paper = freespace::ConversionParams::paper();
  const freespace::ConversionParams safe;
  EXPECT_EQ((isOlder ? paper : safe).maxStep, map->conversionOptions().params.maxStep);
  EXPECT_EQ((isOlder ? paper : safe).floorFrom, map->conversionOptions().params.floorFrom);
  EXPECT_EQ(-1, map->voxelInsertionOptions.maxrange);
  EXPECT_TRUE(map->voxelInsertionOptions.pruning);
  EXPECT_EQ(0.5, map->voxelInsertionOptions.occupancyThres);
  EXPECT_EQ(0.7, map->voxelInsertionOptions.probHit);
  EXPECT_EQ(0.4, map->voxelInsertionOptions.probMiss);
  EXPECT_EQ(0.1192, map->voxelInsertionOptions.clampingThresMin);
  EXPECT_EQ(0.971, map->voxelInsertionOptions.clampingThresMax);
  EXPECT_TRUE(map->voxelInsertionOptions.insert2D);
  EXPECT_TRUE(map->renderingOptions.showFloor);
  EXPECT_FALSE(map->renderingOptions.showCeiling);
  EXPECT_FALSE(map->renderingOptions.colorBySlope);
  EXPECT_FALSE(map->likelihoodOptions.LF_useSquareDist);
  EXPECT_EQ(0.35f, map->likelihoodOptions.LF_stdHit);
  EXPECT_EQ(0, map->insertionOptions.maxFreenessUpdateCertainty);
  EXPECT_EQ(0, map->insertionOptions.maxFreenessInvalidRanges);
  EXPECT_TRUE(map->genericMapParams.enableSaveAs3DObject);
}

TEST_P(StoredVersion, AnEmptyScanShapeMapHasTheDefaults)
{
  const auto map = loadAs<CScanShapeGridMap2D>(GetParam() + "scanshape_empty.bin");
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->isEmpty());
  EXPECT_EQ(0.05, map->frame().resolution);
  EXPECT_EQ(4e8, map->maxGridCells);
  const auto& profile = map->scanInsertionOptions.profile;
  EXPECT_EQ(scan::Model::WholeShape, profile.model);
  EXPECT_EQ(0.05, profile.objectMinZ);
  EXPECT_EQ(1.5, profile.objectMaxZ);
  EXPECT_TRUE(profile.reflectionFilter);
  EXPECT_TRUE(std::isnan(profile.structureMinZ));
  EXPECT_TRUE(std::isnan(profile.structureMaxZ));
  EXPECT_EQ(0.3, profile.minRange);
  EXPECT_EQ(20, profile.maxRange);
  EXPECT_EQ(0, profile.sectors);
  EXPECT_EQ(-1, profile.structureGap);
  EXPECT_EQ(-1, profile.structureTolerance);
  EXPECT_EQ(0.7, map->scanInsertionOptions.update.pHit);
  EXPECT_EQ(0.45, map->scanInsertionOptions.update.pMiss);
  EXPECT_EQ(0.03, map->scanInsertionOptions.update.pMin);
  EXPECT_EQ(0.97, map->scanInsertionOptions.update.pMax);
  EXPECT_TRUE(map->scanInsertionOptions.insert2D);
  EXPECT_FALSE(map->likelihoodOptions.LF_useSquareDist);
  EXPECT_EQ(0.65f, map->insertionOptions.maxOccupancyUpdateCertainty);
  EXPECT_TRUE(map->genericMapParams.enableSaveAs3DObject);
}

TEST_P(StoredVersion, AFreeSpaceMapHasItsOptionsAndLayers)
{
  const auto map = loadAs<CFreeSpaceGridMap2D>(GetParam() + "freespace_scans.bin");
  ASSERT_TRUE(map);
  expectStoredFreeSpaceOptions(*map);
  expectStoredFreeSpaceCells(*map);
}

TEST_P(StoredVersion, AScanShapeMapHasItsOptionsAndCells)
{
  const auto map = loadAs<CScanShapeGridMap2D>(GetParam() + "scanshape_scans.bin");
  ASSERT_TRUE(map);
  expectStoredScanShapeOptions(*map);
  expectStoredScanShapeCells(*map);
}

TEST_P(StoredVersion, AMultiMetricMapHasBoth)
{
  const auto both = loadAs<CMultiMetricMap>(GetParam() + "multimetric.bin");
  ASSERT_TRUE(both);
  ASSERT_EQ(2u, both->maps.size());
  const auto freeSpace = both->mapByClass<CFreeSpaceGridMap2D>();
  const auto scanShape = both->mapByClass<CScanShapeGridMap2D>();
  ASSERT_TRUE(freeSpace && scanShape);
  expectStoredFreeSpaceOptions(*freeSpace);
  expectStoredFreeSpaceCells(*freeSpace);
  expectStoredScanShapeOptions(*scanShape);
  expectStoredScanShapeCells(*scanShape);
}

/** Versions before 0.3 knew no terrain maps. */
TEST_P(StoredVersion, AnEmptyTerrainMapHasTheDefaults)
{
  if (!hasTerrain(GetParam())) GTEST_SKIP() << GetParam() << " is older than terrain maps";
  const auto map = loadAs<CTerrainGridMap2D>(GetParam() + "terrain_empty.bin");
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->isEmpty());
  EXPECT_EQ(0.05, map->cellSize());
  EXPECT_EQ(1e8, map->maxGridCells);
  EXPECT_EQ(30, map->terrainInsertionOptions.limits.maxRange);
  EXPECT_EQ(-100, map->terrainInsertionOptions.limits.minHeight);
  EXPECT_EQ(2, map->terrainInsertionOptions.limits.maxHeight);
  EXPECT_EQ(0.02, map->terrainInsertionOptions.sigmas.range);
  EXPECT_EQ(terrain::HeightRule::Fused, map->terrain().params().heightRule);
  EXPECT_EQ(0.02, map->terrain().params().planeTolerance);
  EXPECT_EQ(0.2, map->terrain().params().maxStep);
  EXPECT_EQ(0, map->terrain().params().localWindow);
  EXPECT_TRUE(map->renderingOptions.showLeaves);
  EXPECT_TRUE(map->renderingOptions.showOutlines);
}

TEST_P(StoredVersion, ATerrainMapHasItsOptionsAndCells)
{
  if (!hasTerrain(GetParam())) GTEST_SKIP() << GetParam() << " is older than terrain maps";
  const auto map = loadAs<CTerrainGridMap2D>(GetParam() + "terrain_scans.bin");
  ASSERT_TRUE(map);
  expectStoredTerrainOptions(*map);
  expectStoredTerrainCells(*map);
}
