// Unknown voxels taken for free ones, voxel by voxel.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/UnknownVoxels.h>

#include <random>
#include <string>

#include "../../oracle/DenseMap.h"
#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using test::HandMap;
using voxel::FilledSource;
using voxel::ReadingParams;

ReadingParams free() { return {voxel::Unknown::Free}; }

/** Column (kx, ky) from z key zBegin upwards as HandMap::column() takes it. */
std::string columnOf(const voxel::VoxelSource& source, int kx, int ky, int zBegin, int count)
{
  voxel::ColumnMask wanted{};
  wanted[static_cast<std::size_t>(ky & 31)] = 1u << (kx & 31);
  voxel::ColumnBlock block;
  block.start({kx >> 5, ky >> 5}, wanted);
  source.read(block);
  std::string column;
  for (int z = zBegin - block.zMin(); z < zBegin + count - block.zMin(); ++z)
  {
    if (z < 0 || z >= 64 * block.words())
    {
      column += '.';
      continue;
    }
    const int word = z / 64 * voxel::kBlockColumns + (ky & 31) * voxel::kBlockSide + (kx & 31);
    const bool isFree = block.freePlane()[word] >> (z % 64) & 1u;
    const bool isOccupied = block.occupiedPlane()[word] >> (z % 64) & 1u;
    EXPECT_FALSE(isFree && isOccupied);
    column += isFree ? 'f' : isOccupied ? '#' : '.';
  }
  return column;
}

TEST(UnknownVoxels, StayUnknownByDefault)
{
  HandMap map(0.1);
  map.column(0, 0, 0, ".#..#..f");
  EXPECT_EQ(".#..#..f", columnOf(FilledSource(map.source(), {}), 0, 0, 0, 8));
}

TEST(UnknownVoxels, AreFreeAboveTheLowestOccupiedOneUpToTheMapsHighestKnownOne)
{
  HandMap map(0.1);
  map.column(0, 0, -2, ".f.#..#.");
  map.column(1, 0, -2, "..ff....");
  map.column(40, -50, -2, ".......f");  // the highest: z key 5
  const FilledSource source(map.source(), free());
  EXPECT_EQ(5, *source.freeUpTo());
  EXPECT_EQ(".f.#ff#f..", columnOf(source, 0, 0, -2, 10));
  EXPECT_EQ("..ff......", columnOf(source, 1, 0, -2, 10)) << "no occupied voxel";
  EXPECT_EQ(".......f..", columnOf(source, 40, -50, -2, 10));
  EXPECT_EQ("..........", columnOf(source, 2, 0, -2, 10)) << "unknown column";
}

TEST(UnknownVoxels, AreFreeBeyondTheHeightOfTheirOwnBlock)
{
  HandMap map(0.1);
  map.occupied(0, 0, 3, 4).occupied(100, 0, 200, 201);
  const auto column = columnOf(FilledSource(map.source(), free()), 0, 0, 0, 210);
  EXPECT_EQ("...#" + std::string(197, 'f') + std::string(9, '.'), column);
}

TEST(UnknownVoxels, AreThoseOfTheSlowTwinInRandomMaps)
{
  for (unsigned seed = 1; seed <= 30; ++seed)
  {
    std::mt19937 random(seed);
    const auto pick = [&random](int low, int high)
    { return std::uniform_int_distribution<int>(low, high)(random); };
    HandMap map(0.1);
    for (int i = pick(1, 60); i > 0; --i)
    {
      const int size = pick(1, 40), z = pick(-90, 90);
      const int kx = pick(-2, 2), ky = pick(-2, 2);
      pick(0, 1) ? map.free(kx, ky, z, z + size) : map.occupied(kx, ky, z, z + pick(1, size));
    }
    const oracle::DenseMap dense = oracle::denseMap(map.tree());
    const int top = dense.z0 + dense.nz - 1;
    EXPECT_EQ(top, *map.source().top()) << "seed " << seed;
    const FilledSource source(map.source(), free());
    for (int ky = -3; ky <= 3; ++ky)
      for (int kx = -3; kx <= 3; ++kx)
      {
        std::string expected;
        for (int kz = -95; kz < 140; ++kz)
        {
          const auto state = oracle::askTree(map.tree(), kx, ky, kz);
          const bool above = expected.find('#') != std::string::npos;
          expected += state == oracle::Voxel::Occupied                       ? '#'
                      : state == oracle::Voxel::Free || (above && kz <= top) ? 'f'
                                                                             : '.';
        }
        EXPECT_EQ(expected, columnOf(source, kx, ky, -95, 235)) << "seed " << seed;
      }
  }
}

/** A source that does not know a shorter way to its highest voxel. */
class PlainSource : public voxel::VoxelSource
{
 public:
  explicit PlainSource(const voxel::VoxelSource& source) : m_source(source) {}
  double resolution() const override { return m_source.resolution(); }
  std::optional<voxel::KeyRect> bounds() const override { return m_source.bounds(); }
  void read(voxel::ColumnBlock& block) const override { m_source.read(block); }

 private:
  const voxel::VoxelSource& m_source;
};

TEST(VoxelSource, FindsItsHighestVoxelByReading)
{
  HandMap map(0.1);
  EXPECT_FALSE(PlainSource(map.source()).top());
  EXPECT_FALSE(map.source().top());
  map.occupied(-70, 3, -40, -30).free(50, 0, -300, -200);
  EXPECT_EQ(-31, *PlainSource(map.source()).top());
  EXPECT_EQ(-31, *map.source().top());
}

TEST(VoxelSource, SaysWhetherAVoxelIsFree)
{
  HandMap map(0.1);
  EXPECT_FALSE(voxel::hasFreeVoxel(map.source()));
  map.occupied(0, 0, 0, 3);
  EXPECT_FALSE(voxel::hasFreeVoxel(map.source()));
  map.free(70, 70, 9, 10);
  EXPECT_TRUE(voxel::hasFreeVoxel(map.source()));
}
}  // namespace
