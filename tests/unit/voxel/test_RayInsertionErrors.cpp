// What insertRays() refuses, and that the grid is then as it was, byte for byte.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/GridBytes.h"
#include "support/ThrownMessage.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::voxel;

/** A grid in which something is known. */
VoxelGrid someGrid(double resolution = 1)
{
  VoxelGrid grid(resolution);
  grid.set({1, 2, 3}, 0.5f);
  grid.fillCube({16, 0, 0}, 16, -2.0f);
  return grid;
}

/** What a refused insertion says; the grid must be as it was. */
template <class Exception>
std::string refusal(VoxelGrid grid, const std::vector<Ray>& rays, const RayParams& params = {},
                    int threads = 2)
{
  const std::string before = test::bytesOf(grid);
  const std::size_t heap = grid.heapBytes();
  const auto message =
      test::thrownMessage<Exception>([&] { insertRays(grid, rays, params, threads); });
  EXPECT_TRUE(before == test::bytesOf(grid));
  EXPECT_EQ(heap, grid.heapBytes());
  EXPECT_EQ(std::string::npos, message.find('\n')) << message;
  return message;
}

const std::vector<Ray> kShortRay{{{0.5, 0.5, 0.5}, {3.5, 0.5, 0.5}}};

TEST(RayInsertionErrors, ParametersThatAreNotValid)
{
  struct Case
  {
    double RayParams::*field;
    double value;
    std::string name, text;
  };
  const double nan = std::nan("");
  const std::vector<Case> cases{{&RayParams::probHit, 0.45, "probHit", "0.45"},
                                {&RayParams::probHit, 1, "probHit", "1"},
                                {&RayParams::probHit, nan, "probHit", "nan"},
                                {&RayParams::probMiss, 0, "probMiss", "0"},
                                {&RayParams::probMiss, 0.5, "probMiss", "0.5"},
                                {&RayParams::probMiss, nan, "probMiss", "nan"},
                                {&RayParams::minLogOdds, 0.25, "minLogOdds", "0.25"},
                                {&RayParams::minLogOdds, -INFINITY, "minLogOdds", "-inf"},
                                {&RayParams::minLogOdds, nan, "minLogOdds", "nan"},
                                {&RayParams::maxLogOdds, -0.25, "maxLogOdds", "-0.25"},
                                {&RayParams::maxLogOdds, INFINITY, "maxLogOdds", "inf"},
                                {&RayParams::maxLogOdds, nan, "maxLogOdds", "nan"},
                                {&RayParams::maxRange, 0, "maxRange", "0"},
                                {&RayParams::maxRange, -2, "maxRange", "-2"},
                                {&RayParams::maxRange, INFINITY, "maxRange", "inf"},
                                {&RayParams::maxRange, nan, "maxRange", "nan"}};
  for (const auto& [field, value, name, text] : cases)
  {
    RayParams params;
    params.*field = value;
    test::expectNames(refusal<std::invalid_argument>(someGrid(), kShortRay, params), name, text);
  }
}

TEST(RayInsertionErrors, LimitsThatExcludeEachOther)
{
  RayParams params;
  params.minLogOdds = params.maxLogOdds = 0;
  const auto message = refusal<std::invalid_argument>(someGrid(), kShortRay, params);
  test::expectNames(message, "maxLogOdds", "0");
  EXPECT_NE(std::string::npos, message.find("above minLogOdds")) << message;
}

TEST(RayInsertionErrors, MemoryOfNothing)
{
  RayParams params;
  for (const std::int32_t bad : {0, -5})
  {
    params.maxMemory = bad;
    test::expectNames(refusal<std::invalid_argument>(someGrid(), kShortRay, params), "maxMemory",
                      std::to_string(bad));
  }
}

TEST(RayInsertionErrors, RaysBeyondTheKeys)
{
  // such a ray is the last of many, so those before must not be in the map
  const std::vector<Ray> rays{kShortRay[0], kShortRay[0], {{0, 0, 0}, {0, 0, 2.5e6}}};
  const auto message = refusal<std::out_of_range>(someGrid(0.001), rays);
  EXPECT_NE(std::string::npos, message.find("ray 3 of 3: 2.5e+06 m")) << message;
  EXPECT_NE(std::string::npos, message.find("2^31 is the limit")) << message;
  for (const double far : {2147483648.0, -2147483648.01, 1e300, -1e300})
  {
    refusal<std::out_of_range>(someGrid(), {{{0, 0, 0}, {0, far, 0}}});
    refusal<std::out_of_range>(someGrid(), {{{far, 0, 0}, {0, 0, 0}}});
  }
}

