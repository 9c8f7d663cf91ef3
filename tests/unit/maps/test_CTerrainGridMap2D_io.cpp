#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt_mapconv/grid/GeoTiff.h>

#include <set>

#include "TerrainFixtures.h"
#include "support/ThrownMessage.h"

// Streams, files, scenes and ini texts of the map.
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose3D;

namespace
{
CTerrainGridMap2D unusualMap()
{
  terrain::TTerrainOptions options;
  options.params.heightRule = terrain::HeightRule::Maximum;
  options.params.maxStep = 0.1;
  CTerrainGridMap2D map(0.07, options);
  map.maxGridCells = 12345;
  map.terrainInsertionOptions.limits.maxHeight = 1.5;
  map.terrainInsertionOptions.sigmas.beam = 0.002;
  map.renderingOptions.showOutlines = false;
  map.likelihoodOptions.LF_useSquareDist = true;
  map.genericMapParams.enableSaveAs3DObject = false;
  map.insertObservation(stepScan(), CPose3D(0.3, -0.2, 1, 0.5, 0, 0));
  return map;
}

CTerrainGridMap2D::Ptr roundTrip(const CTerrainGridMap2D& map)
{
  std::vector<std::uint8_t> stream;
  mrpt::serialization::ObjectToOctetVector(&map, stream);
  mrpt::serialization::CSerializable::Ptr object;
  mrpt::serialization::OctetVectorToObject(stream, object);
  return std::dynamic_pointer_cast<CTerrainGridMap2D>(object);
}

CTerrainGridMap2D::Ptr fromIni(const std::string& text)
{
  const mrpt::config::CConfigFileMemory ini("[map]\nterrainGrid_count=1\n" + text);
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(ini, "map");
  mrpt::maps::CMultiMetricMap maps;
  maps.setListOfMaps(definitions);
  return std::dynamic_pointer_cast<CTerrainGridMap2D>(maps.maps.at(0));
}
}  // namespace

TEST(CTerrainGridMap2D_io, AStreamBringsBackMapAndOptionsExactly)
{
  auto map = unusualMap();
  const auto read = roundTrip(map);
  ASSERT_TRUE(read);
  expectSameTerrain(map, *read);
  EXPECT_EQ(read->cellSize(), 0.07);
  EXPECT_EQ(read->terrain().params().heightRule, terrain::HeightRule::Maximum);
  EXPECT_EQ(read->terrain().params().maxStep, 0.1);
  EXPECT_EQ(read->maxGridCells, 12345);
  EXPECT_EQ(read->terrainInsertionOptions.limits.maxHeight, 1.5);
  EXPECT_EQ(read->terrainInsertionOptions.sigmas.beam, 0.002);
  EXPECT_FALSE(read->renderingOptions.showOutlines);
  EXPECT_TRUE(read->likelihoodOptions.LF_useSquareDist);
  EXPECT_FALSE(read->genericMapParams.enableSaveAs3DObject);
  for (auto* one : {&map, read.get()})
    one->insertObservation(stepScan(1), CPose3D(0, 0, 1, 0, 0, 0));
  expectSameTerrain(map, *read);
}

TEST(CTerrainGridMap2D_io, AnEmptyMapSurvivesAsWell)
{
  const auto read = roundTrip(CTerrainGridMap2D(0.2));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->isEmpty());
  EXPECT_EQ(read->cellSize(), 0.2);
  EXPECT_TRUE(read->insertObservation(stepScan(), CPose3D()));
}

TEST(CTerrainGridMap2D_io, ATruncatedOrNewerStreamThrowsAndLeavesTheMapAsItWas)
{
  mrpt::io::CMemoryStream whole;
  mrpt::serialization::archiveFrom(whole) << unusualMap();
  const auto size = whole.getTotalBytesCount();
  auto target = stepMap();
  const auto before = target;
  for (std::uint64_t length = 0; length < size; length += length < 1500 ? 7 : size / 23)
  {
    mrpt::io::CMemoryStream part;
    part.assignMemoryNotOwn(whole.getRawBufferData(), length);
    auto archive = mrpt::serialization::archiveFrom(part);
    EXPECT_ANY_THROW(archive >> target) << length;
    expectSameTerrain(target, before);
  }
  const auto* bytes = static_cast<const char*>(whole.getRawBufferData());
  std::string newer(bytes, bytes + size);
  newer[newer.find("CTerrainGridMap2D") + std::string("CTerrainGridMap2D").size()] = 77;
  mrpt::io::CMemoryStream part;
  part.assignMemoryNotOwn(newer.data(), newer.size());
  auto archive = mrpt::serialization::archiveFrom(part);
  EXPECT_ANY_THROW(archive >> target);
  expectSameTerrain(target, before);
}

