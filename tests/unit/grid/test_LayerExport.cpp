#include <gtest/gtest.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/RosMap.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "support/TempDir.h"

using namespace mrpt_mapconv::grid;
using namespace mrpt_mapconv::testing;
using mrpt_mapconv::files::OutputDir;

namespace
{
const GridFrame kFrame{0.1, -3, 4, 8, 6};

struct Sample
{
  Layer<float> height{kFrame, 1.5f}, occupancy{kFrame, 0.0f};
  std::vector<StyledLayer> styled{
      {"floor", &height, "Floor", "m", LayerKind::Height},
      {"aerial", &occupancy, "Occupancy", "", LayerKind::Occupancy},
  };
};

ExportFormats everything()
{
  ExportFormats formats{"all.tif", {{"made", "here"}}, "map_"};
  formats.pictures = formats.gridMaps = formats.rosMaps = true;
  return formats;
}

std::set<std::string> filesIn(const std::string& dir)
{
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(dir))
    names.insert(entry.path().filename().string());
  return names;
}
}  // namespace

TEST(LayerExport, WritesWhatIsAskedFor)
{
  const TempDir dir;
  const Sample sample;
  OutputDir out(dir.path("out"));
  exportLayers(out, sample.styled, everything());
  out.commit();
  EXPECT_EQ(filesIn(dir.path("out")),
            (std::set<std::string>{"all.tif", "map_floor.png", "map_aerial.png",
                                   "map_aerial.gridmap", "map_aerial.pgm", "map_aerial.yaml"}));
}

TEST(LayerExport, FilesAreThoseOfTheSingleWriters)
{
  const TempDir dir;
  const Sample sample;
  OutputDir out(dir.path("out"));
  exportLayers(out, sample.styled, everything());
  out.commit();
  writeGeoTiff(dir.path("x.tif"), sample.styled, {{"made", "here"}});
  writeLayerPng(dir.path("x.png"), sample.styled[0]);
  writeGridMap(dir.path("x.gridmap"), sample.occupancy);
  writeRosMap(dir.path("x.pgm"), dir.path("x.yaml"), "map_aerial.pgm", sample.occupancy);
  for (const auto& [mine, theirs] : {std::pair{"x.tif", "all.tif"},
                                     {"x.png", "map_floor.png"},
                                     {"x.gridmap", "map_aerial.gridmap"},
                                     {"x.pgm", "map_aerial.pgm"},
                                     {"x.yaml", "map_aerial.yaml"}})
    EXPECT_TRUE(readBytes(dir.path(mine)) == readBytes(dir.path(std::string("out/") + theirs)))
        << theirs;
}

TEST(LayerExport, NothingIsWrittenUnasked)
{
  const TempDir dir;
  const Sample sample;
  OutputDir out(dir.path("out"));
  exportLayers(out, sample.styled, {});
  out.commit();
  EXPECT_TRUE(filesIn(dir.path("out")).empty());
}

TEST(LayerExport, TellsItsProgress)
{
  const TempDir dir;
  const Sample sample;
  OutputDir out(dir.path("out"));
  std::vector<double> shares;
  exportLayers(out, sample.styled, everything(), [&](double share) { shares.push_back(share); });
  EXPECT_EQ(shares, (std::vector<double>{0.2, 0.4, 0.6, 0.8, 1}));
}

TEST(LayerExport, LayersOfTwoFramesAreRefusedInOneFile)
{
  const TempDir dir;
  Sample sample;
  sample.occupancy = {GridFrame{0.1, 0, 0, 2, 2}, 0.0f};
  OutputDir out(dir.path("out"));
  EXPECT_THROW(exportLayers(out, sample.styled, {"all.tif"}), std::invalid_argument);
}
