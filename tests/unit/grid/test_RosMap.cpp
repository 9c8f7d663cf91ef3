#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/RosMap.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <tuple>
#include <vector>

#include "support/TempDir.h"

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::testing;

namespace
{
/** Free, but for a lower left cell that is occupied and the cell above it that is unknown. */
Layer<float> corner(const GridFrame& frame)
{
  Layer<float> layer(frame, kFree);
  layer.at(0, 0) = 0.001f;
  layer.at(0, 1) = kUnknown;
  return layer;
}

/** What follows "<key>: " in a YAML text, up to the end of the line. */
std::string valueOf(const std::string& yaml, const std::string& key)
{
  const auto begin = yaml.find(key + ": ");
  if (begin == std::string::npos) return {};
  const auto value = begin + key.size() + 2;
  return yaml.substr(value, yaml.find('\n', value) - value);
}
}  // namespace

TEST(RosMap, bytesByHand)
{
  const TempDir dir;
  Layer<float> layer = corner({0.5, -4, 2, 3, 2});
  layer.at(2, 0) = std::numeric_limits<float>::quiet_NaN();
  layer.at(2, 1) = 1.0f;
  writeRosMap(dir.path("map.pgm"), dir.path("map.yaml"), "map.pgm", layer);
  EXPECT_EQ(readBytes(dir.path("map.pgm")),
            "P5\n3 2\n255\n\xCD\xFE" + std::string(1, '\0') + std::string(1, '\0') + "\xFE\xCD");
  EXPECT_EQ(readBytes(dir.path("map.yaml")),
            "image: map.pgm\nmode: trinary\nresolution: 0.5\norigin: [-2, 1, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(RosMap, theOriginOfALocalFrameIsAdded)
{
  const TempDir dir;
  Layer<float> layer({0.5, -3, 2, 2, 2}, 0);
  writeRosMap(dir.path("m.pgm"), dir.path("m.yaml"), "m.pgm", layer,
              {{448258, 5411929, 200}, "EPSG:32633"});
  std::ifstream file(dir.path("m.yaml"));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("origin: [448256.5, 5411930, 0]"), std::string::npos) << text;
}

TEST(RosMap, numbersRoundTrip)
{
  const TempDir dir;
  for (const double resolution : {0.05, 0.07, 0.1, 1.0 / 3, 1e-5, 1.0})
  {
    const GridFrame frame{resolution, -12347, 3, 2, 2};
    writeRosMap(dir.path("m.pgm"), dir.path("m.yaml"), "m.pgm", corner(frame));
    const std::string yaml = readBytes(dir.path("m.yaml"));
    EXPECT_EQ(std::strtod(valueOf(yaml, "resolution").c_str(), nullptr), resolution) << yaml;
    const std::string origin = valueOf(yaml, "origin");
    char* rest = nullptr;
    EXPECT_EQ(std::strtod(origin.c_str() + 1, &rest), frame.xMin()) << yaml;
    EXPECT_EQ(std::strtod(rest + 1, nullptr), frame.yMin()) << yaml;
  }
}

/** YAML 1.1 takes "1e-04" for a string. */
TEST(RosMap, numbersHaveNoExponent)
{
  const TempDir dir;
  for (const auto& [frame, resolution, origin] :
       std::vector<std::tuple<GridFrame, std::string, std::string>>{
           {{1e-4, -10000, 0, 3, 3}, "resolution: 0.0001\n", "origin: [-1, 0, 0"},
           {{0.5, 896516, 10823858, 3, 3}, "resolution: 0.5\n", "origin: [448258, 5411929, 0"},
           {{1e3, 1000000, -1000000, 3, 3},
            "resolution: 1000\n",
            "origin: [1000000000, -1000000000, 0"}})
  {
    writeRosMap(dir.path("m.pgm"), dir.path("m.yaml"), "m.pgm", corner(frame));
    const std::string yaml = readBytes(dir.path("m.yaml"));
    EXPECT_NE(std::string::npos, yaml.find(resolution)) << yaml;
    EXPECT_NE(std::string::npos, yaml.find(origin)) << yaml;
  }
}

TEST(RosMap, thresholdsTellThePixelsApart)
{
  // p = (255 − pixel)/255 as map_server computes it.
  EXPECT_GT(255 / 255.0, 0.65);
  EXPECT_LT((255 - 254) / 255.0, 0.196);
  EXPECT_GT((255 - 205) / 255.0, 0.196);
  EXPECT_LT((255 - 205) / 255.0, 0.65);
}

TEST(RosMap, mrptReadsIt)
{
  const TempDir dir;
  for (const double resolution : {0.05, 0.07, 0.1})
  {
    const GridFrame frame{resolution, -217, 31, 40, 30};
    writeRosMap(dir.path("m.pgm"), dir.path("m.yaml"), "m.pgm", corner(frame));
    const auto map = mrpt::maps::COccupancyGridMap2D::FromROSMapServerYAML(dir.path("m.yaml"));
    ASSERT_EQ(map.getSizeX(), 40U);
    ASSERT_EQ(map.getSizeY(), 30U);
    EXPECT_NEAR(map.getXMin(), frame.xMin(), 1e-5);
    EXPECT_NEAR(map.getYMin(), frame.yMin(), 1e-5);
    EXPECT_FLOAT_EQ(map.getResolution(), static_cast<float>(resolution));
    EXPECT_LT(map.getCell(0, 0), 0.1f);
    EXPECT_NEAR(map.getCell(0, 1), 0.5f, 0.01f);
    EXPECT_GT(map.getCell(1, 0), 0.9f);
    EXPECT_GT(map.getCell(0, 29), 0.9f);
  }
}

TEST(RosMap, unusualImageNamesAreQuoted)
{
  const TempDir dir;
  writeRosMap(dir.path("m.pgm"), dir.path("m.yaml"), "a \"b\": c.pgm", corner({1, 0, 0, 2, 2}));
  EXPECT_EQ(valueOf(readBytes(dir.path("m.yaml")), "image"), R"("a \"b\": c.pgm")");
}

TEST(RosMap, errors)
{
  const TempDir dir;
  const Layer<float> layer = corner({0.1, 0, 0, 2, 2});
  EXPECT_THROW(writeRosMap(dir.path("m.pgm"), dir.path("m.yaml"), "m.pgm", {}),
               std::invalid_argument);
  EXPECT_TRUE(
      contains(messageOf([&] { writeRosMap("/dev/full", dir.path("m.yaml"), "m.pgm", layer); }),
               "'/dev/full': No space left"));
  EXPECT_TRUE(
      contains(messageOf([&] { writeRosMap(dir.path("m.pgm"), "/dev/full", "m.pgm", layer); }),
               "'/dev/full': No space left"));
}
