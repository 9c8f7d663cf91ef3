// A map with a local window stays as large and as fast as it was, however far the robot goes.
#include <gtest/gtest.h>

#include "../support/TerrainDrive.h"

namespace
{
using namespace mrpt_mapconv;
using fixtures::TerrainDrive;

TEST(TerrainDrive, NothingGrowsOver500Metres)
{
  TerrainDrive drive(0.1);
  const auto scans = drive.drive(4000);
  ASSERT_GT(drive.map().planes().size(), 5u);
  const auto floor = drive.map().at(TerrainDrive::kLength, 0);
  ASSERT_TRUE(floor && floor->plane >= 0);
  EXPECT_NEAR(floor->height, 0, 0.01) << "its plane began 500 m ago";
  const auto early = TerrainDrive::between(scans, 50, 100),
             late = TerrainDrive::between(scans, 450, 500);
  const auto ratio = [&](std::size_t TerrainDrive::Scan::*what)
  {
    return static_cast<double>(TerrainDrive::mostOf(late, what)) /
           static_cast<double>(TerrainDrive::mostOf(early, what));
  };
  EXPECT_LE(ratio(&TerrainDrive::Scan::memory), 1.1);
  EXPECT_LE(ratio(&TerrainDrive::Scan::heap), 1.1);
  // on a shared machine; bench_terrain prints the ratio
  EXPECT_LE(TerrainDrive::medianSeconds(late), 1.5 * TerrainDrive::medianSeconds(early));
}
}  // namespace
