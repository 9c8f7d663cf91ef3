#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <cmath>

#include "SlamLog.h"

// Stock pf-localization, from no idea where it is, in each kind of map that it can read.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

namespace
{
/** A plain grid map's cells as occupancy, 0, 1 or unknown. */
grid::Layer<float> cellsOf(const std::string& gridmap)
{
  mrpt::io::CFileGZInputStream file(gridmap);
  mrpt::maps::COccupancyGridMap2D map;
  mrpt::serialization::archiveFrom(file) >> map;
  const double resolution = static_cast<double>(map.getResolution());
  const auto key = [&](float metres)
  { return static_cast<std::int32_t>(std::lround(static_cast<double>(metres) / resolution)); };
  const grid::GridFrame frame{0.1, key(map.getXMin()), key(map.getYMin()),
                              static_cast<std::int32_t>(map.getSizeX()),
                              static_cast<std::int32_t>(map.getSizeY())};
  EXPECT_NEAR(resolution, frame.resolution, 1e-6);
  grid::Layer<float> cells(frame, grid::kUnknown);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const float free = map.getCell(x, y);
      if (free > 0.6f) cells.at(x, y) = 0;
      if (free < 0.4f) cells.at(x, y) = 1;
    }
  return cells;
}

int convert(const SlamLog& log)
{
  return log.run("'" MAPCONV_PROGRAM
                 "' convert scans.simplemap -o maps --resolution 0.1 "
                 "--min-clearance 0.5 --max-slope 0.5 --slope-window 1 --max-step 0.15");
}

int observations2map(const SlamLog& log)
{
  return log.run(withPlugin() + "observations2map " +
                 configFile("freeSpaceGrid/observations2map.ini") + " scans.simplemap out");
}

/** The beginning of the files of the map that the program says it used. */
const std::string kUsedMap = "LOG_PF_000_0040000/map_mrpt_mapconv__CFreeSpaceGridMap2D_00";

/** \return the exit status */
int localize(const SlamLog& log, const std::string& ini, const std::string& rawlog)
{
  std::filesystem::remove_all(log.file("LOG_PF_000_0040000"));
  return log.run(withPlugin() + "pf-localization " + configFile(ini) + " " + rawlog);
}

void expectToFindItself(const SlamLog& log, const std::string& ini)
{
  for (const char* rawlog : {"scans.rawlog", "frames.rawlog"})
  {
    ASSERT_EQ(localize(log, ini, rawlog), 0) << log.said();
    log.expectRight(kUsedMap + "_layers.tif", false);
    EXPECT_LT(log.errorOfEstimate(), 0.3) << rawlog << log.said();
  }
}

/** MRPT's words for a map in which the robot can be nowhere. */
void expectNoFreeCells(const SlamLog& log, const std::string& ini)
{
  EXPECT_NE(localize(log, ini, "frames.rawlog"), 0);
  EXPECT_NE(log.said().find("Assert condition failed: nFreeCells"), std::string::npos)
      << log.said();
  EXPECT_EQ(log.errorOfEstimate(), SlamLog::kFarOff);
}

void expectUnknown(const SlamLog& log, const std::string& layersTif)
{
  const auto ground = grid::readGeoTiffBand(log.file(layersTif), "ground");
  ASSERT_FALSE(ground.cells().empty());
  for (const float cell : ground.cells())
    ASSERT_FALSE(grid::isFree(cell) || grid::isOccupied(cell)) << layersTif << ' ' << cell;
}
}  // namespace

TEST(PfLocalization, FindsItselfInAPlainGridMapWithoutThePlugin)
{
  const SlamLog log;
  ASSERT_EQ(convert(log), 0) << log.said();
  std::filesystem::copy(log.file("maps/ground.gridmap"), log.file("map.gridmap"));
  log.expectRight(cellsOf(log.file("map.gridmap")), "ground.gridmap");
  for (const char* rawlog : {"scans.rawlog", "frames.rawlog"})
  {
    const std::string ini = configFile("freeSpaceGrid/pf-localization-gridmap.ini");
    ASSERT_EQ(log.run("pf-localization " + ini + " " + rawlog), 0) << log.said();
    EXPECT_LT(log.errorOfEstimate(), 0.3) << rawlog << log.said();
  }
}

TEST(PfLocalization, FindsItselfInTheMapOfObservations2map)
{
  const SlamLog log;
  ASSERT_EQ(observations2map(log), 0) << log.said();
  expectToFindItself(log, "freeSpaceGrid/pf-localization.ini");
}

TEST(PfLocalization, FindsItselfInTheMapOfASimpleMap)
{
  expectToFindItself(SlamLog(), "freeSpaceGrid/pf-localization-simplemap.ini");
}

/** The 2D scans alone are one voxel high: voxels are known, but nothing is free. */
TEST(PfLocalization, HasAnUnknownMapWithoutThe3DScans)
{
  SlamLog log;
  log.remove3D();
  ASSERT_EQ(convert(log), 0) << log.said();
  EXPECT_NE(log.said().find("aerial       0 free (0.0 %), 0 occupied (0.0 %)"), std::string::npos)
      << log.said();
  expectUnknown(log, "maps/layers.tif");

  ASSERT_EQ(observations2map(log), 0) << log.said();
  EXPECT_NE(log.said().find("no free range is minClearance = 0.5 m high"), std::string::npos)
      << log.said();
  expectUnknown(log, "out_mrpt_mapconv__CFreeSpaceGridMap2D_00_layers.tif");

  expectNoFreeCells(log, "freeSpaceGrid/pf-localization.ini");
  expectUnknown(log, kUsedMap + "_layers.tif");
  expectNoFreeCells(log, "freeSpaceGrid/pf-localization-simplemap.ini");
  EXPECT_TRUE(isUniform(log.file(kUsedMap + ".png")));
  EXPECT_FALSE(std::filesystem::exists(log.file(kUsedMap + "_layers.tif")));
}

/** A file of one class does not load into a map of the other. */
TEST(PfLocalization, RefusesAMapOfTheOtherClass)
{
  const SlamLog log;
  const auto expectSaid = [&](const std::string& text)
  { EXPECT_NE(log.said().find(text), std::string::npos) << log.said(); };
  ASSERT_EQ(convert(log), 0) << log.said();
  std::filesystem::copy(log.file("maps/ground.gridmap"), log.file("out_gridmap_no00.gridmap"));
  EXPECT_NE(log.run(withPlugin() + "pf-localization " +
                    configFile("freeSpaceGrid/pf-localization.ini") + " frames.rawlog"),
            0);
  expectSaid("Stored class does not match with existing object");
  ASSERT_EQ(observations2map(log), 0) << log.said();
  std::filesystem::copy(log.file("out_gridmap_no00.gridmap"), log.file("map.gridmap"));
  EXPECT_NE(log.run("pf-localization " + configFile("freeSpaceGrid/pf-localization-gridmap.ini") +
                    " frames.rawlog"),
            0);
  expectSaid("'mrpt_mapconv::CFreeSpaceGridMap2D' which is not registered");
}
