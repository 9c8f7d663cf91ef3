#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "StoredMaps.h"

// Worked out by hand from the scans; see StoredMaps.h.

namespace mrpt_mapconv::fixtures
{
namespace
{
using Cell = std::pair<std::int32_t, std::int32_t>;  // its key
using Values = std::map<Cell, double>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kUnknown = -1;

/** Expects these cells, and all others to have one value. */
void expectCells(const Values& cells, double others, const grid::Layer<float>& layer,
                 const std::string& name)
{
  const grid::GridFrame& frame = layer.frame();
  for (std::int32_t ky = frame.y0; ky < frame.yEnd(); ++ky)
    for (std::int32_t kx = frame.x0; kx < frame.xEnd(); ++kx)
    {
      const auto known = cells.find({kx, ky});
      const double expected = known == cells.end() ? others : known->second;
      const double actual = layer.cells()[frame.indexOfKey(kx, ky)];
      if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(actual)) << name << " " << kx << " " << ky << " is " << actual;
      else
        EXPECT_NEAR(expected, actual, 1e-6) << name << " " << kx << " " << ky;
    }
}

/** The cells of column x = 0 from y = 2 to 7, of which two beams to the left tell. */
Values withLeft(double value, Values cells)
{
  for (std::int32_t y = 2; y <= 7; ++y) cells.insert({{0, y}, value});
  return cells;
}

/** The log-odds of a voxel with these keys. */
double voxelAt(const CFreeSpaceGridMap2D& map, int x, int y, int z)
{
  constexpr int kOrigin = 32768;
  const auto key = [](int i) { return static_cast<octomap::key_type>(i + kOrigin); };
  const auto* node = map.octree().search(octomap::OcTreeKey(key(x), key(y), key(z)));
  return node ? static_cast<double>(node->getLogOdds()) : kNone;
}

void expectVoxels(const CFreeSpaceGridMap2D& map)
{
  const double hit = std::log(3), miss = std::log(0.6);  // 0.75 and 0.375
  EXPECT_NEAR(hit, voxelAt(map, 0, 0, 0), 1e-6) << "the floor below the first scan";
  EXPECT_NEAR(miss, voxelAt(map, 0, 0, 1), 1e-6);
  EXPECT_NEAR(2 * miss, voxelAt(map, 0, 0, 3), 1e-6) << "also on the second scan's way back";
  EXPECT_NEAR(hit, voxelAt(map, 0, 0, 5), 1e-6) << "the ceiling";
  EXPECT_NEAR(hit + miss, voxelAt(map, 2, 0, 3), 1e-6) << "ahead of the first scan";
  EXPECT_NEAR(hit, voxelAt(map, 3, 0, 3), 1e-6) << "ahead of the second";
  EXPECT_NEAR(hit, voxelAt(map, -4, 0, 3), 1e-6) << "behind the first";
  EXPECT_NEAR(miss + hit, voxelAt(map, -3, 0, 3), 1e-6) << "behind the second";
  EXPECT_NEAR(miss, voxelAt(map, 0, 7, 3), 1e-6) << "4 m to the left";
  EXPECT_TRUE(std::isnan(voxelAt(map, 0, 8, 3))) << "beyond maxrange";
}

void expectGrid(const CFreeSpaceGridMap2D& map)
{
  const grid::GridFrame frame = map.layers().frame();
  EXPECT_EQ((grid::GridFrame{0.5, -4, 0, 12, 13}), frame);
  ASSERT_EQ(frame.size(), map.getRawMap().size());
  EXPECT_EQ(-2.0f, map.getXMin());
  EXPECT_EQ(6.5f, map.getYMax());
  const auto raw = [&](std::int32_t x, std::int32_t y)
  { return static_cast<int>(map.getRawMap()[frame.indexOfKey(x, y)]); };
  EXPECT_EQ(127, raw(0, 0)) << "free";
  EXPECT_EQ(127, raw(0, 7));
  EXPECT_EQ(-64, raw(2, 0)) << "occupied: 127 / 2";
  EXPECT_EQ(0, raw(-4, 0)) << "unknown";
}
}  // namespace

