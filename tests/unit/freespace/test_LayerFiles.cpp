#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <cmath>
#include <stdexcept>
#include <tuple>

#include "support/TempDir.h"

using namespace mrpt_mapconv;
using mrpt_mapconv::testing::TempDir;

namespace
{
freespace::Layers sample()
{
  freespace::Layers layers({0.1, -3, 4, 2, 2});
  layers.floor.cells() = {0.1f, NAN, 0.3f, -0.4f};
  layers.ceiling.cells() = {2.1f, NAN, 2.3f, 2.4f};
  layers.slope.cells() = {0, NAN, 0.5f, NAN};
  layers.aerial.cells() = {0, 0.75f, 0, 0};
  layers.ground.cells() = {0, 0.75f, 1, -1};
  return layers;
}

std::string failure(const std::string& path)
{
  try
  {
    freespace::readLayersTiff(path);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(LayerFiles, OfVersionsThatKnewNoEvidenceMeanThatTheFloorIsTheGround)
{
  const TempDir dir;
  const std::string path = dir.path("layers.tif");
  const auto layers = sample();
  grid::Metadata items = freespace::metadataOf({});
  for (const char* later : {"floorFrom", "maxGap", "maxHiddenGap", "unknown"}) items.erase(later);
  items["maxStep"] = "0";
  auto bands = layers.styled();
  bands.resize(5);
  grid::writeGeoTiff(path, bands, items);
  const auto file = freespace::readLayersTiff(path);
  EXPECT_EQ(freespace::FloorFrom::LowestFree, file.params.floorFrom);
  EXPECT_EQ(0.0, file.params.maxStep) << "off, and not auto";
  EXPECT_EQ(0.3f, file.layers.support.at(0, 1));
  EXPECT_TRUE(std::isnan(file.layers.support.at(1, 0)));
  EXPECT_EQ(layers.frame(), file.layers.evidence.frame());
  EXPECT_EQ(0, file.layers.evidence.at(0, 0));
}

TEST(LayerFiles, LayersAndParametersComeBack)
{
  const TempDir dir;
  const std::string path = dir.path("layers.tif");
  auto params = freespace::ConversionParams::paper();
  params.minClearance = 0.1 + 0.2;  // all digits count
  params.minOccupancy = 0.25;
  params.slopeWindow = 3;
  params.maxSlope = 0.7;
  params.maxStep = 0.15;
  const auto layers = sample();
  freespace::writeLayersTiff(path, layers, params);
  const auto file = freespace::readLayersTiff(path);
  EXPECT_EQ(0.1 + 0.2, file.params.minClearance);
  EXPECT_EQ(0.25, file.params.minOccupancy);
  EXPECT_EQ(3, file.params.slopeWindow);
  EXPECT_EQ(0.7, file.params.maxSlope);
  EXPECT_EQ(0.15, file.params.maxStep);
  const auto expected = layers.named(), actual = file.layers.named();
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(layers.frame(), actual[i].second->frame());
    for (std::size_t c = 0; c < layers.frame().size(); ++c)
    {
      const float a = expected[i].second->cells()[c], b = actual[i].second->cells()[c];
      EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << expected[i].first << ' ' << c;
    }
  }
}

TEST(LayerFiles, AutoComesBack)
{
  const TempDir dir;
  const std::string path = dir.path("layers.tif");
  freespace::writeLayersTiff(path, sample(), {});
  const auto params = freespace::readLayersTiff(path).params;
  EXPECT_FALSE(params.maxStep);
  EXPECT_EQ(freespace::FloorFrom::Seen, params.floorFrom);
}

TEST(LayerFiles, WhatIsWrittenWronglyIsNamedWithWhatWouldBeRight)
{
  const TempDir dir;
  const std::string path = dir.path("layers.tif");
  for (const auto& [name, text, right] : {std::tuple{"floorFrom", "sein", "lowestFree or seen"},
                                          {"maxStep", "autx", "a finite number or auto"},
                                          {"maxSlope", "steep", "a finite number"},
                                          {"slopeWindow", "2.5", "a whole number"}})
  {
    grid::Metadata items = freespace::metadataOf({});
    items[name] = text;
    grid::writeGeoTiff(path, sample().styled(), items);
    EXPECT_EQ("cannot read '" + path + "': its " + name + " = '" + text +
                  "' is not valid: it must be " + right,
              failure(path));
  }
}

TEST(LayerFiles, FilesOfOthersAreRefused)
{
  const TempDir dir;
  const std::string path = dir.path("other.tif");
  const auto layers = sample();
  grid::writeGeoTiff(path, {{"floor", &layers.floor}});
  EXPECT_NE(std::string::npos, failure(path).find("minClearance")) << failure(path);
  grid::writeGeoTiff(path, {{"floor", &layers.floor}},
                     {{"minClearance", "-1"},
                      {"minOccupancy", "0.5"},
                      {"slopeWindow", "2"},
                      {"maxSlope", "2"},
                      {"maxStep", "0"}});
  EXPECT_NE(std::string::npos, failure(path).find("minClearance = -1")) << failure(path);
  grid::writeGeoTiff(path, {{"floor", &layers.floor}},
                     {{"minClearance", "1"},
                      {"minOccupancy", "0.5"},
                      {"slopeWindow", "2"},
                      {"maxSlope", "steep"},
                      {"maxStep", "0"}});
  EXPECT_NE(std::string::npos, failure(path).find("maxSlope = 'steep'")) << failure(path);
}
