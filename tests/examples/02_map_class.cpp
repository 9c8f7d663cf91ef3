// Example 2: one of our map classes in your own program.
//
// CFreeSpaceGridMap2D is an MRPT metric map like any other: an ini text says that there shall be
// one, CMultiMetricMap makes it, observations go in, and whoever asks for a COccupancyGridMap2D
// gets it. The example inserts two scans of a room, asks the grid some questions, saves it, loads
// it again, and ends with 1 if an answer is wrong.
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
// Sections and keys are those of MRPT's own programs; here the prefix is "map".
const char* const kIni = R"(
[map]
freeSpaceGrid_count = 1

[map_freeSpaceGrid_00_creationOpts]
resolution = 0.1        // [m] size of voxels and cells

[map_freeSpaceGrid_00_conversionOpts]
robot        = ground   // or aerial: which layer the grid shows
minClearance = 0.8      // [m] height that the robot needs
maxStep      = 0.2      // [m] highest step that it drives over
)";

/** What a lidar at (x, 0, 1) sees of a room: floor at z = 0, walls at x and y = ±3 m, and a shelf
 * board from x = 2 m on at z = 0.5 m, which a 2D scanner at the robot's feet would look under. */
mrpt::obs::CObservationPointCloud roomScan(double x)
{
  auto cloud = mrpt::maps::CSimplePointsMap::Create();
  for (int azimuth = 0; azimuth < 720; ++azimuth)
    for (int elevation = -120; elevation < 40; ++elevation)
    {
      const double a = azimuth * M_PI / 360, e = elevation * M_PI / 360;
      const double dx = std::cos(e) * std::cos(a), dy = std::cos(e) * std::sin(a), dz = std::sin(e);
      double range = std::min((dx > 0 ? 3 - x : 3 + x) / std::abs(dx), 3 / std::abs(dy));
      if (dz < 0) range = std::min(range, -1 / dz);
      const double toBoard = -0.5 / dz;
      if (dz < 0 && x + toBoard * dx > 2) range = std::min(range, toBoard);
      cloud->insertPoint(static_cast<float>(range * dx), static_cast<float>(range * dy),
                         static_cast<float>(range * dz));
    }
  mrpt::obs::CObservationPointCloud scan;
  scan.sensorLabel = "lidar";
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, 1);  // 1 m above the robot's base
  scan.pointcloud = cloud;
  return scan;
}
}  // namespace

int main()
{
  // A program that is linked to the library has its classes registered; a stock MRPT program gets
  // them by `mapconv run -- PROGRAM` instead. From here on nothing names our class …
  mrpt::config::CConfigFileMemory ini(kIni);
  mrpt::maps::TSetOfMetricMapInitializers wanted;
  wanted.loadFromConfigFile(ini, "map");
  mrpt::maps::CMultiMetricMap maps(wanted);

  for (const double x : {0.0, 0.3})
  {
    const mrpt::poses::CPose3D robot(x, 0, 0);
    maps.insertObservation(roomScan(x), robot);
  }

  const auto grid = maps.mapByClass<mrpt::maps::COccupancyGridMap2D>();
  const bool freeFloor = grid->getPos(1, 1) > 0.9f;
  const bool boardBlocks = grid->getPos(2.05f, 1) < 0.5f;  // its edge
  const bool unknownBeyond = grid->getPos(3.5f, 0) == 0.5f;
  std::cout << "free floor: " << freeFloor << ", the board blocks: " << boardBlocks
            << ", unknown beyond the wall: " << unknownBeyond << '\n';

  // … which has more to tell than a grid does.
  const auto map = maps.mapByClass<mrpt_mapconv::CFreeSpaceGridMap2D>();
  const auto& floor = map->layers().floor;
  std::cout << map->asString() << "\n"
            << floor.frame().width << " x " << floor.frame().height << " cells with floor heights, "
            << map->octree().getNumLeafNodes() << " voxels\n";

  // All layers as GeoTIFF and pictures, the grid as MRPT saves it, the octree …
  map->saveMetricMapRepresentationToFile("room");
  // … and the map itself, to go on with later.
  {
    mrpt::io::CFileGZOutputStream file("room.gridmap");
    auto out = mrpt::serialization::archiveFrom(file);
    out << *map;
  }
  mrpt_mapconv::CFreeSpaceGridMap2D loaded;
  mrpt::io::CFileGZInputStream file("room.gridmap");
  auto in = mrpt::serialization::archiveFrom(file);
  in >> loaded;
  const bool sameMap =
      loaded.getRawMap() == map->getRawMap() && loaded.conversionOptions().params.maxStep == 0.2;

  const bool right = freeFloor && boardBlocks && unknownBeyond && sameMap;
  if (!right) std::cerr << "that is not what the room looks like\n";
  return right ? 0 : 1;
}
