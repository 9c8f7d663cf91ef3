#pragma once

#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <map>
#include <string>
#include <tuple>

namespace mrpt_mapconv::test
{
/** All that a grid holds, and how: equal for two grids that are equal bit for bit, down to which
 * bricks are kept as one value. */
inline std::string bytesOf(const voxel::VoxelGrid& grid)
{
  const auto append = [](std::string& bytes, const auto& value)
  { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  std::map<std::tuple<int, int, int>, std::string> regions;
  for (const auto& [key, region] : grid.table().regions())
  {
    std::string& bytes = regions[{key.x, key.y, key.z}];
    append(bytes, key);
    for (const auto& slot : *region)
    {
      bytes += slot.brick ? 'B' : 'V';
      if (slot.brick)
        append(bytes, slot.brick->logOdds);
      else
        append(bytes, slot.value);
    }
  }
  std::string all;
  append(all, grid.resolution());
  append(all, grid.occupiedFrom());
  for (const auto& [key, bytes] : regions) all += bytes;
  return all;
}

}  // namespace mrpt_mapconv::test