TEST(RayInsertionErrors, TheLastKeysAreGood)
{
  VoxelGrid grid(1);
  constexpr double most = 2147483648.0;
  insertRays(grid, {{{most - 0.25, 0, 0}, {most - 0.25, 0, 0}}, {{0, -most, 0}, {0, -most, 0}}});
  EXPECT_TRUE(isTouched(grid.logOdds({2147483647, 0, 0})));
  EXPECT_TRUE(isTouched(grid.logOdds({0, -2147483647 - 1, 0})));
}

TEST(RayInsertionErrors, ARayThatIsCutWithinTheKeysIsGood)
{
  RayParams params;
  params.maxRange = 2;
  for (const double far : {1e12, 1e200, -1e308})
  {
    VoxelGrid grid(1);
    insertRays(grid, {{{0.5, 0.5, 0.5}, {far, 0.5, 0.5}}}, params);
    EXPECT_EQ(3u, grid.size()) << far;
  }
}

TEST(RayInsertionErrors, KeysBeyondAnOctrees)
{
  VoxelGrid grid(1);
  insertRays(grid, {{{32767.5, 0, 0}, {32767.5, 0, 0}}});
  EXPECT_NO_THROW(toOcTree(grid));
  insertRays(grid, {{{32768.5, 0, 0}, {32768.5, 0, 0}}});
  const auto message = test::thrownMessage<std::runtime_error>([&] { toOcTree(grid); });
  EXPECT_NE(std::string::npos, message.find("32768")) << message;
}

/** From corner to corner of a cube of bricks: few of them are on the way. */
Ray diagonal(int bricks)
{
  const double end = 16.0 * bricks - 0.5;
  return {{0.5, 0.5, 0.5}, {end, end, end}};
}

TEST(RayInsertionErrors, AMapOfMoreThanMaxMemory)
{
  RayParams params;
  params.maxMemory = 1;
  const auto message =
      refusal<std::runtime_error>(someGrid(), {kShortRay[0], diagonal(40)}, params);
  // one brick and one region are there; 118 bricks, 4 · 4 regions are on the way
  EXPECT_NE(std::string::npos, message.find("maxMemory = 1 MB")) << message;
  EXPECT_NE(std::string::npos, message.find("of 0.0 MB would need at least 2.0 MB more"))
      << message;
}

TEST(RayInsertionErrors, OfARayAcrossAllKeysNoMoreIsCountedThanTellsSomething)
{
  RayParams params;
  params.maxMemory = 1;
  const auto message =
      refusal<std::runtime_error>(someGrid(), {{{-2e9, -1e9, 0}, {2e9, 1e9, 1e8}}}, params);
  EXPECT_NE(std::string::npos, message.find("at least 4001.0 MB more")) << message;
}

TEST(RayInsertionErrors, WhatFitsOnlyByExactCountIsInserted)
{
  RayParams params;
  params.maxMemory = 3;
  VoxelGrid grid(1);
  insertRays(grid, std::vector<Ray>(3, diagonal(40)), params);
  EXPECT_EQ(3u * (40 * 16 - 1) + 1, grid.size());
  EXPECT_LE(grid.heapBytes(), 3'000'000u);
}

TEST(RayInsertionErrors, BricksThatAreThereNeedNoMore)
{
  RayParams params;
  params.maxMemory = 3;
  VoxelGrid grid(1);
  for (int i = 0; i < 3; ++i) insertRays(grid, {diagonal(40)}, params);
  EXPECT_FLOAT_EQ(3 * -0.200670695f, grid.logOdds({0, 0, 0}));
}

/** Bricks as free as can be, which take half of a megabyte. */
VoxelGrid freeGrid()
{
  VoxelGrid grid(1);
  grid.fillCube({0, 0, 0}, 512, -2.0f);
  return grid;
}

TEST(RayInsertionErrors, MissesOfBricksThatAreAsFreeAsCanBeNeedNoMore)
{
  RayParams params;
  params.maxMemory = 1;
  VoxelGrid grid = freeGrid();
  const std::string before = test::bytesOf(grid);
  const Ray cleared{{0.5, 0.5, 0.5}, {511.5, 511.5, 511.5}, RayEnd::Clear};
  insertRays(grid, std::vector<Ray>(3, cleared), params);
  EXPECT_TRUE(before == test::bytesOf(grid));
}

TEST(RayInsertionErrors, HitsInBricksThatAreAsFreeAsCanBeNeedABrickEach)
{
  RayParams params;
  params.maxMemory = 1;
  std::vector<Ray> rays;
  for (int brick = 0; brick < 32; ++brick)
    for (const double z : {0.5, 16.5}) rays.push_back({{0, 0, 0}, {16.0 * brick, 0, z}});
  const auto message = refusal<std::runtime_error>(freeGrid(), rays, params);
  EXPECT_NE(std::string::npos, message.find("of 0.5 MB would need at least 1.0 MB more"))
      << message;
}
}  // namespace
