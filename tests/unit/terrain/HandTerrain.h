#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <functional>
#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
constexpr double kCell = 0.05;  // [m]

/** Puts a point into the middle of a cell. */
inline void put(terrain::TerrainMap& map, int kx, int ky, double z)
{
  map.insertPoint(kx * map.resolution(), ky * map.resolution(), z, 0.01);
}

/** A rectangle of cells, both corners included, of which heightAt gives the heights [m]. */
inline void putAll(terrain::TerrainMap& map, int xMin, int yMin, int xMax, int yMax,
                   const std::function<double(int, int)>& heightAt)
{
  for (int y = yMin; y <= yMax; ++y)
    for (int x = xMin; x <= xMax; ++x) put(map, x, y, heightAt(x, y));
}
inline void putAll(terrain::TerrainMap& map, int xMin, int yMin, int xMax, int yMax, double z)
{
  putAll(map, xMin, yMin, xMax, yMax, [z](int, int) { return z; });
}

/** The plane of the cell of that key; −2 if it is not known. */
inline int planeAt(const terrain::TerrainMap& map, int kx, int ky)
{
  const auto point = map.at(kx * map.resolution(), ky * map.resolution());
  return point ? point->plane : -2;
}

/** Points of a scan whose sensor and robot are in the map's origin, if nothing else is said. */
struct HandScan
{
  std::vector<float> x, y, z;
  mrpt::poses::CPose3D sensorPose, robotPose;

  void add(double px, double py, double pz)
  {
    x.push_back(static_cast<float>(px));
    y.push_back(static_cast<float>(py));
    z.push_back(static_cast<float>(pz));
  }
  terrain::TerrainScan scan() const
  {
    terrain::TerrainScan scan;
    scan.x = x.data();
    scan.y = y.data();
    scan.z = z.data();
    scan.points = x.size();
    scan.sensorPose = sensorPose;
    scan.robotPose = robotPose;
    return scan;
  }
};

}  // namespace mrpt_mapconv::test
