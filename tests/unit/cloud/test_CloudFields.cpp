#include <gtest/gtest.h>
#include <mrpt_mapconv/cloud/CloudFields.h>

#include <limits>

using namespace mrpt_mapconv::cloud;

TEST(CloudFields, NamesOfOtherProgramsAreKnown)
{
  const std::pair<const char*, Field> names[] = {
      {"x", Field::X},
      {"Y", Field::Y},
      {"Z [m]", Field::Z},
      {"GpsTime", Field::Time},
      {"gps_time", Field::Time},
      {"scalar_GPS_Time", Field::Time},
      {"Intensity", Field::Intensity},
      {"ReturnNumber", Field::ReturnNumber},
      {"scalar_Number_Of_Returns", Field::NumberOfReturns},
      {"Classification", Field::Classification},
      {"withheld", Field::Withheld}};
  for (const auto& [name, field] : names) EXPECT_EQ(field, fieldNamed(name)) << name;
  for (const char* name : {"", "_", "nx", "red", "label", "xyz"})
    EXPECT_FALSE(fieldNamed(name)) << name;
}

TEST(CloudFields, EachFieldsOwnNameIsKnown)
{
  PointCloud cloud;
  std::size_t count = 0;
  visitFields(cloud,
              [&](Field field, const char* name, const auto&)
              {
                EXPECT_EQ(count++, indexOf(field));
                EXPECT_EQ(field, fieldNamed(name)) << name;
              });
  EXPECT_EQ(kFields, count);
}

TEST(CloudFields, RangesAreOfFiniteValuesInTheFilesCoordinates)
{
  PointCloud cloud;
  cloud.origin = {100, 0, 0};
  cloud.x = {-1, 2};
  cloud.time = {std::numeric_limits<double>::quiet_NaN(), 5};
  EXPECT_EQ(99, rangeOf(cloud, Field::X)->min);
  EXPECT_EQ(102, rangeOf(cloud, Field::X)->max);
  EXPECT_EQ(5, rangeOf(cloud, Field::Time)->min);
  EXPECT_FALSE(rangeOf(cloud, Field::Intensity));
}
