#include <gtest/gtest.h>
#include <mrpt_mapconv/params/MemoryLimit.h>

#include "../mrpt_mapconv/src/cloud/CloudBuilder.h"
#include "CloudBytes.h"
#include "LasBytes.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::cloud;
using namespace mrpt_mapconv::testing;

TEST(CloudBuilder, AsManyPointsAsFitIntoMemoryAreTaken)
{
  FieldSet fields;
  for (const Field field : {Field::X, Field::Y, Field::Z, Field::Intensity, Field::Withheld})
    fields.set(indexOf(field));
  constexpr std::size_t kPoint = 3 * 8 + 4 + 1;
  CloudBuilder builder("a.csv", fields, 10 * kPoint + 5);
  builder.reserve(10, 1000, 1);
  for (int i = 0; i < 10; ++i) builder.add(Row{});
  const auto message = messageOf([&] { builder.add(Row{}); });
  EXPECT_TRUE(contains(message, "a.csv: its 11 points or more need ")) << message;
}

TEST(CloudBuilder, ACloudLargerThanMemoryIsRefusedBeforeItIsRead)
{
  constexpr std::size_t kPoint = 3 * 8 + 4 + 4;  // of format 0, in memory
  LasBytes las;
  las.minor = 4;
  las.add(0, 0, 0);
  las.count = params::memoryLimit() / kPoint + 1;
  const TempDir dir;
  std::ofstream(dir.path("huge.las"), std::ios::binary) << las.bytes();
  std::filesystem::resize_file(dir.path("huge.las"), 375 + las.count * las.size());  // sparse
  const auto message = messageOf([&] { readCloudFile(dir.path("huge.las")); });
  EXPECT_TRUE(contains(message, "huge.las: its " + std::to_string(las.count) + " points need "))
      << message;
  EXPECT_TRUE(contains(message, " GB of memory, and ")) << message;
  EXPECT_TRUE(contains(message, "thin it or cut it into tiles, e.g. pdal")) << message;
  EXPECT_FALSE(contains(message, "\n")) << message;
}
