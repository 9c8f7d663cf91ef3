#include "InferredObstacles.h"

#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>

#include "../path/ColumnMarks.h"
#include "../path/VoxelLookup.h"

namespace mrpt_mapconv::planning
{
namespace
{
/** Calls visit(kx, ky) for the frame's cells, block by block: so are voxel maps read. */
template <class Visit>
void forEachByBlocks(const grid::GridFrame& frame, const Visit& visit)
{
  using path::blockOf;
  using voxel::kBlockSide;
  for (std::int32_t by = blockOf(frame.y0); by <= blockOf(frame.yEnd() - 1); ++by)
    for (std::int32_t bx = blockOf(frame.x0); bx <= blockOf(frame.xEnd() - 1); ++bx)
      for (std::int32_t ky = std::max(by * kBlockSide, frame.y0);
           ky < std::min((by + 1) * kBlockSide, frame.yEnd()); ++ky)
        for (std::int32_t kx = std::max(bx * kBlockSide, frame.x0);
             kx < std::min((bx + 1) * kBlockSide, frame.xEnd()); ++kx)
          visit(kx, ky);
}
}  // namespace

grid::Layer<float> withInferredObstacles(const freespace::Layers& layers,
                                         const freespace::ConversionParams& conversion,
                                         const voxel::VoxelSource& voxels)
{
  const grid::GridFrame& frame = layers.frame();
  const path::HeightRange body =
      path::groundBody({conversion, frame.resolution}, conversion.minClearance);
  grid::Layer<float> occupancy = layers.ground;
  path::VoxelLookup lookup(voxels);
  const auto look = [&](std::int32_t kx, std::int32_t ky)
  {
    const std::size_t cell = frame.indexOfKey(kx, ky);
    float& here = occupancy.cells()[cell];
    if (layers.evidence.cells()[cell] != freespace::evidence::kInferred || !grid::isFree(here))
      return;
    const auto support = static_cast<double>(layers.support.cells()[cell]);
    const auto floor = static_cast<double>(layers.floor.cells()[cell]);
    // most are neither: from a floor on that is lower than what it climbs all is free for it
    const bool mayHide = floor > support + body.low, mayHang = floor < support;
    if ((mayHide || mayHang) && lookup.lowestOccupied(kx, ky, body + support)) here = 1.0f;
  };
  if (!body.empty()) forEachByBlocks(frame, look);
  return occupancy;
}

}  // namespace mrpt_mapconv::planning