TEST(CTerrainGridMap2D_io, SavesEveryLayerLeavesPlanesAndSteps)
{
  const TempDir dir;
  const auto map = stepMap();
  map.saveMetricMapRepresentationToFile(dir.file("m"));
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(dir.path()))
    names.insert(file.path().filename().string());
  EXPECT_EQ(names, (std::set<std::string>{"m.png", "m_limits.txt", "m_layers.tif", "m_height.png",
                                          "m_sigma.png", "m_plane.png", "m_leafSide.png",
                                          "m_slope.png", "m_traversability.png", "m_leaves.png",
                                          "m_planes.csv", "m_steps.csv", "m_times.csv"}));
  for (const auto& layer : map.styledLayers())
  {
    const auto read = grid::readGeoTiffBand(dir.file("m_layers.tif"), layer.name);
    EXPECT_EQ(read.frame(), layer.layer->frame()) << layer.name;
  }
  EXPECT_EQ(grid::readGeoTiffMetadata(dir.file("m_layers.tif")).at("planeTolerance"), "0.02");
  const auto steps = readBytes(dir.file("m_steps.csv"));
  EXPECT_EQ(steps.rfind("lower,upper,height,depth,width,x,y,directionX,directionY\n0,1,0.15", 0),
            0u)
      << steps;
}

TEST(CTerrainGridMap2D_io, AnEmptyMapIsSavedAsItsGrid)
{
  const TempDir dir;
  CTerrainGridMap2D(0.1).saveMetricMapRepresentationToFile(dir.file("m"));
  EXPECT_TRUE(std::filesystem::exists(dir.file("m.png")));
  EXPECT_FALSE(std::filesystem::exists(dir.file("m_layers.tif")));
}

TEST(CTerrainGridMap2D_io, IsDrawnAsLeavesOrAsItsGrid)
{
  auto map = stepMap();
  const auto names = [&map]
  {
    mrpt::opengl::CSetOfObjects scene;
    map.getVisualizationInto(scene);
    std::set<std::string> all;
    for (const auto& object : scene) all.insert(object->getName());
    return all;
  };
  EXPECT_EQ(names(), (std::set<std::string>{"planes", "cells", "outlines"}));
  map.renderingOptions.showOutlines = false;
  EXPECT_EQ(names(), (std::set<std::string>{"planes", "cells"}));
  map.renderingOptions.showLeaves = false;
  EXPECT_EQ(names(), (std::set<std::string>{"occupancy"}));
  map.genericMapParams.enableSaveAs3DObject = false;
  EXPECT_TRUE(names().empty());
}

TEST(CTerrainGridMap2D_io, IsMadeFromIniUnderBothNames)
{
  const auto map = fromIni(
      "[map_terrainGrid_00_creationOpts]\nresolution=0.3\nmaxGridCells=1e6\n"
      "enableObservationLikelihood=false\n"
      "[map_terrainGrid_00_insertOpts]\nmaxRange=7\nheightSigma=0.25\n"
      "[map_terrainGrid_00_terrainOpts]\nheightRule=maximum\nmaxStep=0.25\n"
      "[map_terrainGrid_00_likelihoodOpts]\nlikelihoodMethod=lmConsensus\n"
      "[map_terrainGrid_00_renderOpts]\nshowOutlines=false\n");
  ASSERT_TRUE(map);
  EXPECT_EQ(map->cellSize(), 0.3);
  EXPECT_EQ(map->maxGridCells, 1e6);
  EXPECT_FALSE(map->genericMapParams.enableObservationLikelihood);
  EXPECT_EQ(map->terrainInsertionOptions.limits.maxRange, 7);
  EXPECT_EQ(map->terrainInsertionOptions.sigmas.height, 0.25);
  EXPECT_EQ(map->terrain().params().heightRule, terrain::HeightRule::Maximum);
  EXPECT_EQ(map->terrain().params().maxStep, 0.25);
  EXPECT_EQ(map->likelihoodOptions.likelihoodMethod, mrpt::maps::COccupancyGridMap2D::lmConsensus);
  EXPECT_FALSE(map->renderingOptions.showOutlines);

  const mrpt::config::CConfigFileMemory longName(
      "[map]\nmrpt_mapconv::CTerrainGridMap2D_count=1\n");
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(longName, "map");
  EXPECT_EQ(definitions.size(), 1u);
}

TEST(CTerrainGridMap2D_io, ABadIniValueIsAnErrorThatNamesIt)
{
  for (const auto& [section, key, value] :
       std::vector<std::array<std::string, 3>>{{"creationOpts", "resolution", "0"},
                                               {"creationOpts", "maxGridCells", "0"},
                                               {"insertOpts", "maxRange", "0"},
                                               {"insertOpts", "maxHeight", "-200"},
                                               {"insertOpts", "rangeSigma", "-1"},
                                               {"terrainOpts", "hypotheses", "0"},
                                               {"terrainOpts", "blockCells", "0"},
                                               {"terrainOpts", "heightRule", "median"},
                                               {"renderOpts", "showLeaves", "maybe"}})
  {
    const std::string text = "[map_terrainGrid_00_" + section + "]\n" + key + " = " + value + "\n";
    const auto message = test::thrownMessage<std::exception>([&] { fromIni(text); });
    EXPECT_NE(message.find("map_terrainGrid_00_" + section), std::string::npos) << message;
    const bool isNamed = message.find(key + " = '" + value) != std::string::npos ||
                         message.find(key + " = " + value) != std::string::npos;
    EXPECT_TRUE(isNamed) << message;
  }
}
