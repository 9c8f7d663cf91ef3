#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cmath>
#include <limits>

#include "RandomMap.h"

namespace mrpt_mapconv::test
{
/** Points over hilly ground with boxes on it, some on borders of cells, some far too low. */
inline cloud::PointCloud randomCloud(Rng& rng, int points, double side)
{
  cloud::PointCloud cloud;
  const double slope = uniform(rng, 0, 0.8), bump = uniform(rng, 0, 2);
  const double x0 = uniform(rng, -50, 50), y0 = uniform(rng, -50, 50);
  for (int i = 0; i < points; ++i)
  {
    double x = x0 + uniform(rng, 0, side), y = y0 + uniform(rng, 0, side);
    if (chance(rng, 20)) y = std::round(y * 2) / 2;
    double z = slope * x + bump * std::sin(x / 3) * std::cos(y / 4);
    if (std::fmod(std::abs(x) + std::abs(y), 11.0) < 3) z += 4;
    if (chance(rng, 2)) z -= uniform(rng, 1, 30);
    cloud.x.push_back(x);
    cloud.y.push_back(y);
    cloud.z.push_back(z);
  }
  return cloud;
}

/** Steps, slopes and noise; each cell is empty with a chance, one is not. */
inline grid::Layer<float> randomHeights(Rng& rng, int width, int height, int percentEmpty)
{
  grid::GridFrame frame;
  frame.resolution = 0.5;
  frame.width = width;
  frame.height = height;
  frame.x0 = pick(rng, -9, 9);
  grid::Layer<float> heights(frame, 0);
  const double slope = uniform(rng, -1, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      heights.at(x, y) =
          chance(rng, percentEmpty)
              ? std::numeric_limits<float>::quiet_NaN()
              : static_cast<float>(slope * x + (x / 7 + y / 5) % 3 + 0.25 * pick(rng, 0, 4));
  heights.at(pick(rng, 0, width - 1), pick(rng, 0, height - 1)) = 1;
  return heights;
}

}  // namespace mrpt_mapconv::test
