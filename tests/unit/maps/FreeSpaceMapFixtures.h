#pragma once

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <cstring>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::fixtures
{
/** Voxels [z, z + height) of column (x, y), all free ('f') or occupied ('#'). */
inline void column(octomap::OcTree& tree, int x, int y, int z, char state, int height)
{
  for (int i = 0; i < height; ++i)
    tree.updateNode(octomap::OcTreeKey(static_cast<octomap::key_type>(32768 + x),
                                       static_cast<octomap::key_type>(32768 + y),
                                       static_cast<octomap::key_type>(32768 + z + i)),
                    state == '#');
}

/** What a lidar 1 m above the floor of a room sees; rooms of different `which` differ. */
inline mrpt::obs::CObservationPointCloud roomScan(int which)
{
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  const double wall = 3 + 0.2 * which;
  for (int azimuth = 0; azimuth < 360; azimuth += 2)
    for (int elevation = -60; elevation <= 30; elevation += 3)
    {
      const double a = mrpt::DEG2RAD(static_cast<double>(azimuth));
      const double e = mrpt::DEG2RAD(static_cast<double>(elevation));
      const double x = std::cos(e) * std::cos(a), y = std::cos(e) * std::sin(a), z = std::sin(e);
      double range = wall / std::max({std::abs(x), std::abs(y), 1e-9});
      if (z < 0) range = std::min(range, 1.0 / -z);
      cloud->insertPoint(static_cast<float>(range * x), static_cast<float>(range * y),
                         static_cast<float>(range * z));
    }
  mrpt::obs::CObservationPointCloud scan;
  scan.pointcloud = cloud;
  return scan;
}

inline void expectSameBits(const freespace::Layers& a, const freespace::Layers& b)
{
  ASSERT_EQ(a.frame(), b.frame());
  const auto left = a.named(), right = b.named();
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    const auto &x = left[i].second->cells(), &y = right[i].second->cells();
    EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof(float)), 0) << left[i].first;
  }
}
}  // namespace mrpt_mapconv::fixtures
