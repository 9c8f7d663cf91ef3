#include <gtest/gtest.h>

#include "CloudBytes.h"

using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

namespace
{
PointCloud onePoint()
{
  PointCloud cloud;
  cloud.x = {1.2345};
  cloud.y = {-2};
  cloud.z = {3};
  return cloud;
}

std::string bytesOfLas(const PointCloud& cloud)
{
  const TempDir dir;
  writeCloudFile(dir.path("a.las"), cloud);
  return readBytes(dir.path("a.las"));
}

PointCloud written(const PointCloud& cloud) { return readBytesAs("a.las", bytesOfLas(cloud)); }
}  // namespace

TEST(LasWriter, WritesWholeMillimetres)
{
  const PointCloud cloud = written(onePoint());
  EXPECT_NEAR(1.235, cloud.x[0], 1e-12);
  EXPECT_EQ(-2, cloud.y[0]);
  EXPECT_EQ("LAS 1.4, point format 0", cloud.format);
  EXPECT_EQ(1, cloud.returnNumber[0]);
  EXPECT_EQ(1, cloud.numberOfReturns[0]);
}

TEST(LasWriter, WideCloudsGetALargerScaleRatherThanWrongNumbers)
{
  PointCloud cloud = onePoint();
  cloud.x = {5e6};
  EXPECT_NEAR(5e6, written(cloud).origin.x + written(cloud).x[0], 0.01);
}

TEST(LasWriter, ThePointFormatHasRoomForWhatTheCloudHas)
{
  PointCloud cloud = onePoint();
  cloud.classification = {31};
  EXPECT_EQ("LAS 1.4, point format 0", written(cloud).format);
  cloud.classification = {32};
  EXPECT_EQ("LAS 1.4, point format 6", written(cloud).format);
  cloud.classification.clear();
  cloud.returnNumber = {8};
  EXPECT_EQ(8, written(cloud).returnNumber[0]);
  cloud.returnNumber = {20};
  EXPECT_EQ(15, written(cloud).returnNumber[0]);
  cloud.returnNumber.clear();
  cloud.time = {12.5};
  EXPECT_EQ(12.5, written(cloud).time[0]);
}

TEST(LasWriter, IntensitiesThatAreNoWholeNumbersAreLeftOut)
{
  PointCloud cloud = onePoint();
  cloud.intensity = {300};
  EXPECT_EQ(300, written(cloud).intensity[0]);
  for (const float none : {0.5F, -1.F, 65536.F})
  {
    cloud.intensity = {none};
    EXPECT_EQ(0, written(cloud).intensity[0]);
  }
}

TEST(LasWriter, KeepsTheCoordinateSystem)
{
  PointCloud cloud = onePoint();
  for (const bool hasTime : {false, true})
    for (const char* system : {"EPSG:32632", "PROJCS[\"somewhere\",GEOGCS[]]", "EPSG:99999", ""})
    {
      cloud.time.assign(hasTime ? 1 : 0, 1.0);
      cloud.coordinateSystem = system;
      EXPECT_EQ(system, written(cloud).coordinateSystem);
    }
}

// The specification's table 3, read by hand.
TEST(LasWriter, TheHeaderCountsPointsByReturnAndSaysTheirLimits)
{
  PointCloud cloud = onePoint();
  cloud.origin = {100, 0, 0};
  cloud.x = {1, 2, 3};
  cloud.y = {4, 5, 6};
  cloud.z = {7, -8, 9};
  cloud.returnNumber = {1, 2, 2};
  const auto at = [&](auto number, std::size_t offset)
  {
    const std::string bytes = bytesOfLas(cloud);
    std::memcpy(&number, &bytes.at(offset), sizeof number);
    return number;
  };
  EXPECT_EQ(3U, at(std::uint32_t(), 107));
  EXPECT_EQ(1U, at(std::uint32_t(), 111));
  EXPECT_EQ(2U, at(std::uint32_t(), 115));
  EXPECT_EQ(3U, at(std::uint64_t(), 247));
  EXPECT_EQ(2U, at(std::uint64_t(), 263));
  EXPECT_EQ(103, at(double(), 179));
  EXPECT_EQ(101, at(double(), 187));
  EXPECT_EQ(9, at(double(), 211));
  EXPECT_EQ(-8, at(double(), 219));
}

TEST(LasWriter, TimesKeepWhatTheyCountFrom)
{
  PointCloud cloud = onePoint();
  cloud.time.clear();
  EXPECT_EQ(TimeEpoch::Unknown, written(cloud).timeEpoch) << "it has no times";
  cloud.time.assign(cloud.size(), 5);
  EXPECT_EQ(TimeEpoch::GpsWeek, written(cloud).timeEpoch) << "which is what a bit of 0 says";
  cloud.timeEpoch = TimeEpoch::AdjustedGps;
  cloud.coordinateSystem = "EPSG:32632";
  const auto read = written(cloud);
  EXPECT_EQ(TimeEpoch::AdjustedGps, read.timeEpoch);
  EXPECT_EQ("EPSG:32632", read.coordinateSystem);
}
