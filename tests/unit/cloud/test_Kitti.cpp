#include <gtest/gtest.h>

#include <limits>

#include "CloudBytes.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

namespace
{
std::string point(float x, float y, float z, float intensity)
{
  return bytesOf(x) + bytesOf(y) + bytesOf(z) + bytesOf(intensity);
}
}  // namespace

TEST(Kitti, PointsAreFourFloats)
{
  const PointCloud cloud =
      readBytesAs("0001.bin", point(1.5F, -2, 3, 0.25F) + point(4, 5, 6, 1) +
                                  point(1, std::numeric_limits<float>::infinity(), 1, 1));
  EXPECT_EQ((std::vector<double>{1.5, 4}), cloud.x);
  EXPECT_EQ((std::vector<double>{-2, 5}), cloud.y);
  EXPECT_EQ((std::vector<double>{3, 6}), cloud.z);
  EXPECT_EQ((std::vector<float>{0.25F, 1}), cloud.intensity);
  EXPECT_EQ(1U, cloud.notFinite);
  EXPECT_EQ("KITTI", cloud.format);
}

TEST(Kitti, OtherFilesOfItsNameAreRefused)
{
  expectRefused("a.bin", point(1, 2, 3, 4) + "x", "is no file of points");
  expectRefused("a.bin", point(1, 2, 3, 4) + point(1e9F, 2, 3, 4),
                "but its point 2 would be more than 10 km away");
}

TEST(Kitti, IsWrittenWithFloatsOfNearPointsOnly)
{
  const TempDir dir;
  PointCloud cloud;
  cloud.x = {1.5};
  cloud.y = {2};
  cloud.z = {3};
  writeCloudFile(dir.path("a.bin"), cloud);
  EXPECT_EQ(point(1.5F, 2, 3, 0), readBytes(dir.path("a.bin")));
  cloud.intensity = {0.5F};
  cloud.origin = {10, 0, 0};
  writeCloudFile(dir.path("a.bin"), cloud);
  EXPECT_EQ(point(11.5F, 2, 3, 0.5F), readBytes(dir.path("a.bin")));
  cloud.origin = {600000, 0, 0};
  EXPECT_TRUE(contains(messageOf([&] { writeCloudFile(dir.path("b.bin"), cloud); }), "10 km"));
  EXPECT_EQ(1U, dir.entries());
}
