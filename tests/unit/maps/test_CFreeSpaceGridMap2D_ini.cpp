#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "FreeSpaceMapFixtures.h"

// The map as ini files define it.
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::maps::CMultiMetricMap;
using mrpt::maps::TSetOfMetricMapInitializers;

namespace
{
mrpt::maps::CMetricMap::Ptr fromIni(const std::string& text)
{
  const mrpt::config::CConfigFileMemory ini("[map]\nfreeSpaceGrid_count=1\n" + text);
  TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(ini, "map");
  CMultiMetricMap maps;
  maps.setListOfMaps(definitions);
  return maps.maps.at(0);
}
}  // namespace

TEST(CFreeSpaceGridMap2D_ini, IsMadeFromIniUnderBothNames)
{
  const std::string sections =
      "[map_freeSpaceGrid_00_creationOpts]\nresolution=0.3\nenableObservationLikelihood=false\n"
      "[map_freeSpaceGrid_00_insertOpts]\nmaxrange=7\ninsert2D=false\n"
      "[map_freeSpaceGrid_00_conversionOpts]\nrobot=aerial\nminClearance=0.9\n"
      "[map_freeSpaceGrid_00_likelihoodOpts]\nlikelihoodMethod=lmConsensus\nLF_stdHit=0.11\n"
      "[map_freeSpaceGrid_00_renderOpts]\nshowFloor=false\nshowCeiling=true\ncolorBySlope=true\n";
  const auto map = std::dynamic_pointer_cast<CFreeSpaceGridMap2D>(fromIni(sections));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->octree().getResolution(), 0.3);
  EXPECT_FALSE(map->genericMapParams.enableObservationLikelihood);
  EXPECT_EQ(map->voxelInsertionOptions.maxrange, 7);
  EXPECT_FALSE(map->voxelInsertionOptions.insert2D);
  EXPECT_EQ(map->conversionOptions().robot, freespace::Robot::Aerial);
  EXPECT_EQ(map->conversionOptions().params.minClearance, 0.9);
  EXPECT_EQ(map->likelihoodOptions.likelihoodMethod, mrpt::maps::COccupancyGridMap2D::lmConsensus);
  EXPECT_EQ(map->likelihoodOptions.LF_stdHit, 0.11f);
  EXPECT_FALSE(map->renderingOptions.showFloor);
  EXPECT_TRUE(map->renderingOptions.showCeiling);
  EXPECT_TRUE(map->renderingOptions.colorBySlope);

  const mrpt::config::CConfigFileMemory longName(
      "[map]\nmrpt_mapconv::CFreeSpaceGridMap2D_count=1\n");
  TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(longName, "map");
  EXPECT_EQ(definitions.size(), 1u);
}

TEST(CFreeSpaceGridMap2D_ini, TheIniSaysWhatIsDrawn)
{
  const auto map = std::dynamic_pointer_cast<CFreeSpaceGridMap2D>(
      fromIni("[map_freeSpaceGrid_00_creationOpts]\nresolution=0.2\n"
              "[map_freeSpaceGrid_00_renderOpts]\nshowFloor=false\nshowCeiling=true\n"));
  ASSERT_TRUE(map);
  map->insertObservation(roomScan(0));
  mrpt::opengl::CSetOfObjects scene;
  map->getVisualizationInto(scene);
  EXPECT_FALSE(scene.getByName("floor"));
  EXPECT_TRUE(scene.getByName("ceiling"));
}

TEST(CFreeSpaceGridMap2D_ini, ABadIniValueIsAnErrorThatNamesIt)
{
  for (const auto& [section, line] : std::vector<std::pair<std::string, std::string>>{
           {"creationOpts", "resolution=0"},
           {"creationOpts", "resolution=-0.1"},
           {"creationOpts", "resolution=tiny"},
           {"insertOpts", "maxrange=1,5"},
           {"conversionOpts", "slopeWindow=0"},
           {"conversionOpts", "minOccupancy=2"},
           {"creationOpts", "resolution=1e300"},
           {"creationOpts", "enableSaveAs3DObject=maybe"},
           {"renderOpts", "showCeiling=maybe"},
           {"likelihoodOpts", "LF_decimation=0"},
           {"likelihoodOpts", "LF_decimation=1.5"},
           {"likelihoodOpts", "MI_skip_rays=0"},
           {"likelihoodOpts", "rayTracing_decimation=-3"},
           {"likelihoodOpts", "consensus_takeEachRange=0"},
           {"likelihoodOpts", "LF_stdHit=0"},
           {"likelihoodOpts", "LF_stdHit=1e300"},
           {"likelihoodOpts", "LF_maxRange=1,5"},
           {"likelihoodOpts", "LF_useSquareDist=perhaps"},
           {"likelihoodOpts", "consensus_pow=nan"},
           {"likelihoodOpts", "OWA_weights=0.1 banana"},
           {"likelihoodOpts", "LF_stdHit=banana"},
           {"likelihoodOpts", "LF_stdHit=-1"},
           {"likelihoodOpts", "likelihoodMethod=lmBanana"}})
  {
    const auto key = line.substr(0, line.find('=')), value = line.substr(line.find('=') + 1);
    try
    {
      fromIni("[map_freeSpaceGrid_00_" + section + "]\n" + line + "\n");
      ADD_FAILURE() << line << " is accepted";
    }
    catch (const std::exception& error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("section 'map_freeSpaceGrid_00_" + section + "'"), std::string::npos)
          << message;
      EXPECT_NE(message.find(key), std::string::npos) << message;
      EXPECT_NE(message.find(value.substr(0, 4)), std::string::npos) << message;
    }
  }
}

TEST(CFreeSpaceGridMap2D_ini, CommentsBehindValuesAreNoPartOfThem)
{
  const auto map = std::dynamic_pointer_cast<CFreeSpaceGridMap2D>(
      fromIni("[map_freeSpaceGrid_00_creationOpts]\nenableSaveAs3DObject = true ; shown\n"
              "enableObservationLikelihood = false # not used\n"
              "[map_freeSpaceGrid_00_likelihoodOpts]\nLF_useSquareDist = true ; yes\n"
              "LF_decimation = 3 // every third\nOWA_weights = 0.5, 0.25 ; two\n"));
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->genericMapParams.enableSaveAs3DObject);
  EXPECT_FALSE(map->genericMapParams.enableObservationLikelihood);
  EXPECT_TRUE(map->likelihoodOptions.LF_useSquareDist);
  EXPECT_EQ(map->likelihoodOptions.LF_decimation, 3u);
  ASSERT_EQ(map->likelihoodOptions.OWA_weights.size(), 2u);
  EXPECT_NEAR(map->likelihoodOptions.OWA_weights[1], 0.25, 1e-6);
}

TEST(CFreeSpaceGridMap2D_ini, UnknownKeysAndSectionsAreNamedInAWarning)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  fromIni(
      "[map_freeSpaceGrid_00_insertOpts]\nmaxRange=7\n"
      "[map_freeSpaceGrid_00_conversonOpts]\nrobot=aerial\n");
  const auto said = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("maxRange"), std::string::npos) << said;
  EXPECT_NE(said.find("map_freeSpaceGrid_00_conversonOpts"), std::string::npos) << said;
}
