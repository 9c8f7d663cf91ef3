#pragma once

#include <mrpt_mapconv/voxel/ColumnSet.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

namespace mrpt_mapconv::voxel
{
/** Reads block by block all that is known, until visit(block) says that it has seen enough. */
template <class Visit>
void readBlocks(const VoxelSource& source, const Visit& visit)
{
  const auto box = source.bounds();
  if (!box) return;
  const auto columns = ColumnSet::of(frameOf(*box, source.resolution()));
  ColumnMask all;
  all.fill(kFullRow);
  ColumnBlock block;
  for (const auto& [key, mask] : columns.blocks())
  {
    block.start(key, all);
    source.read(block);
    if (visit(block)) return;
  }
}

}  // namespace mrpt_mapconv::voxel
