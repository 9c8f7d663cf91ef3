#include "HeightPass.h"

#include <mrpt_mapconv/freespace/Evidence.h>

#include "SupportRules.h"

namespace mrpt_mapconv::freespace
{
using voxel::kBlockSide;

HeightPass::HeightPass(const voxel::VoxelSource& source, const ConversionParams& params,
                       const OpenColumns& open, Layers& layers, bool blank)
    : m_source(source),
      m_open(open),
      m_layers(layers),
      m_blank(blank),
      m_supportIsFloor(params.floorFrom == FloorFrom::LowestFree),
      m_reachAbove(SupportRules(params, source.resolution()).reachAbove()),
      m_spans(params.minRunVoxels(source.resolution()))
{
}

void HeightPass::run(BlockJob& job)
{
  if (!any(job.changed)) return;
  job.open.clear();
  m_block.start(job.key, job.changed);
  m_source.read(m_block);
  m_spans.start(m_block);
  const voxel::ColumnMask free = writeHeights(job);
  collectWalls(job, free);
}

/** Finds what m_row holds of some columns. */
void HeightPass::findRow(std::int32_t y, std::uint32_t columns)
{
  const double res = m_layers.frame().resolution;
  const auto height = [&](std::int32_t key) { return static_cast<float>(key * res); };
  m_row.free = columns & m_spans.columnsWithSpan(y);
  for (RowValues* heights : {&m_row.floor, &m_row.ceiling, &m_row.support})
    heights->fill(Layers::kNone);
  m_row.evidence.fill(evidence::kNone);
  forEachInRow(columnsWithOccupied(m_block, y) & ~m_row.free, [&](std::int32_t x)
               { m_row.evidence[static_cast<std::size_t>(x)] = evidence::kWall; });
  forEachInRow(m_row.free,
               [&](std::int32_t x)
               {
                 const auto i = static_cast<std::size_t>(x);
                 const std::int32_t column = y * kBlockSide + x;
                 const FreeSpan span = m_spans.span(column);
                 const bool seen = isOccupied(m_block, column, span.floor - 1);
                 m_row.floor[i] = height(span.floor);
                 m_row.ceiling[i] = height(span.ceiling);
                 m_row.evidence[i] = seen ? evidence::kSeen : evidence::kOpen;
                 if (seen || m_supportIsFloor) m_row.support[i] = m_row.floor[i];
               });
}

/** What is known to be occupied near the floor of an open column. */
OpenColumn HeightPass::openColumn(std::int32_t column, std::int32_t floor) const
{
  OpenColumn open{static_cast<std::uint16_t>(column)};
  if (const auto top = occupiedTopBelow(m_block, column, floor))
    open.under = static_cast<std::uint16_t>(floor - *top);
  if (const auto bottom = occupiedBottomWithin(m_block, column, floor, floor + m_reachAbove))
    open.above = static_cast<std::uint16_t>(*bottom - floor);
  return open;
}

/** Finds what is in the open columns of a row.
 * \return the columns where that differs from before */
std::uint32_t HeightPass::findOpen(std::int32_t y, BlockJob& job) const
{
  std::uint32_t different = 0;
  forEachInRow(m_row.free,
               [&](std::int32_t x)
               {
                 if (m_row.evidence[static_cast<std::size_t>(x)] != evidence::kOpen) return;
                 const std::int32_t column = y * kBlockSide + x;
                 const OpenColumn now = openColumn(column, m_spans.span(column).floor);
                 if (!now.isEmpty()) job.open.push_back(now);
                 if (m_blank) return;
                 const auto before = m_open.at(job.key, column);
                 different |= bitIf(before ? !(*before == now) : !now.isEmpty(), x);
               });
  return different;
}

/** Writes heights and evidence of the changed columns, and support where the ground itself was
 * seen. Where floor, evidence and what is near it are as before, all stay, inferred or not. Returns
 * the columns with a kept free range. */
voxel::ColumnMask HeightPass::writeHeights(BlockJob& job)
{
  const BlockPlace place(job.key, m_layers.frame());
  voxel::ColumnMask free{};
  const auto writeHeightsOf = [&](std::int32_t y, std::uint32_t row)
  {
    const auto at = static_cast<std::size_t>(y);
    const auto cells = [&](grid::Layer<float>& layer) { return layer.row(place.y + y) + place.x; };
    float *floor = cells(m_layers.floor), *ceiling = cells(m_layers.ceiling);
    float *support = cells(m_layers.support), *known = cells(m_layers.evidence);
    findRow(y, row);
    free[at] = m_row.free;
    const std::uint32_t newOpen = m_supportIsFloor ? 0 : findOpen(y, job);
    std::uint32_t newGround = row;
    if (!m_blank)  // to look at what blank layers hold would mean to wait for memory
    {
      const std::uint32_t newFloor = differing(row, m_row.floor.data(), floor);
      newGround = newFloor | newOpen;
      forEachInRow(row & ~newFloor,
                   [&](std::int32_t x)
                   {
                     const float before = evidence::isOpen(known[x]) ? evidence::kOpen : known[x];
                     const float now = m_row.evidence[static_cast<std::size_t>(x)];
                     newGround |= bitIf(now != before, x);
                   });
      job.newGround[at] = newGround;
      job.newSpan[at] = newFloor | differing(row, m_row.ceiling.data(), ceiling);
    }
    writeRow(row, m_row.floor.data(), floor);
    writeRow(row, m_row.ceiling.data(), ceiling);
    writeRow(newGround, m_row.support.data(), support);
    writeRow(newGround, m_row.evidence.data(), known);
  };
  forEachRow(job.changed, writeHeightsOf);
  return free;
}

/** Keeps the occupied runs of the columns that may have a free neighbour: one is seen in the block,
 * or the neighbour was not read. All others are unknown whatever they hold. */
void HeightPass::collectWalls(BlockJob& job, const voxel::ColumnMask& free)
{
  constexpr std::uint32_t rim = 0x80000001u;  // their neighbours lie in other blocks
  const auto maybeFree = [&](std::size_t y) { return free[y] | ~job.changed[y]; };
  voxel::ColumnMask candidates{};
  for (std::size_t y = 0; y < candidates.size(); ++y)
  {
    const bool first = y == 0, last = y + 1 == candidates.size();
    std::uint32_t near = voxel::kFullRow;
    if (!first && !last)
    {
      const std::uint32_t rows = maybeFree(y - 1) | maybeFree(y) | maybeFree(y + 1);
      near = rim | rows | rows << 1 | rows >> 1;
    }
    candidates[y] = job.changed[y] & ~free[y] & near;
  }
  job.walls.clear();
  appendOccupiedRuns(m_block, candidates, job.walls);
}

}  // namespace mrpt_mapconv::freespace
