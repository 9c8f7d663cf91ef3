#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "CloudBytes.h"
#include "support/Gzip.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;
using mrpt::math::TPoint3D;

namespace
{
/** Far away, with all attributes. */
PointCloud farCloud()
{
  PointCloud cloud;
  cloud.origin = {600000, 5000000, 400};
  cloud.x = {0.25, 100.125, -3};
  cloud.y = {0.5, -7.375, 2000};
  cloud.z = {0.001, 12.5, -0.75};
  cloud.time = {1234567.125, 1234567.25, 1234568};
  cloud.intensity = {0, 7, 65535};
  cloud.returnNumber = {1, 2, 3};
  cloud.numberOfReturns = {3, 3, 3};
  cloud.classification = {0, 2, 200};
  cloud.withheld = {0, 1, 0};
  return cloud;
}

PointCloud bare()
{
  PointCloud cloud;
  cloud.x = {1, 2};
  cloud.y = {3, 4};
  cloud.z = {5, 6.5};
  return cloud;
}

PointCloud written(const PointCloud& cloud, const std::string& name, const TPoint3D& origin)
{
  const TempDir dir;
  writeCloudFile(dir.path(name), cloud);
  EXPECT_EQ(1U, dir.entries());
  return readCloudFile(dir.path(name), {origin, ""});
}

void expectSamePoints(const PointCloud& a, const PointCloud& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_NEAR(a.x[i], b.x[i], 1e-8);
    EXPECT_NEAR(a.y[i], b.y[i], 1e-8);
    EXPECT_NEAR(a.z[i], b.z[i], 1e-8);
  }
}

void expectSameAttributes(const PointCloud& a, const PointCloud& b)
{
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.intensity, b.intensity);
  EXPECT_EQ(a.returnNumber, b.returnNumber);
  EXPECT_EQ(a.numberOfReturns, b.numberOfReturns);
  EXPECT_EQ(a.classification, b.classification);
  EXPECT_EQ(a.withheld, b.withheld);
}
}  // namespace

TEST(CloudFile, FormatsWithAllAttributesGiveBackWhatWasWritten)
{
  const PointCloud cloud = farCloud();
  for (const std::string name : {"a.las", "a.ply", "a.pcd", "a.csv", "a.xyz", "a.txt"})
  {
    SCOPED_TRACE(name);
    const PointCloud read = written(cloud, name, cloud.origin);
    expectSamePoints(cloud, read);
    expectSameAttributes(cloud, read);
  }
}

TEST(CloudFile, AttributesThatACloudLacksAreNotMadeUp)
{
  for (const std::string name : {"a.ply", "a.pcd", "a.csv", "a.xyz"})
  {
    const PointCloud read = written(bare(), name, {0, 0, 0});
    expectSamePoints(bare(), read);
    expectSameAttributes(bare(), read);
  }
}

TEST(CloudFile, FloatsAndDoublesKeepTheirLastBitInTexts)
{
  PointCloud cloud = bare();
  cloud.intensity = {0.1F, std::numeric_limits<float>::min()};
  cloud.x = {0.1, 1.0 / 3};
  const PointCloud read = written(cloud, "a.csv", {0, 0, 0});
  EXPECT_EQ(cloud.x, read.x);
  EXPECT_EQ(cloud.intensity, read.intensity);
}

TEST(CloudFile, FarCloudsGetAnOriginOfWholeMetres)
{
  const std::string near = "9999 -9999.5 3\n", far = "3.5 2.25 -10001.5\n";
  EXPECT_EQ(TPoint3D(0, 0, 0), readBytesAs("a.xyz", near).origin);
  const PointCloud cloud = readBytesAs("a.xyz", near + far);
  EXPECT_EQ(TPoint3D(9999, -10000, 0), cloud.origin);
  EXPECT_EQ(0.5, cloud.y[0]);
  EXPECT_EQ(-10001.5, cloud.z[1]);
  const PointCloud given = readBytesAs("a.xyz", near, {TPoint3D(1, 2, 3), ""});
  EXPECT_EQ(TPoint3D(1, 2, 3), given.origin);
  EXPECT_EQ(9998, given.x[0]);
}

