#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/PlaneColors.h>

#include <cmath>
#include <random>

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::grid::picture;

namespace
{
double difference(const mrpt::img::TColor& a, const mrpt::img::TColor& b)
{
  return std::hypot(a.R - b.R, a.G - b.G, a.B - b.B);
}
}  // namespace

TEST(PlaneColors, TellNeighboursApartInAnyMap)
{
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round)
  {
    Layer<float> planes(GridFrame{0.1, 0, 0, 40, 40}, NAN);
    for (std::int32_t y = 0; y < 40; ++y)
      for (std::int32_t x = 0; x < 40; ++x)  // patches of 5 x 5 cells, of any index
        if (random() % 4 != 0)
          planes.at(x, y) = static_cast<float>(17 * ((x / 5 * 7 + y / 5 * round) % 23));
    const PlaneColors colors(planes);
    for (std::int32_t y = 0; y < 40; ++y)
      for (std::int32_t x = 0; x + 1 < 40; ++x)
      {
        const float a = planes.at(x, y), b = planes.at(x + 1, y);
        if (std::isnan(a) || std::isnan(b) || a == b) continue;
        EXPECT_GT(difference(colors.of(static_cast<std::int32_t>(a)),
                             colors.of(static_cast<std::int32_t>(b))),
                  50)
            << a << ", " << b;
      }
  }
}

TEST(PlaneColors, NeighboursMayHaveAGapBetweenThem)
{
  Layer<float> planes(GridFrame{0.1, 0, 0, 4, 1}, NAN);
  planes.at(0, 0) = 0;
  planes.at(kPlaneGap, 0) = 16;  // of so many colours each is used again
  const PlaneColors colors(planes);
  EXPECT_GT(difference(colors.of(0), colors.of(16)), 50);
  EXPECT_EQ(colors.planes(), 2u);
}

TEST(PlaneColors, AreNeverThoseOfCellsWithoutAPlane)
{
  Layer<float> planes(GridFrame{0.1, 0, 0, 40, 1}, NAN);
  for (int x = 0; x < 40; ++x) planes.at(x, 0) = static_cast<float>(x);
  const PlaneColors colors(planes);
  for (int plane = 0; plane < 40; ++plane)
    for (const double t : {0.0, 0.5, 1.0})
      EXPECT_GT(difference(colors.of(plane), bareColor(t)), 30) << plane;
  EXPECT_LT(bareColor(0).R, bareColor(1).R);
}
