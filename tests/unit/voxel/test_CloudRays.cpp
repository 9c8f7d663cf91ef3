#include <gtest/gtest.h>
#include <mrpt_mapconv/observation/TrajectoryFile.h>
#include <mrpt_mapconv/voxel/CloudRays.h>

#include <cmath>
#include <stdexcept>

using namespace mrpt_mapconv;
using voxel::VoxelGrid;

namespace
{
/** A sensor that moves 1 m a second along x, at UTM coordinates. */
observation::PoseTrack track()
{
  observation::PoseTrack poses;
  for (int t = 0; t <= 2; ++t)
    poses.insert(observation::timeStampOf(t), {448258.5 + t, 5411929.5, 0.5, 0, 0, 0});
  return poses;
}

cloud::PointCloud cloudAt(double time)
{
  cloud::PointCloud cloud;
  cloud.origin = {448258, 5411929, 0};
  cloud.x = {1.5};
  cloud.y = {3.5};
  cloud.z = {0.5};
  cloud.time = {time};
  return cloud;
}
}  // namespace

TEST(CloudRays, APointIsSeenFromWhereTheSensorWas)
{
  VoxelGrid grid(1.0);
  const auto inserted = voxel::insertCloud(grid, cloudAt(1), track(), {}, {});
  EXPECT_EQ(inserted.points, 1u);
  for (int y = 0; y < 3; ++y) EXPECT_LT(grid.logOdds({1, y, 0}), 0) << y;
  EXPECT_GT(grid.logOdds({1, 3, 0}), 0);
  EXPECT_EQ(grid.size(), 4u);
}

TEST(CloudRays, TimesHaveAUnitAndAnOffset)
{
  VoxelGrid grid(1.0);
  observation::CloudTimes times;
  times.unit = 1e-6;
  times.offset = -4;
  EXPECT_EQ(voxel::insertCloud(grid, cloudAt(5e6), track(), times, {}).points, 1u);
  EXPECT_EQ(grid.size(), 4u);
}

TEST(CloudRays, PointsThatNobodySawAreLeftOut)
{
  VoxelGrid grid(1.0);
  auto cloud = cloudAt(1);
  for (auto* values : {&cloud.x, &cloud.y, &cloud.z}) values->push_back(values->front());
  cloud.time.push_back(7);
  const auto inserted = voxel::insertCloud(grid, cloud, track(), {}, {});
  EXPECT_EQ(inserted.points, 1u);
  EXPECT_EQ(inserted.uncovered, 1u);
  cloud.withheld = {1, 0};
  EXPECT_EQ(voxel::insertCloud(grid, cloud, track(), {}, {}).withheld, 1u);
  cloud.time.clear();
  EXPECT_THROW(voxel::insertCloud(grid, cloud, track(), {}, {}), std::invalid_argument);
}

TEST(CloudRays, TheSensorModelIsThatOfScans)
{
  const auto params = voxel::rayParamsOf({});
  EXPECT_NO_THROW(params.check());
  EXPECT_NEAR(params.minLogOdds, -2, 1e-3);
  EXPECT_NEAR(params.maxLogOdds, 3.511, 1e-3);
  EXPECT_EQ(params.probHit, 0.7);
}
