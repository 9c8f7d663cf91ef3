#pragma once

#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/maps/CTerrainGridMap2D.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

/** The maps of which tests/stored_streams holds streams. They are small enough to be worked out by
 * hand, and none of their options has its default, so that one which a stream loses shows. */
namespace mrpt_mapconv::fixtures
{
/** Three scans in voxels of 0.5 m, from a sensor at (0.25, 0.25, 1.75) on a robot at (0, 0, 0),
 * (0.5, 0, 0) and (0, 0.5, 0.5). Each sees the floor straight below it at voxel z = 0, the ceiling
 * straight above it at z = 5, a point 1 m ahead, one 2 m behind and one 8 m to the left, of whose
 * beam maxrange = 4 m are left; the last scan all of it one voxel higher. */
CFreeSpaceGridMap2D storedFreeSpaceMap();

/** Three scans in cells of 0.25 m, from a sensor at (0.125, 0.125, 1) on a robot at x = 0, 0.25 and
 * 0.5, with lines along ±x and ±y only. They see points in cells (8, 0) and, behind it, (12, 0);
 * (0, 6); (−6, 0). */
CScanShapeGridMap2D storedScanShapeMap();

/** Two scans in cells of 0.25 m, from a sensor at (0, 0, 1) on a robot at x = 0 and 0.25, of 8 x 4
 * points in the middle of cells, those of the farther four columns 0.5 m higher. */
CTerrainGridMap2D storedTerrainMap();

/** A file of tests/stored_streams, and how its object is made. */
struct StoredStream
{
  std::string file;
  std::function<std::shared_ptr<mrpt::serialization::CSerializable>()> make;
};
const std::vector<StoredStream>& storedStreams();

/** Expect in a map that was read what the functions above put into it. */
void expectStoredFreeSpaceOptions(const CFreeSpaceGridMap2D& map);
void expectStoredFreeSpaceCells(const CFreeSpaceGridMap2D& map);
void expectStoredScanShapeOptions(const CScanShapeGridMap2D& map);
void expectStoredScanShapeCells(const CScanShapeGridMap2D& map);
void expectStoredTerrainOptions(const CTerrainGridMap2D& map);
void expectStoredTerrainCells(const CTerrainGridMap2D& map);

/** Gives every option of MRPT's own grid a value that is not its default … */
void setGridOptions(mrpt::maps::COccupancyGridMap2D& map);
/** … and expects those. */
void expectGridOptions(const mrpt::maps::COccupancyGridMap2D& map);

}  // namespace mrpt_mapconv::fixtures
