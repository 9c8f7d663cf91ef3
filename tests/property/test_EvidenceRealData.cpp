// Floors with evidence on real maps: against the brute-force twin, and what must not be there.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "CompareLayers.h"
#include "DenseSource.h"
#include "RandomGround.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using freespace::ConversionParams;
using freespace::Layers;
using oracle::DenseMap;

void expectAgreesOn(const DenseMap& map, const voxel::VoxelSource& source, std::size_t inferred)
{
  for (const double maxStep : {0.0, 0.16, 0.35})
    for (const double maxGap : {6.0, 2.0})
    {
      auto params = ConversionParams::paper();
      params.floorFrom = freespace::FloorFrom::Seen;
      params.maxStep = maxStep;
      params.maxGap = maxGap;
      if (maxGap < 3) params.minClearance = params.maxHiddenGap = 0.6;
      SCOPED_TRACE(text(params));
      const oracle::DenseResult expected = oracle::convert(map, params);
      EXPECT_GE(oracle::statistics(expected).inferred, inferred);
      const Layers layers = freespace::convert(source, params, 2);
      EXPECT_TRUE(agreesWithOracle(layers, map, expected));
      EXPECT_TRUE(countsAgree(freespace::statistics(layers), expected));
      EXPECT_TRUE(sameBits(layers, freespace::convert(source, params, 1)));
    }
}

/** Takes away the ground, but not what is free above it, in some places. */
void unsee(Rng& rng, DenseMap& map)
{
  for (int i = 0; i < 60; ++i)
  {
    const int x = pick(rng, 0, map.nx - 1), y = pick(rng, 0, map.ny - 1);
    const int xEnd = std::min(map.nx, x + pick(rng, 1, 25));
    const int yEnd = std::min(map.ny, y + pick(rng, 1, 10));
    for (int iy = y; iy < yEnd; ++iy)
      for (int ix = x; ix < xEnd; ++ix)
        for (int iz = 1; iz < map.nz; ++iz)
          if (map.at(ix, iy, iz) == oracle::Voxel::Free &&
              map.at(ix, iy, iz - 1) == oracle::Voxel::Occupied)
            map.at(ix, iy, iz - 1) = oracle::Voxel::Unknown;
  }
}

void expectAgreesOn(const std::string& name, std::size_t inferred)
{
  const std::filesystem::path file = std::filesystem::path(MRPT_MAPCONV_SHARED_DIR) / name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  octomap::OcTree tree(0.1);
  ASSERT_TRUE(tree.readBinary(file.string()));
  DenseMap map = oracle::denseMap(tree);
  expectAgreesOn(map, voxel::OctreeSource<octomap::OcTree>(tree), inferred);
  Rng rng(1);
  unsee(rng, map);
  map = trimmed(map);
  expectAgreesOn(map, DenseSource(map), 100);
}

TEST(EvidenceOfRealData, AgreesWithTheOracleOnGeb079) { expectAgreesOn("geb079.bt", 1000); }
TEST(EvidenceOfRealData, AgreesWithTheOracleOnTheCliff) { expectAgreesOn("reports/cliff.bt", 100); }
TEST(EvidenceOfRealData, AgreesWithTheOracleOnTheFence) { expectAgreesOn("reports/fence09.bt", 0); }

TEST(EvidenceOfRealData, AgreesWithTheOracleOnCasoplon) { expectAgreesOn("real/casoplon.bt", 50); }

/** Free inferred cells with an occupied voxel more than a step and less than minClearance over
 * their ground: by all voxels. */
int blockedCells(const DenseMap& map, const Layers& layers, const ConversionParams& params)
{
  const double step = params.maxStepVoxels(map.resolution) * map.resolution;
  int blocked = 0;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      if (layers.evidence.at(ix, iy) != 2 || layers.ground.at(ix, iy) != 0) continue;
      bool stands = false;
      for (int iz = 0; iz < map.nz; ++iz)
      {
        const double top = (map.z0 + iz + 1) * map.resolution;
        const auto ground = static_cast<double>(layers.support.at(ix, iy));
        stands |= map.at(ix, iy, iz) == oracle::Voxel::Occupied && top > ground + step + 1e-5 &&
                  top - map.resolution < ground + params.minClearance - 1e-5;
      }
      blocked += stands;
    }
  return blocked;
}

TEST(EvidenceOfRealData, NothingIsKnownToStandOnGroundThatIsInferred)
{
  const std::filesystem::path shared = MRPT_MAPCONV_SHARED_DIR;
  const std::string names[] = {"geb079.bt", "real/casoplon.bt", "real/catec.bt"};
  for (const std::string& name : names)
    if (!std::filesystem::exists(shared / name)) GTEST_SKIP() << name << " is not there";
  for (const std::string& name : names)
  {
    octomap::OcTree tree(0.1);
    ASSERT_TRUE(tree.readBinary((shared / name).string()));
    for (const double minClearance : {0.5, 1.0, 1.5})
    {
      ConversionParams params;
      params.minClearance = minClearance;
      const Layers layers =
          freespace::convert(voxel::OctreeSource<octomap::OcTree>(tree), params, 1);
      EXPECT_EQ(blockedCells(oracle::denseMap(tree), layers, params), 0) << name << minClearance;
    }
  }
}

}  // namespace
