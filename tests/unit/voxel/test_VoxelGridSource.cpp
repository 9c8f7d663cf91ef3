// Reading bricks block by block, against asking the grid voxel by voxel.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/VoxelGridSource.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "../../support/KnownVoxels.h"
#include "BlockColumns.h"

namespace
{
using namespace mrpt_mapconv;
using oracle::Voxel;
using test::everyColumn;
using test::stateIn;
using voxel::ColumnBlock;
using voxel::ColumnMask;
using voxel::kBlockSide;
using voxel::VoxelGrid;
using voxel::VoxelGridSource;
using voxel::VoxelKey;

constexpr float kFree = -0.4f, kOccupied = 0.85f;

Voxel ask(const VoxelGrid& grid, const VoxelKey& key)
{
  const float logOdds = grid.logOdds(key);
  if (!voxel::isTouched(logOdds)) return Voxel::Unknown;
  return logOdds >= grid.occupiedFrom() ? Voxel::Occupied : Voxel::Free;
}

/** The box of the known voxels, both corners included. */
struct Box
{
  VoxelKey low, high;
};
std::optional<Box> boxOf(const VoxelGrid& grid)
{
  std::optional<Box> box;
  for (const auto& [key, bits] : test::knownVoxels(grid))
  {
    if (!box) box = Box{key, key};
    box->low = {std::min(box->low.x, key.x), std::min(box->low.y, key.y),
                std::min(box->low.z, key.z)};
    box->high = {std::max(box->high.x, key.x), std::max(box->high.y, key.y),
                 std::max(box->high.z, key.z)};
  }
  return box;
}

/** Every voxel of the block's wanted columns, from some way below what is known to some above. */
void expectBlockEqualsGrid(const VoxelGrid& grid, const ColumnBlock& block, const Box& box)
{
  int wrong = 0;
  for (int y = 0; y < kBlockSide; ++y)
    for (int x = 0; x < kBlockSide; ++x)
    {
      if (!(block.wanted()[static_cast<std::size_t>(y)] >> x & 1u)) continue;
      const int kx = block.key().x * kBlockSide + x, ky = block.key().y * kBlockSide + y;
      for (int kz = box.low.z - 70; kz < box.high.z + 70 && wrong < 5; ++kz)
      {
        if (stateIn(block, x, y, kz) == ask(grid, {kx, ky, kz})) continue;
        ++wrong;
        ADD_FAILURE() << "voxel (" << kx << ", " << ky << ", " << kz << ")";
      }
    }
}

void expectBounds(const VoxelGridSource& source, const std::optional<Box>& box)
{
  const auto bounds = source.bounds();
  ASSERT_TRUE(bounds && box);
  EXPECT_EQ(bounds->xMin, box->low.x);
  EXPECT_EQ(bounds->yMin, box->low.y);
  EXPECT_EQ(bounds->xMax, box->high.x);
  EXPECT_EQ(bounds->yMax, box->high.y);
  EXPECT_EQ(source.top(), box->high.z);
}

/** bounds(), top() and counts, and every block around what is known. */
void expectSourceEqualsGrid(const VoxelGrid& grid, const ColumnMask& wanted)
{
  const VoxelGridSource source(grid);
  EXPECT_EQ(source.resolution(), grid.resolution());
  const auto box = boxOf(grid);
  expectBounds(source, box);
  EXPECT_EQ(source.VoxelSource::top(), box->high.z);
  const auto voxels = test::knownVoxels(grid);
  EXPECT_EQ(voxel::knownVoxels(source), voxels.size());
  EXPECT_EQ(voxel::hasFreeVoxel(source),
            std::any_of(voxels.begin(), voxels.end(),
                        [&grid](const auto& v) { return ask(grid, v.key) == Voxel::Free; }));
  ColumnBlock block;  // the same one again and again, as the conversion does
  for (int by = (box->low.y >> 5) - 1; by <= (box->high.y >> 5) + 1; ++by)
    for (int bx = (box->low.x >> 5) - 1; bx <= (box->high.x >> 5) + 1; ++bx)
    {
      SCOPED_TRACE("block (" + std::to_string(bx) + ", " + std::to_string(by) + ")");
      block.start({bx, by}, wanted);
      source.read(block);
      EXPECT_EQ(block.zMin() % 32, 0);
      expectBlockEqualsGrid(grid, block, *box);
    }
}

TEST(VoxelGridSource, AnEmptyGridHasNoBoundsAndNoVoxels)
{
  VoxelGrid grid(0.1);
  for (const bool wasTouched : {false, true})
  {
    if (wasTouched)
    {
      grid.set({3, 4, 5}, kFree);
      grid.set({3, 4, 5}, voxel::kUntouched);
    }
    const VoxelGridSource source(grid);
    EXPECT_FALSE(source.bounds());
    EXPECT_FALSE(source.top());
    EXPECT_FALSE(voxel::hasFreeVoxel(source));
    EXPECT_EQ(voxel::knownVoxels(source), 0u);
    ColumnBlock block;
    block.start({0, 0}, everyColumn());
    source.read(block);
    for (int kz = -100; kz < 100; ++kz) EXPECT_EQ(stateIn(block, 3, 4, kz), Voxel::Unknown);
  }
}

TEST(VoxelGridSource, OneVoxel)
{
  for (const int key : {0, -1, 15, 16, -16, -17, 31, 32, -32, -33, 127, 128, -128, -129, 32767,
                        -32768, 40000, -1000000})
    for (const float logOdds : {kFree, kOccupied})
    {
      SCOPED_TRACE("key " + std::to_string(key));
      VoxelGrid grid(0.1);
      grid.set({key, key, key}, logOdds);
      expectSourceEqualsGrid(grid, everyColumn());
    }
}

TEST(VoxelGridSource, BricksThatAreOneValue)
{
  for (int side = 1; side <= 64; side *= 4)
  {
    SCOPED_TRACE("side " + std::to_string(side));
    VoxelGrid grid(0.1);
    grid.fillCube({-side, 0, -side}, side, kFree);
    grid.fillCube({side, -side, 0}, side, kOccupied);
    if (side > 16) grid.set({side + 5, -side + 17, 9}, kFree);  // in the middle of one of them
    expectSourceEqualsGrid(grid, everyColumn());
  }
}

TEST(VoxelGridSource, AThresholdDecidesWhatIsOccupiedAndZeroIsKnown)
{
  VoxelGrid grid(0.1);
  grid.fillCube({16, 0, 0}, 16, 0.0f);
  for (int i = 0; i < 10; ++i) grid.set({i, 1, 2}, 0.1f * static_cast<float>(i - 5));
  for (const float threshold : {0.0f, -0.2f, 0.3f, -9.0f, 9.0f})
  {
    SCOPED_TRACE(threshold);
    grid.setOccupiedFrom(threshold);
    expectSourceEqualsGrid(grid, everyColumn());
  }
}

TEST(VoxelGridSource, RandomVoxelsAndRandomColumns)
{
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 rng(seed);
    const auto pick = [&](int low, int high)
    { return low + static_cast<int>(rng() % static_cast<unsigned>(high - low + 1)); };
    VoxelGrid grid(0.1);
    grid.setOccupiedFrom(seed % 4 == 0 ? -0.01f : 0.0f);
    const int x = pick(-180, 180), y = pick(-180, 180), z = pick(-300, 300), height = pick(1, 200);
    for (int i = 0; i < 3000; ++i)
      grid.set({x + pick(0, 40), y + pick(0, 40), z + pick(0, height)},
               pick(0, 2) == 0 ? 0.0f : -0.01f * static_cast<float>(pick(1, 2)));
    if (seed % 2 == 0) grid.fillCube({x & -16, y & -16, z & -16}, 16, kOccupied);
    ColumnMask wanted{};
    for (std::uint32_t& row : wanted)
      row = static_cast<std::uint32_t>(rng()) & static_cast<std::uint32_t>(rng());
    expectSourceEqualsGrid(grid, seed % 3 == 0 ? everyColumn() : wanted);
  }
}

