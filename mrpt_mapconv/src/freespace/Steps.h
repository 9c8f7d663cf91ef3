#pragma once

#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <cstdint>

#include "FloorTile.h"

namespace mrpt_mapconv::freespace
{
/** Those of some columns with support that differs from that of one of the 8 neighbours by more
 * than maxStep. \param supports with a halo, in the units of maxStep */
voxel::ColumnMask besideStep(const FloorTile& supports, const voxel::ColumnMask& columns,
                             std::int32_t maxStep);

/** Those of some columns with support from which a DropWalk may lead down: all walks end at their
 * first cell but those to one with a floor that has no support or lies more than `most` below.
 * \param floors with a halo, in the units of the supports and of `most` */
voxel::ColumnMask mayBeDropEdge(const FloorTile& supports, const FloorTile& floors,
                                const voxel::ColumnMask& columns, std::int32_t most);

}  // namespace mrpt_mapconv::freespace
