#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

namespace mrpt_mapconv::test
{
/** Two levels of 8 x 8 cells of 0.1 m, at z = 0 for the keys x = 0 to 7 and at z = 0.5 for 8 to 15,
 * and a single cell of height 2 at (20, 0). */
inline terrain::TerrainMap twoLevels()
{
  terrain::TerrainMap map(0.1);
  for (std::int32_t ky = 0; ky < 8; ++ky)
    for (std::int32_t kx = 0; kx < 16; ++kx)
      map.insertPoint(0.1 * kx, 0.1 * ky, kx < 8 ? 0 : 0.5, 0.01);
  map.insertPoint(2, 0, 2, 0.01);
  map.update();
  return map;
}
}  // namespace mrpt_mapconv::test
