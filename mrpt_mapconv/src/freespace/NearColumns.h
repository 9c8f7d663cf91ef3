#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>

#include <cstdint>

namespace mrpt_mapconv::freespace
{
/** The columns of one block within Chebyshev distance `radius` of a column in `set`: what
 * ColumnSet::dilated() holds of that block, for who needs it block by block. */
voxel::ColumnMask columnsNear(const voxel::ColumnSet::Blocks& set, voxel::BlockKey block,
                              std::int32_t radius);

}  // namespace mrpt_mapconv::freespace