TEST(CloudFile, GzippedCloudsAreRead)
{
  const TempDir dir;
  for (const std::string name : {"a.las", "a.ply", "a.pcd", "a.csv"})
  {
    writeCloudFile(dir.path(name), farCloud());
    writeGzipped(dir.path(name + ".gz"), readBytes(dir.path(name)));
    EXPECT_EQ(3U, readCloudFile(dir.path(name + ".gz")).size()) << name;
    const std::string whole = readBytes(dir.path(name + ".gz"));
    std::ofstream(dir.path("cut_" + name), std::ios::binary) << whole.substr(0, whole.size() - 12);
    EXPECT_TRUE(contains(messageOf([&] { readCloudFile(dir.path("cut_" + name)); }), "truncated"));
  }
}

TEST(CloudFile, IntensitiesBeyondAFloatAreTheLargestOne)
{
  const auto read =
      readBytesAs("a.ply",
                  "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
                  "property double x\nproperty double y\nproperty double z\n"
                  "property double intensity\nend_header\n" +
                      bytesOf(0.) + bytesOf(0.) + bytesOf(0.) + bytesOf(1e300) + bytesOf(1.) +
                      bytesOf(0.) + bytesOf(0.) + bytesOf(-1e300) + bytesOf(2.) + bytesOf(0.) +
                      bytesOf(0.) + bytesOf(std::nan("")));
  constexpr float kMost = std::numeric_limits<float>::max();
  ASSERT_EQ(3U, read.size());
  EXPECT_EQ(kMost, read.intensity[0]);
  EXPECT_EQ(-kMost, read.intensity[1]);
  EXPECT_TRUE(std::isnan(read.intensity[2]));
}

TEST(CloudFile, AnIntensityThatIsNaNStaysOneExceptInALas)
{
  PointCloud cloud = bare();
  cloud.intensity = {7, std::numeric_limits<float>::quiet_NaN()};
  for (const std::string name : {"a.ply", "a.pcd", "a.csv", "a.bin", "a.las"})
  {
    const auto read = written(cloud, name, {0, 0, 0});
    ASSERT_EQ(2U, read.intensity.size()) << name;
    EXPECT_EQ(7, read.intensity[0]) << name;
    if (name == "a.las")
      EXPECT_EQ(0, read.intensity[1]);
    else
      EXPECT_TRUE(std::isnan(read.intensity[1])) << name;
  }
}

TEST(CloudFile, FilesOfOtherKindsAreNamedWithARemedy)
{
  expectRefused("a.e57", "ASTM-E57" + std::string(100, '\0'), "pye57");
  expectRefused("a.pcd", "1 2 3\n", "by its name a point cloud of PCL (.pcd), but does not begin");
  expectRefused("a", "what is this\n", "is no file of points that is read here");
  expectRefused("a.txt", "\x89PNG\r\n\x1a\n", "a picture (.png)");
}

TEST(CloudFile, OtherEndingsAreRefusedBeforeAnythingIsWritten)
{
  const TempDir dir;
  for (const std::string name : {"a.laz", "a", "a.las.gz"})
    EXPECT_TRUE(contains(messageOf([&] { writeCloudFile(dir.path(name), bare()); }),
                         "is written as .las, .ply"));
  EXPECT_EQ(0U, dir.entries());
}

TEST(CloudFile, AFullDiskIsNamedAndNothingIsLeft)
{
  const TinyDisk disk(64);
  if (!disk.mounted()) GTEST_SKIP() << "cannot mount a disk";
  PointCloud cloud;
  cloud.x = cloud.y = cloud.z = std::vector<double>(20000, 1.5);
  for (const std::string name : {"a.las", "a.ply", "a.pcd", "a.csv", "a.bin"})
  {
    const auto message = messageOf([&] { writeCloudFile(disk.path(name), cloud); });
    EXPECT_TRUE(contains(message, name)) << message;
    EXPECT_TRUE(contains(message, "No space left")) << message;
    EXPECT_FALSE(std::filesystem::exists(disk.path(name)));
  }
}
