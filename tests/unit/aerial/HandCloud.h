#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace mrpt_mapconv::test
{
/** A cloud whose ground is known. */
struct HandCloud
{
  cloud::PointCloud cloud;
  std::vector<std::uint8_t> truth;  //!< class of each point

  void add(double x, double y, double z, bool isGround)
  {
    cloud.x.push_back(x);
    cloud.y.push_back(y);
    cloud.z.push_back(z);
    truth.push_back(isGround ? cloud::kGround : cloud::kUnclassified);
  }
};

using HeightAt = std::function<double(double x, double y)>;

/** Points every `spacing` over a square of that side, at places that are not borders of cells. */
inline void addGround(HandCloud& hand, double side, double spacing, const HeightAt& ground)
{
  const auto count = static_cast<int>(side / spacing);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k)
    {
      const double x = (i + 0.37) * spacing, y = (k + 0.41) * spacing;
      hand.add(x, y, ground(x, y), true);
    }
}

/** Replaces the ground within a rectangle by a roof of that height above it. */
inline void addBox(HandCloud& hand, double xMin, double xMax, double yMin, double yMax,
                   double height)
{
  for (std::size_t i = 0; i < hand.cloud.size(); ++i)
  {
    const double x = hand.cloud.x[i], y = hand.cloud.y[i];
    if (x < xMin || x > xMax || y < yMin || y > yMax) continue;
    hand.cloud.z[i] += height;
    hand.truth[i] = cloud::kUnclassified;
  }
}

}  // namespace mrpt_mapconv::test
