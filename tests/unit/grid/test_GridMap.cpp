#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <random>

#include "support/TempDir.h"

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::testing;
using mrpt::maps::COccupancyGridMap2D;

namespace
{
Layer<float> randomOccupancy(const GridFrame& frame)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(-1, 1);
  Layer<float> layer(frame, kUnknown);
  for (float& cell : layer.cells())
  {
    const float v = value(random);
    cell = v > 0 ? v : v > -0.5f ? kFree : kUnknown;
  }
  return layer;
}

void expectSame(const COccupancyGridMap2D& map, const Layer<float>& layer)
{
  const GridFrame& frame = layer.frame();
  ASSERT_EQ(map.getSizeX(), static_cast<unsigned>(frame.width));
  ASSERT_EQ(map.getSizeY(), static_cast<unsigned>(frame.height));
  EXPECT_FLOAT_EQ(map.getXMin(), static_cast<float>(frame.xMin()));
  EXPECT_FLOAT_EQ(map.getYMax(), static_cast<float>(frame.yMax()));
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      ASSERT_EQ(map.getRow(iy)[ix], rawGridCell(layer.at(ix, iy))) << ix << ", " << iy;
}
}  // namespace

TEST(GridMap, copyKeepsFrameAndCells)
{
  COccupancyGridMap2D map;
  for (const double resolution : {0.05, 0.07, 0.08, 0.1, 1.0 / 3, 1.0})
    for (const std::int32_t x0 : {-4567, -1, 0, 12345})
    {
      const Layer<float> layer = randomOccupancy({resolution, x0, 3 * x0 + 1, 61, 43});
      copyToGridMap(layer, map);
      expectSame(map, layer);
      EXPECT_FALSE(map.isEmpty());
    }
}

TEST(GridMap, refusesFramesThatFloatsCannotHold)
{
  COccupancyGridMap2D map;
  EXPECT_THROW(copyToGridMap({}, map), std::invalid_argument);
  for (const std::int32_t x0 : {1 << 25, 1 << 29, -(1 << 27)})
  {
    const auto message = messageOf(
        [&] {
          copyToGridMap(Layer<float>({0.07, x0, 0, 3, 3}, kFree), map);
        });
    EXPECT_TRUE(contains(message, "3 x 3 cells of 0.07")) << message;
  }
}

TEST(GridMap, stockMrptReadsTheFile)
{
  const TempDir dir;
  const Layer<float> layer = randomOccupancy({0.07, -211, 333, 300, 200});
  writeGridMap(dir.path("m.gridmap"), layer);
  mrpt::io::CFileGZInputStream file(dir.path("m.gridmap"));
  COccupancyGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  expectSame(map, layer);
}

TEST(GridMap, errorsNameFileAndReason)
{
  const TempDir dir;
  const Layer<float> layer(GridFrame{0.1, 0, 0, 2, 2}, kFree);
  EXPECT_EQ(messageOf([&] { writeGridMap("/dev/full", layer); }),
            "cannot write '/dev/full': No space left on device");
  EXPECT_TRUE(
      contains(messageOf([&] { writeGridMap(dir.path("no/m.gridmap"), layer); }), "No such file"));
}
