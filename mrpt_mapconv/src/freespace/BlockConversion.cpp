#include "BlockConversion.h"

#include <mrpt_mapconv/freespace/Evidence.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "SupportRules.h"

namespace mrpt_mapconv::freespace
{
using voxel::kBlockSide;

namespace
{
/** Calls visit(x) for every column of a row's mask. */
template <class Visit>
void forEachInRow(std::uint32_t row, const Visit& visit)
{
  if (row == voxel::kFullRow)
    for (std::int32_t x = 0; x < kBlockSide; ++x) visit(x);
  else
    for (; row; row &= row - 1) visit(__builtin_ctz(row));
}

/** Calls visit(y, row) for every row of a mask that is not empty. */
template <class Visit>
void forEachRow(const voxel::ColumnMask& mask, const Visit& visit)
{
  for (std::int32_t y = 0; y < kBlockSide; ++y)
    if (const std::uint32_t row = mask[static_cast<std::size_t>(y)]; row) visit(y, row);
}

/** The smallest rectangle that holds a mask that is not empty. */
BlockRect boundsOf(const voxel::ColumnMask& mask)
{
  BlockRect rect{0, 0, kBlockSide, 0};
  std::uint32_t any = 0;
  for (std::int32_t y = 0; y < kBlockSide; ++y)
    if (const std::uint32_t row = mask[static_cast<std::size_t>(y)]; row)
    {
      any |= row;
      rect.yBegin = std::min(rect.yBegin, y);
      rect.yEnd = y + 1;
    }
  rect.xBegin = any ? __builtin_ctz(any) : 0;
  rect.xEnd = any ? 32 - __builtin_clz(any) : 0;
  return rect;
}

voxel::ColumnMask operator&(voxel::ColumnMask a, const voxel::ColumnMask& b)
{
  for (std::size_t y = 0; y < a.size(); ++y) a[y] &= b[y];
  return a;
}

voxel::ColumnMask operator|(voxel::ColumnMask a, const voxel::ColumnMask& b)
{
  for (std::size_t y = 0; y < a.size(); ++y) a[y] |= b[y];
  return a;
}

voxel::ColumnMask operator~(voxel::ColumnMask a)
{
  for (auto& row : a) row = ~row;
  return a;
}

bool any(const voxel::ColumnMask& mask)
{
  std::uint32_t rows = 0;
  for (const auto row : mask) rows |= row;
  return rows != 0;
}

std::uint32_t bitIf(bool set, std::int32_t x) { return static_cast<std::uint32_t>(set) << x; }

bool sameBits(float a, float b) { return std::memcmp(&a, &b, sizeof(float)) == 0; }
}  // namespace

void Differences::note(const BlockJob& job, bool blank)
{
  if (any(job.newSpan)) newSpan.emplace(job.key, job.newSpan);
  if (!blank && any(job.newFloor)) newFloor.insert(job.key, job.newFloor);
}

HeightPass::HeightPass(const voxel::VoxelSource& source, const ConversionParams& params,
                       Layers& layers, bool blank)
    : m_source(source),
      m_layers(layers),
      m_blank(blank),
      m_supportIsFloor(params.floorFrom == FloorFrom::LowestFree),
      m_spans(params.minRunVoxels(source.resolution()))
{
}

void HeightPass::run(BlockJob& job)
{
  if (!any(job.changed)) return;
  m_block.start(job.key, job.changed);
  m_source.read(m_block);
  m_spans.start(m_block);
  const voxel::ColumnMask free = writeHeights(job);
  collectWalls(job, free);
}

/** Raw evidence: what is inferred comes later. */
float HeightPass::evidenceOf(std::int32_t column, const FreeSpan& span) const
{
  if (!span.valid()) return hasOccupied(m_block, column) ? evidence::kWall : evidence::kNone;
  return isOccupied(m_block, column, span.floor - 1) ? evidence::kSeen : evidence::kOpen;
}

/** Writes evidence and, where the ground itself was seen, support. Where floor and evidence are as
 * before, both stay, inferred or not. \return whether they are not */
bool HeightPass::writeGround(bool newFloor, float floor, float now, float& known, float& support)
{
  if (!m_blank && !newFloor && now == (evidence::isOpen(known) ? evidence::kOpen : known))
    return false;
  known = now;
  support = now == evidence::kSeen || m_supportIsFloor ? floor : Layers::kNone;
  return true;
}

/** Writes heights and evidence of the changed columns and notes which differ from before. Returns
 * those with a kept free range. */
voxel::ColumnMask HeightPass::writeHeights(BlockJob& job)
{
  const double res = m_layers.frame().resolution;
  const BlockPlace place(job.key, m_layers.frame());
  // to look at what blank layers hold would mean to wait for memory
  const auto replace = [&](float& cell, float value)
  {
    const bool differs = m_blank ? !std::isnan(value) : !sameBits(cell, value);
    cell = value;
    return differs;
  };
  voxel::ColumnMask free{};
  forEachRow(job.changed,
             [&](std::int32_t y, std::uint32_t row)
             {
               float* floor = m_layers.floor.row(place.y + y) + place.x;
               float* ceiling = m_layers.ceiling.row(place.y + y) + place.x;
               float* support = m_layers.support.row(place.y + y) + place.x;
               float* known = m_layers.evidence.row(place.y + y) + place.x;
               std::uint32_t freeRow = 0, newFloor = 0, newSpan = 0;
               forEachInRow(
                   row,
                   [&](std::int32_t x)
                   {
                     const std::int32_t column = y * kBlockSide + x;
                     const FreeSpan span = m_spans.span(column);
                     const bool valid = span.valid();
                     const auto height = [&](std::int32_t key)
                     { return valid ? static_cast<float>(key * res) : Layers::kNone; };
                     freeRow |= bitIf(valid, x);
                     const bool differs = replace(floor[x], height(span.floor));
                     newSpan |= bitIf(differs | replace(ceiling[x], height(span.ceiling)), x);
                     newFloor |= bitIf(writeGround(differs, floor[x], evidenceOf(column, span),
                                                   known[x], support[x]),
                                       x);
                   });
               const auto at = static_cast<std::size_t>(y);
               free[at] = freeRow;
               job.newFloor[at] = newFloor;
               job.newSpan[at] = newSpan;
             });
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
  if (m_block.words() > 0)
    forEachRow(candidates,
               [&](std::int32_t y, std::uint32_t row)
               {
                 forEachInRow(row, [&](std::int32_t x)
                              { appendOccupiedRuns(m_block, y * kBlockSide + x, job.walls); });
               });
}

AerialPass::AerialPass(const voxel::VoxelSource& source, const ConversionParams& params,
                       const Differences& differences, Layers& layers)
    : m_source(source),
      m_params(params),
      m_differences(differences),
      m_layers(layers),
      m_inverseResolution(1.0 / layers.frame().resolution),
      m_floors(1)
{
}

void AerialPass::run(BlockJob& job)
{
  const BlockPlace place(job.key, m_layers.frame());
  const auto besideNew = withoutFloor(columnsBesideNewSpans(job), place);
  const auto newAerial = job.changed | besideNew;
  if (!any(newAerial)) return;

  readWalls(besideNew, job);
  m_floors.load(m_layers.floor, job.key);
  writeAerial(job, newAerial);
  job.walls = std::vector<OccupiedRun>();  // gives the memory back, which clear() would not
}

/** The columns that were not read but touch one whose free range has changed. */
voxel::ColumnMask AerialPass::columnsBesideNewSpans(const BlockJob& job) const
{
  const auto notRead = job.reach & ~job.changed;
  return any(notRead) ? notRead & voxel::columnsNear(m_differences.newSpan, job.key, 1) : notRead;
}

voxel::ColumnMask AerialPass::withoutFloor(const voxel::ColumnMask& columns,
                                           const BlockPlace& place) const
{
  voxel::ColumnMask out{};
  forEachRow(columns,
             [&](std::int32_t y, std::uint32_t row)
             {
               const float* floor = m_layers.floor.row(place.y + y);
               std::uint32_t without = 0;
               forEachInRow(row, [&](std::int32_t x)
                            { without |= bitIf(std::isnan(floor[place.x + x]), x); });
               out[static_cast<std::size_t>(y)] = without;
             });
  return out;
}

/** Reads the occupied runs of columns without a free range. */
void AerialPass::readWalls(const voxel::ColumnMask& columns, BlockJob& job)
{
  if (!any(columns)) return;
  m_block.start(job.key, columns);
  m_source.read(m_block);
  if (m_block.words() == 0) return;
  forEachRow(columns,
             [&](std::int32_t y, std::uint32_t row)
             {
               forEachInRow(row, [&](std::int32_t x)
                            { appendOccupiedRuns(m_block, y * kBlockSide + x, job.walls); });
             });
}

void AerialPass::writeAerial(const BlockJob& job, const voxel::ColumnMask& columns)
{
  const BlockPlace place(job.key, m_layers.frame());
  forEachRow(columns,
             [&](std::int32_t y, std::uint32_t row)
             {
               float* aerial = m_layers.aerial.row(place.y + y);
               const std::int32_t* floor = m_floors.at(0, y);
               forEachInRow(row,
                            [&](std::int32_t x) {
                              aerial[place.x + x] =
                                  floor[x] != FloorTile::kNoFloor ? grid::kFree : grid::kUnknown;
                            });
             });
  for (auto begin = job.walls.data(), last = begin + job.walls.size(); begin != last;)
  {
    auto end = begin;
    while (end != last && end->column == begin->column) ++end;
    const std::int32_t x = begin->column % kBlockSide, y = begin->column / kBlockSide;
    m_layers.aerial.at(place.x + x, place.y + y) = wallOccupancy(place, x, y, begin, end);
    begin = end;
  }
}

/** Eqs. 5–8 for a cell without a kept free range, at column (x, y) of the block: the largest share
 * of a free neighbour's range [floor, ceiling] that this column's occupied runs fill. */
float AerialPass::wallOccupancy(const BlockPlace& place, std::int32_t x, std::int32_t y,
                                const OccupiedRun* begin, const OccupiedRun* end) const
{
  double best = 0;
  bool blocked = false;
  for (std::int32_t ny = y - 1; ny <= y + 1; ++ny)
    for (std::int32_t nx = x - 1; nx <= x + 1; ++nx)
    {
      const std::int32_t floor = *m_floors.at(nx, ny);
      if (floor == FloorTile::kNoFloor) continue;
      const std::int32_t ceiling =
          heightKey(m_layers.ceiling.at(place.x + nx, place.y + ny), m_inverseResolution);
      std::int32_t overlap = 0;
      for (const auto* run = begin; run != end; ++run)
        overlap += std::max(0, std::min(run->end, ceiling) - std::max(run->begin, floor));
      const double height = ceiling - floor;
      const double share = overlap / height;
      if (overlap == 0 || share < best) continue;
      best = share;
      blocked = overlap >= m_params.minOccupancy * height - 1e-9 * height;
    }
  return blocked ? static_cast<float>(best) : grid::kUnknown;
}

GroundPass::GroundPass(const ConversionParams& params, Layers& layers)
    : m_params(params),
      m_layers(layers),
      m_checkSteps(params.looksForSteps()),
      m_maxStep(kSupportUnits * params.maxStepVoxels(layers.frame().resolution)),
      m_drops(params, layers),
      m_supports(params.slopeWindow, kSupportUnits),
      m_floors(1, kSupportUnits),
      m_slopeFilter(params.slopeWindow)
{
}

std::int32_t GroundPass::reach() const
{
  return std::max({1, m_params.slopeWindow, m_drops.isOn() ? m_drops.reach() : 0});
}

void GroundPass::run(voxel::BlockKey block, const voxel::ColumnMask& columns)
{
  if (!any(columns)) return;
  const BlockPlace place(block, m_layers.frame());
  m_supports.load(m_layers.support, block);
  const voxel::ColumnMask supported = columns & withSupport();
  writeUnsupported(place, columns & ~supported);
  if (!any(supported)) return;
  if (m_drops.isOn()) m_floors.load(m_layers.floor, block);
  m_slopeFilter.compute(m_supports, boundsOf(supported), m_slope);
  forEachRow(supported,
             [&](std::int32_t y, std::uint32_t row)
             {
               const double* slopes = m_slope.data() + y * kBlockSide;
               float* slope = m_layers.slope.row(place.y + y) + place.x;
               float* ground = m_layers.ground.row(place.y + y) + place.x;
               forEachInRow(row,
                            [&](std::int32_t x)
                            {
                              const double steepness = slopes[x] / kSupportUnits;
                              slope[x] = static_cast<float>(steepness);
                              const bool blocked = steepness > m_params.maxSlope ||
                                                   (m_checkSteps && hasStepOrDrop(x, y, place));
                              ground[x] = blocked ? 1.0f : grid::kFree;
                            });
             });
}

voxel::ColumnMask GroundPass::withSupport() const
{
  voxel::ColumnMask mask{};
  for (std::int32_t y = 0; y < kBlockSide; ++y)
  {
    const std::int32_t* support = m_supports.at(0, y);
    std::uint32_t row = 0;
    for (std::int32_t x = 0; x < kBlockSide; ++x)
      row |= bitIf(support[x] != FloorTile::kNoFloor, x);
    mask[static_cast<std::size_t>(y)] = row;
  }
  return mask;
}

/** Where no ground is known nobody can stand, however free the air is. */
void GroundPass::writeUnsupported(const BlockPlace& place, const voxel::ColumnMask& columns)
{
  forEachRow(columns,
             [&](std::int32_t y, std::uint32_t row)
             {
               const float* aerial = m_layers.aerial.row(place.y + y) + place.x;
               float* slope = m_layers.slope.row(place.y + y) + place.x;
               float* ground = m_layers.ground.row(place.y + y) + place.x;
               forEachInRow(row,
                            [&](std::int32_t x)
                            {
                              slope[x] = Layers::kNone;
                              ground[x] = grid::isFree(aerial[x]) ? grid::kUnknown : aerial[x];
                            });
             });
}

/** Whether the support differs from one of the 8 neighbours' by more than a step, or is that of a
 * drop edge. */
bool GroundPass::hasStepOrDrop(std::int32_t x, std::int32_t y, const BlockPlace& place) const
{
  const std::int32_t support = *m_supports.at(x, y);
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx)
    {
      const std::int32_t neighbour = *m_supports.at(x + dx, y + dy);
      const bool hasSupport = neighbour != FloorTile::kNoFloor;
      if (hasSupport && std::abs(neighbour - support) > m_maxStep) return true;
      if (!m_drops.isOn() || (dx == 0 && dy == 0)) continue;
      // Most walks end at their first cell, of which the tiles tell enough.
      const std::int32_t floor = *m_floors.at(x + dx, y + dy);
      if (floor == FloorTile::kNoFloor || (hasSupport && support - floor <= m_drops.most()))
        continue;
      if (m_drops.leadsDown(place.x + x, place.y + y, dx, dy, support)) return true;
    }
  return false;
}

}  // namespace mrpt_mapconv::freespace