void expectStoredFreeSpaceCells(const CFreeSpaceGridMap2D& map)
{
  EXPECT_FALSE(map.isEmpty());
  const freespace::Layers layers = map.exactLayers();
  ASSERT_EQ((grid::GridFrame{0.5, -4, 0, 8, 9}), layers.frame());
  // Free voxels: z = 1 to 4 in (0, 0) and (1, 0), 2 to 5 in (0, 1), 3 and 4 in the others.
  expectCells(withLeft(1.5, {{{0, 0}, 0.5}, {{1, 0}, 0.5}, {{0, 1}, 1}, {{1, 1}, 1.5}}), kNone,
              layers.floor, "floor");
  expectCells(withLeft(2.5, {{{0, 0}, 2.5}, {{1, 0}, 2.5}, {{0, 1}, 3}, {{1, 1}, 2.5}}), kNone,
              layers.ceiling, "ceiling");
  // Gradients of the planes (0.5, 1.5), (0.6, 1.2) and (5/6, 0.5); farther left the floors lie on
  // one line, which gives no plane.
  const double both = std::hypot(0.5, 1.5), five = std::hypot(0.6, 1.2);
  expectCells({{{0, 0}, both},
               {{1, 0}, both},
               {{0, 1}, five},
               {{1, 1}, five},
               {{0, 2}, std::hypot(5.0 / 6, 0.5)}},
              kNone, layers.slope, "slope");
  // The points ahead are one of the two free voxels of (1, 1).
  const Values ahead = {{{2, 0}, 0.5}, {{2, 1}, 0.5}};
  Values aerial = ahead;
  aerial.insert({{{0, 0}, 0}, {{1, 0}, 0}, {{0, 1}, 0}, {{1, 1}, 0}});
  expectCells(withLeft(0, aerial), kUnknown, layers.aerial, "aerial");
  Values ground = ahead;  // steeper than 0.5
  ground.insert({{{0, 0}, 1}, {{1, 0}, 1}, {{0, 1}, 1}, {{1, 1}, 1}, {{0, 2}, 1}});
  expectCells(withLeft(0, ground), kUnknown, layers.ground, "ground");
  expectGrid(map);
  expectVoxels(map);
}

void expectStoredScanShapeCells(const CScanShapeGridMap2D& map)
{
  EXPECT_FALSE(map.isEmpty());
  const grid::GridFrame frame = map.frame();
  ASSERT_EQ((grid::GridFrame{0.25, -9, -1, 21, 9}), frame);
  EXPECT_EQ(-2.25f, map.getXMin());
  EXPECT_EQ(3.0f, map.getXMax());
  EXPECT_EQ(-0.25f, map.getYMin());
  EXPECT_EQ(2.0f, map.getYMax());
  // An occupied cell counts −16 ln 3 = −18, a free one +8; −43 is the limit that 0.9375 gives.
  std::map<Cell, int> cells = {{{8, 0}, -43}, {{-6, 0}, -43}, {{0, 6}, -18}};
  for (std::int32_t x = -5; x <= 7; ++x) cells[{x, 0}] = 3 * 8;  // in all three scans
  for (std::int32_t y = 1; y <= 5; ++y) cells[{0, y}] = 8;       // in the first only
  for (std::int32_t ky = frame.y0; ky < frame.yEnd(); ++ky)
    for (std::int32_t kx = frame.x0; kx < frame.xEnd(); ++kx)
    {
      const auto known = cells.find({kx, ky});
      EXPECT_EQ(known == cells.end() ? 0 : known->second,
                static_cast<int>(map.getRawMap()[frame.indexOfKey(kx, ky)]))
          << kx << " " << ky;
    }
}

}  // namespace mrpt_mapconv::fixtures
