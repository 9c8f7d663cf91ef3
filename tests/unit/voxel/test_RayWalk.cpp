#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/ThrownMessage.h"

namespace
{
using namespace mrpt_mapconv::voxel;

/** A ray between points that are given in voxels. */
GridRay ray(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  GridRay units;
  for (std::size_t i = 0; i < 3; ++i)
  {
    units.from[i] = static_cast<std::int64_t>(from[i] * kRayUnits);
    units.to[i] = static_cast<std::int64_t>(to[i] * kRayUnits);
  }
  return units;
}

/** "0 0 0, 1 0 0" */
std::string walk(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  std::string keys;
  for (const VoxelKey& v : voxelsOnRay(ray(from, to)))
    keys += (keys.empty() ? "" : ", ") + std::to_string(v.x) + ' ' + std::to_string(v.y) + ' ' +
            std::to_string(v.z);
  return keys;
}

TEST(RayWalk, VisitsTheVoxelsFromStartToEnd)
{
  EXPECT_EQ("0 0 0, 1 0 0, 2 0 0", walk({0.5, 0.5, 0.5}, {2.5, 0.5, 0.5}));
  EXPECT_EQ("0 2 0, 0 1 0, 0 0 0, 0 -1 0", walk({0.5, 2.5, 0.5}, {0.5, -0.5, 0.5}));
  EXPECT_EQ("0 0 0, 0 0 1, 1 0 1, 1 0 2", walk({0.5, 0.5, 0.5}, {1.25, 0.5, 2}));
}

TEST(RayWalk, ARayWithinAVoxelHasThatVoxelOnly)
{
  EXPECT_EQ("-1 0 3", walk({-0.5, 0.5, 3.5}, {-0.5, 0.5, 3.5}));
  EXPECT_EQ("-1 0 3", walk({-0.75, 0.25, 3}, {-0.25, 0.5, 3.5}));
  EXPECT_EQ("1 -2 0", walk({1, -2, 0}, {1, -2, 0}));
}

TEST(RayWalk, AFaceBelongsToTheVoxelAboveIt)
{
  EXPECT_EQ("0 0 0, 1 0 0", walk({0.5, 0.5, 0.5}, {1, 0.5, 0.5}));
  EXPECT_EQ("1 0 0", walk({1.5, 0.5, 0.5}, {1, 0.5, 0.5}));
  EXPECT_EQ("1 0 0, 0 0 0", walk({1, 0.5, 0.5}, {0.5, 0.5, 0.5}));
  EXPECT_EQ("0 1 -1, 1 1 -1", walk({0.5, 1, -1}, {1.5, 1, -1}));
}

TEST(RayWalk, ACornerIsCrossedInXThenYThenZ)
{
  EXPECT_EQ("0 0 0, 1 0 0, 1 1 0, 1 1 1", walk({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}));
  EXPECT_EQ("1 1 1, 0 1 1, 0 0 1, 0 0 0", walk({1.5, 1.5, 1.5}, {0.5, 0.5, 0.5}));
  EXPECT_EQ("0 0 0, 0 1 0, 0 1 1", walk({0.5, 0.5, 0.5}, {0.5, 1.5, 1.5}));
}

TEST(RayWalk, ACornerIsCrossedUpwardsFirst)
{
  EXPECT_EQ("1 0 0, 1 1 0, 0 1 0", walk({1.5, 0.5, 0.5}, {0.5, 1.5, 0.5}));
  EXPECT_EQ("1 1 0, 1 1 1, 0 1 1, 0 0 1", walk({1.5, 1.5, 0.5}, {0.5, 0.5, 1.5}));
  EXPECT_EQ("0 1 0, 1 1 0, 1 0 0", walk({0.5, 1.5, 0.5}, {1.5, 0.5, 0.5}));
}

TEST(RayWalk, ARayFromCornerToCornerEndsInTheUpperVoxels)
{
  EXPECT_EQ("0 0 0, 1 0 0, 1 1 0, 1 1 1", walk({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ("1 1 1, 0 1 1, 0 0 1, 0 0 0", walk({1, 1, 1}, {0, 0, 0}));
  EXPECT_EQ("2 0 0, 1 0 0, 1 1 0, 0 1 0, 0 2 0", walk({2, 0, 0}, {0, 2, 0}));
}

TEST(RayWalk, KeysMayBeTheLastOnes)
{
  constexpr double most = 2147483648.0;
  EXPECT_EQ("2147483647 0 0, 2147483646 0 0", walk({most - 0.5, 0, 0}, {most - 1.5, 0, 0}));
  EXPECT_EQ("0 0 -2147483647, 0 0 -2147483648", walk({0, 0, 0.5 - most + 1}, {0, 0, -most}));
}

TEST(RayWalk, OfASlabHasTheVoxelsThere)
{
  struct Ends
  {
    int& region(const VoxelKey&) { return unused; }
    static int brick(int, std::size_t) { return 0; }
    void cross(int, std::size_t) { ++crossed; }
    void end(int, std::size_t) { ++ended; }
    int unused = 0, crossed = 0, ended = 0;
  };
  const GridRay along = ray({5.5, 0.5, 0.5}, {50.5, 0.5, 0.5});
  const auto seenIn = [&](std::int64_t begin, std::int64_t end)
  {
    Ends seen;
    walkRay(along, {0, begin, end}, seen);
    return std::pair(seen.crossed, seen.ended);
  };
  EXPECT_EQ(std::pair(11, 0), seenIn(0, 16));
  EXPECT_EQ(std::pair(32, 0), seenIn(16, 48));
  EXPECT_EQ(std::pair(2, 1), seenIn(48, 64));
  EXPECT_EQ(std::pair(0, 0), seenIn(64, 80));
  EXPECT_EQ(std::pair(0, 0), seenIn(-16, 0));
}

TEST(RayWalk, OfTooManyVoxelsIsNotListed)
{
  const std::string message = mrpt_mapconv::test::thrownMessage<std::length_error>(
      [] {
        voxelsOnRay(ray({0, 0, 0}, {60e6, 50e6, 0}));
      });
  EXPECT_NE(std::string::npos, message.find("110000001 voxels")) << message;
}
}  // namespace
