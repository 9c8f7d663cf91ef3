#include "AerialPass.h"

#include <algorithm>
#include <cmath>

#include "ColumnMasks.h"
#include "FloorTile.h"

namespace mrpt_mapconv::freespace
{
using voxel::kBlockSide;

AerialPass::AerialPass(const voxel::VoxelSource& source, const ConversionParams& params,
                       const voxel::ColumnSet::Blocks& newSpan, Layers& layers, bool blank)
    : m_source(source),
      m_params(params),
      m_newSpan(newSpan),
      m_layers(layers),
      m_blank(blank),
      m_inverseResolution(1.0 / layers.frame().resolution)
{
}

void AerialPass::run(BlockJob& job)
{
  const BlockPlace place(job.key, m_layers.frame());
  const auto besideNew = withoutFloor(columnsBesideNewSpans(job), place);
  const auto columns = job.changed | besideNew;
  if (!any(columns)) return;

  readWalls(besideNew, job);
  findAerial(job, columns);
  writeAerial(columns, job);
  job.walls = std::vector<OccupiedRun>();  // gives the memory back, which clear() would not
}

/** The columns that were not read but touch one whose free range has changed. */
voxel::ColumnMask AerialPass::columnsBesideNewSpans(const BlockJob& job) const
{
  const auto notRead = job.reach & ~job.changed;
  return any(notRead) ? notRead & voxel::columnsNear(m_newSpan, job.key, 1) : notRead;
}

voxel::ColumnMask AerialPass::withoutFloor(const voxel::ColumnMask& columns,
                                           const BlockPlace& place) const
{
  voxel::ColumnMask out{};
  forEachColumn(columns,
                [&](std::int32_t x, std::int32_t y)
                {
                  const float floor = m_layers.floor.at(place.x + x, place.y + y);
                  out[static_cast<std::size_t>(y)] |= bitIf(std::isnan(floor), x);
                });
  return out;
}

/** Reads the occupied runs of columns without a free range. */
void AerialPass::readWalls(const voxel::ColumnMask& columns, BlockJob& job)
{
  if (!any(columns)) return;
  m_block.start(job.key, columns);
  m_source.read(m_block);
  appendOccupiedRuns(m_block, columns, job.walls);
}

/** Finds what m_aerial holds of some columns of the block. */
void AerialPass::findAerial(const BlockJob& job, const voxel::ColumnMask& columns)
{
  const BlockPlace place(job.key, m_layers.frame());
  forEachRow(columns,
             [&](std::int32_t y, std::uint32_t row)
             {
               float* aerial = m_aerial.data() + y * kBlockSide;
               const float* floor = m_layers.floor.row(place.y + y) + place.x;
               forEachInRow(row, [&](std::int32_t x)
                            { aerial[x] = std::isnan(floor[x]) ? grid::kUnknown : grid::kFree; });
             });
  for (auto begin = job.walls.data(), last = begin + job.walls.size(); begin != last;)
  {
    auto end = begin;
    while (end != last && end->column == begin->column) ++end;
    const std::int32_t x = begin->column % kBlockSide, y = begin->column / kBlockSide;
    m_aerial[static_cast<std::size_t>(begin->column)] =
        wallOccupancy(place.x + x, place.y + y, begin, end);
    begin = end;
  }
}

/** Eqs. 5–8 for a cell without a kept free range: the largest share of a free neighbour's range
 * [floor, ceiling] that this cell's occupied runs fill. */
float AerialPass::wallOccupancy(std::int32_t ix, std::int32_t iy, const OccupiedRun* begin,
                                const OccupiedRun* end) const
{
  const grid::GridFrame& frame = m_layers.frame();
  double best = 0;
  bool blocked = false;
  for (std::int32_t y = std::max(iy - 1, 0); y <= std::min(iy + 1, frame.height - 1); ++y)
    for (std::int32_t x = std::max(ix - 1, 0); x <= std::min(ix + 1, frame.width - 1); ++x)
    {
      if (std::isnan(m_layers.floor.at(x, y))) continue;
      const std::int32_t floor = heightKey(m_layers.floor.at(x, y), m_inverseResolution);
      const std::int32_t ceiling = heightKey(m_layers.ceiling.at(x, y), m_inverseResolution);
      std::int32_t overlap = 0;
      for (const auto* run = begin; run != end; ++run)
        overlap += std::max(0, std::min(run->end, ceiling) - std::max(run->begin, floor));
      if (overlap == 0) continue;
      const double height = ceiling - floor;
      const double share = overlap / height;
      if (share < best) continue;
      best = share;
      blocked = overlap >= m_params.minOccupancy * height - 1e-9 * height;
    }
  return blocked ? static_cast<float>(best) : grid::kUnknown;
}

void AerialPass::writeAerial(const voxel::ColumnMask& columns, BlockJob& job)
{
  const BlockPlace place(job.key, m_layers.frame());
  forEachRow(columns,
             [&](std::int32_t y, std::uint32_t row)
             {
               const float* found = m_aerial.data() + y * kBlockSide;
               float* aerial = m_layers.aerial.row(place.y + y) + place.x;
               if (!m_blank)
                 job.newAerial[static_cast<std::size_t>(y)] = differing(row, found, aerial);
               writeRow(row, found, aerial);
             });
}

}  // namespace mrpt_mapconv::freespace
