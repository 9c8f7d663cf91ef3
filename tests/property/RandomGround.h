#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>

#include "RandomMap.h"

namespace mrpt_mapconv::test
{
/** A map made for the evidence of floors: ground that is flat, tilted, stepped, rough or falls off,
 * of which much was not seen – bands and patches where free space ends above the ground, or of
 * which nothing is known –, with walls, posts and holes. At most 75 × 75 columns of 44 voxels. */
oracle::DenseMap randomGround(Rng& rng, double resolution);

/** What one column is made of. */
enum class ColumnKind
{
  Seen,
  Open,
  Wall,
  None
};
/** Makes a column anew, the free space beginning at voxel `floor` of the map's array. */
void setColumn(Rng& rng, oracle::DenseMap& map, int ix, int iy, ColumnKind kind, int floor);

/** Parameters with floorFrom = seen; gaps and steps from nothing to beyond the map. */
freespace::ConversionParams randomGroundParams(Rng& rng, double resolution);

}  // namespace mrpt_mapconv::test