TEST(VoxelGridSource, ASingleWantedColumn)
{
  VoxelGrid grid(0.1);
  grid.fillCube({0, 0, 0}, 32, kFree);
  grid.set({17, 9, 5}, kOccupied);
  for (const int x : {0, 15, 16, 17, 31})
  {
    ColumnMask wanted{};
    wanted[9] = 1u << x;
    expectSourceEqualsGrid(grid, wanted);
  }
}

/** Each voxel of a few can be the outermost one of a brick that is not. */
TEST(VoxelGridSource, BoundsAndTopOfAFewVoxels)
{
  for (unsigned seed = 1; seed <= 500; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 rng(seed);
    VoxelGrid grid(0.1);
    const auto any = [&rng] { return static_cast<int>(rng() % 300) - 150; };
    for (int i = 0; i < 12; ++i) grid.set({any(), any(), any()}, kFree);
    expectBounds(VoxelGridSource(grid), boxOf(grid));
  }
}

TEST(ColumnBlock, MarkColumnMarksFromItsLowestBitUp)
{
  for (const int zBegin : {-64, -32, 0, 96})
    for (int z = zBegin; z < zBegin + 96; z += 16)
    {
      const bool isWhole = z % 32 == 0;  // bits must not reach across a multiple of 32
      const std::uint32_t free = isWhole ? 0x80000005u : 0x8005u, occupied = 0x0010u;
      ColumnBlock block;
      block.start({0, 0}, everyColumn());
      block.setHeight(zBegin, zBegin + 96);
      block.markColumn(31, 7, z, free, occupied);
      for (int kz = zBegin - 5; kz < zBegin + 101; ++kz)
      {
        const int bit = kz - z;
        const bool inside = bit >= 0 && bit < 32;
        const Voxel expected = inside && (free >> bit & 1u)       ? Voxel::Free
                               : inside && (occupied >> bit & 1u) ? Voxel::Occupied
                                                                  : Voxel::Unknown;
        EXPECT_EQ(stateIn(block, 31, 7, kz), expected) << z << " " << kz;
        EXPECT_EQ(stateIn(block, 30, 7, kz), Voxel::Unknown);
        EXPECT_EQ(stateIn(block, 31, 8, kz), Voxel::Unknown);
      }
    }
}

TEST(ColumnBlock, MarkColumnAddsToWhatIsMarked)
{
  ColumnBlock block;
  block.start({0, 0}, everyColumn());
  block.setHeight(0, 64);
  block.markColumn(3, 4, 16, 1, 2);
  block.markColumn(3, 4, 32, 4, 8);
  block.markColumn(3, 4, 16, 16, 0);
  for (const auto& [kz, state] : std::vector<std::pair<int, Voxel>>{{16, Voxel::Free},
                                                                    {17, Voxel::Occupied},
                                                                    {18, Voxel::Unknown},
                                                                    {20, Voxel::Free},
                                                                    {34, Voxel::Free},
                                                                    {35, Voxel::Occupied}})
    EXPECT_EQ(stateIn(block, 3, 4, kz), state) << kz;
}

}  // namespace
