// From which height on the slope test marks a wall that is one cell thick.
#include <gtest/gtest.h>

#include "support/HandMap.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::ConversionParams;

/** Whether any cell is steep around something of `height` voxels on free ground: a fence across,
 * or a post. */
bool isMarked(int height, bool post, const ConversionParams& params)
{
  constexpr int kSide = 15, kMiddle = 7;
  test::HandMap map(0.1);
  for (int kx = 0; kx < kSide; ++kx)
    for (int ky = 0; ky < kSide; ++ky)
    {
      const bool thing = kx == kMiddle && (ky == kMiddle || !post);
      if (thing) map.occupied(kx, ky, 0, height);
      map.free(kx, ky, thing ? height : 0, 100);
    }
  return freespace::statistics(map.convert(params)).steep > 0;
}

TEST(ThinWalls, AFenceIsMarkedOnlyFromMinThinWallOn)
{
  for (const int window : {1, 2, 3})
    for (const double maxSlope : {0.95, 1.3, 1.95})
    {
      auto params = ConversionParams::paper();
      params.slopeWindow = window;
      params.maxSlope = maxSlope;
      const double lowest = params.minThinWall(0.1);
      for (int height = 1; height <= 25; ++height)
        EXPECT_EQ(isMarked(height, false, params), height * 0.1 > lowest)
            << height << " voxels, window " << window << ", maxSlope " << maxSlope;
    }
}

TEST(ThinWalls, WithThePapersParametersThatIsOneMetre)
{
  const auto params = ConversionParams::paper();
  EXPECT_NEAR(params.minThinWall(0.1), 1.0, 1e-12);
  EXPECT_NEAR(params.minThinWall(0.2), 2.0, 1e-12);
  EXPECT_FALSE(isMarked(9, false, params));
  EXPECT_FALSE(isMarked(10, false, params));
  EXPECT_TRUE(isMarked(11, false, params));
}

TEST(ThinWalls, APostHardlyEver)
{
  // at the window's corner its slope has both components, each a fifth of a wall's
  EXPECT_FALSE(isMarked(30, true, ConversionParams::paper()));
  EXPECT_TRUE(isMarked(36, true, ConversionParams::paper()));
}

}  // namespace
