#pragma once

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt_mapconv/maps/CTerrainGridMap2D.h>

#include <cmath>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::fixtures
{
/** Two levels of 1 x 2 m around (xMiddle, 0), at z = 0 for x < xMiddle and at z = 0.15 beyond, each
 * seen in a raster of 2.5 cm by a sensor at (0, 0, 1) on the robot; and a ceiling 3 m up. */
inline mrpt::obs::CObservationPointCloud stepScan(float xMiddle = 0.05f)
{
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  for (int ix = -40; ix < 40; ++ix)
    for (int iy = -40; iy < 40; ++iy)
    {
      const float x = xMiddle + 0.025f * (static_cast<float>(ix) + 0.5f);
      const float y = 0.025f * (static_cast<float>(iy) + 0.5f);
      cloud->insertPoint(x, y, ix < 0 ? -1 : -0.85f);
      if (ix % 8 == 0 && iy % 8 == 0) cloud->insertPoint(x, y, 2);
    }
  mrpt::obs::CObservationPointCloud scan;
  scan.sensorLabel = "LIDAR";
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 1);
  scan.pointcloud = cloud;
  return scan;
}

inline CTerrainGridMap2D stepMap(const terrain::TTerrainOptions& options = {})
{
  CTerrainGridMap2D map(0.1, options);
  EXPECT_TRUE(map.insertObservation(stepScan(), mrpt::poses::CPose3D()));
  return map;
}

inline terrain::TTerrainOptions withMaxStep(double height)
{
  terrain::TTerrainOptions options;
  options.params.maxStep = height;
  return options;
}

/** Both maps say the same of every cell and plane, and their grids are alike. */
inline void expectSameTerrain(const CTerrainGridMap2D& a, const CTerrainGridMap2D& b)
{
  const auto same = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
  const auto as = a.styledLayers(), bs = b.styledLayers();
  for (std::size_t i = 0; i < as.size(); ++i)
  {
    ASSERT_EQ(as[i].layer->frame(), bs[i].layer->frame());
    EXPECT_TRUE(std::equal(as[i].layer->cells().begin(), as[i].layer->cells().end(),
                           bs[i].layer->cells().begin(), same))
        << as[i].name;
  }
  EXPECT_EQ(a.terrain().cells(), b.terrain().cells());
  EXPECT_EQ(a.terrain().leaves(), b.terrain().leaves());
  EXPECT_EQ(a.terrain().planes().size(), b.terrain().planes().size());
  EXPECT_TRUE(a.getRawMap() == b.getRawMap());
  EXPECT_EQ(a.isEmpty(), b.isEmpty());
}
}  // namespace mrpt_mapconv::fixtures
