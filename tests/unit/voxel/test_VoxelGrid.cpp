#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "support/GridBytes.h"
#include "support/ThrownMessage.h"

namespace
{
using namespace mrpt_mapconv::voxel;
using mrpt_mapconv::test::bytesOf;

int bricksOf(const VoxelGrid& grid)
{
  int bricks = 0;
  grid.table().forEachSlot([&](const VoxelKey&, const VoxelGrid::Slot& slot)
                           { bricks += slot.brick ? 1 : 0; });
  return bricks;
}

VoxelGrid::Slot& slotAt(VoxelGrid& grid, const VoxelKey& voxel)
{
  return grid.table().obtain(regionKey(voxel))[brickIndex(voxel)];
}

TEST(VoxelGrid, KnowsNothingAtFirst)
{
  const VoxelGrid grid(0.1);
  EXPECT_EQ(0.1, grid.resolution());
  EXPECT_TRUE(grid.empty());
  EXPECT_EQ(0u, grid.size());
  EXPECT_EQ(0u, grid.heapBytes());
  EXPECT_FALSE(isTouched(grid.logOdds({1, 2, 3})));
}

TEST(VoxelGrid, KeepsAVoxelsLogOddsAndNoOthers)
{
  VoxelGrid grid(0.1);
  constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min(),
                         high = std::numeric_limits<std::int32_t>::max();
  const std::pair<VoxelKey, float> voxels[] = {{{0, 0, 0}, 0.5f},       {{-1, 0, 0}, -2.0f},
                                               {{0, -1, 15}, 1.0f},     {{0, 0, 16}, 3.5f},
                                               {{127, 128, -129}, 7},   {{low, low, low}, 4.0f},
                                               {{high, high, high}, 5}, {{low, high, 0}, 6.0f}};
  for (const auto& [key, logOdds] : voxels) grid.set(key, logOdds);
  for (const auto& [key, logOdds] : voxels) EXPECT_EQ(logOdds, grid.logOdds(key));
  EXPECT_EQ(std::size(voxels), grid.size());
  EXPECT_FALSE(isTouched(grid.logOdds({0, 0, 1})));
  EXPECT_FALSE(isTouched(grid.logOdds({1, 0, 0})));
}

TEST(VoxelGrid, AVoxelOfZeroIsTouched)
{
  VoxelGrid grid(0.1);
  grid.set({1, 1, 1}, 0.0f);
  EXPECT_TRUE(isTouched(grid.logOdds({1, 1, 1})));
  EXPECT_EQ(1u, grid.size());
  EXPECT_FALSE(grid.empty());
  grid.set({1, 1, 1}, kUntouched);
  EXPECT_FALSE(isTouched(grid.logOdds({1, 1, 1})));
  EXPECT_EQ(0u, grid.size());
  EXPECT_TRUE(grid.empty());
}

TEST(VoxelGrid, FillsCubesLargerAndSmallerThanABrick)
{
  for (const std::int32_t side : {1, 2, 8, 16, 32, 128, 256})
  {
    VoxelGrid grid(0.1);
    const VoxelKey low{-side, 0, side};
    grid.set({low.x - 1, 0, low.z}, 9.0f);
    grid.fillCube(low, side, 1.5f);
    const auto count = static_cast<std::size_t>(side);
    EXPECT_EQ(count * count * count + 1, grid.size()) << side;
    EXPECT_EQ(1.5f, grid.logOdds(low)) << side;
    EXPECT_EQ(1.5f, grid.logOdds({low.x + side - 1, low.y + side - 1, low.z + side - 1}));
    EXPECT_FALSE(isTouched(grid.logOdds({low.x + side, low.y, low.z})));
    EXPECT_FALSE(isTouched(grid.logOdds({low.x, low.y + side, low.z})));
    EXPECT_FALSE(isTouched(grid.logOdds({low.x, low.y, low.z + side})));
    EXPECT_EQ(9.0f, grid.logOdds({low.x - 1, 0, low.z}));
  }
}

TEST(VoxelGrid, ACubeTakesThePlaceOfABrick)
{
  VoxelGrid grid(0.1);
  grid.set({3, 3, 3}, 1.0f);
  EXPECT_EQ(1, bricksOf(grid));
  grid.fillCube({0, 0, 0}, 16, -2.0f);
  EXPECT_EQ(0, bricksOf(grid));
  EXPECT_EQ(-2.0f, grid.logOdds({3, 3, 3}));
  grid.set({3, 3, 3}, 1.0f);
  EXPECT_EQ(-2.0f, grid.logOdds({3, 3, 4}));
  EXPECT_EQ(1.0f, grid.logOdds({3, 3, 3}));
  EXPECT_EQ(4096u, grid.size());
}

TEST(VoxelGrid, ABrickCollapsesIfAllOfItIsEqual)
{
  VoxelGrid grid(0.1);
  grid.fillCube({0, 0, 0}, 16, 1.0f);
  auto& slot = slotAt(grid, {0, 0, 0});
  for (const VoxelKey& odd : {VoxelKey{0, 0, 0}, VoxelKey{15, 15, 15}, VoxelKey{7, 8, 9}})
  {
    grid.set(odd, 2.0f);
    slot.collapse();
    EXPECT_TRUE(slot.brick);
    EXPECT_EQ(2.0f, grid.logOdds(odd));
    grid.set(odd, 1.0f);
    slot.collapse();
    EXPECT_FALSE(slot.brick);
    EXPECT_EQ(1.0f, grid.logOdds(odd));
  }
  EXPECT_EQ(4096u, grid.size());
}

TEST(VoxelGrid, ABrickOfZerosAndUnknownVoxelsDoesNotCollapse)
{
  VoxelGrid grid(0.1);
  grid.fillCube({0, 0, 0}, 16, 0.0f);
  grid.set({5, 5, 5}, kUntouched);
  slotAt(grid, {0, 0, 0}).collapse();
  EXPECT_EQ(1, bricksOf(grid));
  EXPECT_EQ(4095u, grid.size());
}

TEST(VoxelGrid, SettingWhatIsThereKeepsABrickCollapsed)
{
  VoxelGrid grid(0.1);
  grid.fillCube({0, 0, 0}, 16, 1.0f);
  grid.set({5, 5, 5}, 1.0f);
  grid.set({20, 5, 5}, kUntouched);
  EXPECT_EQ(0, bricksOf(grid));
}

TEST(VoxelGrid, ACopyIsEqualAndApart)
{
  VoxelGrid grid(0.1);
  grid.setOccupiedFrom(0.25f);
  grid.set({-1, 2, 300}, 1.0f);
  grid.fillCube({16, 16, 16}, 16, -1.0f);
  VoxelGrid copy(grid), assigned(3.0);
  assigned.set({9, 9, 9}, 1.0f);
  assigned = grid;
  EXPECT_TRUE(bytesOf(grid) == bytesOf(copy));
  EXPECT_TRUE(bytesOf(grid) == bytesOf(assigned));
  EXPECT_EQ(grid.heapBytes(), copy.heapBytes());
  copy.set({-1, 2, 300}, 2.0f);
  EXPECT_EQ(1.0f, grid.logOdds({-1, 2, 300}));
  const std::string before = bytesOf(assigned);
  const VoxelGrid moved(std::move(assigned));
  EXPECT_TRUE(before == bytesOf(moved));
}

TEST(VoxelGrid, ClearingLeavesResolutionAndOccupancy)
{
  VoxelGrid grid(0.1);
  grid.setOccupiedFrom(0.25f);
  grid.set({1, 1, 1}, 1.0f);
  grid.clear();
  EXPECT_TRUE(grid.empty());
  EXPECT_EQ(0u, grid.heapBytes());
  EXPECT_EQ(0.1, grid.resolution());
  EXPECT_EQ(0.25f, grid.occupiedFrom());
}

TEST(VoxelGrid, HeapBytesAreThoseOfBricksAndRegions)
{
  VoxelGrid grid(0.1);
  grid.set({0, 0, 0}, 1.0f);
  const std::size_t one = grid.heapBytes();
  EXPECT_GE(one, 4096 * sizeof(float) + 512 * (sizeof(float) + sizeof(void*)));
  grid.set({1, 0, 0}, 1.0f);
  EXPECT_EQ(one, grid.heapBytes());
  grid.set({16, 0, 0}, 1.0f);
  EXPECT_EQ(one + 4096 * sizeof(float), grid.heapBytes());
  grid.set({128, 0, 0}, 1.0f);
  EXPECT_EQ(2 * one + 4096 * sizeof(float), grid.heapBytes());
  grid.fillCube({128, 0, 0}, 128, 1.0f);
  EXPECT_EQ(2 * one, grid.heapBytes());
}

TEST(VoxelGrid, ResolutionsThatAreNoneAreErrors)
{
  VoxelGrid grid(0.1);
  for (const double bad : {0.0, -0.1, 1e-5, 1001.0, std::nan(""), double(INFINITY)})
  {
    SCOPED_TRACE(bad);
    const auto message =
        mrpt_mapconv::test::thrownMessage<std::invalid_argument>([&] { VoxelGrid{bad}; });
    EXPECT_NE(std::string::npos, message.find("resolution = ")) << message;
    EXPECT_THROW(grid.setResolution(bad), std::invalid_argument);
    EXPECT_EQ(0.1, grid.resolution());
  }
}
}  // namespace
