#include "GroundPass.h"

#include <algorithm>

#include "ColumnMasks.h"
#include "Steps.h"
#include "SupportRules.h"

namespace mrpt_mapconv::freespace
{
using voxel::kBlockSide;

namespace
{
/** The smallest rectangle that holds a mask that is not empty. */
BlockRect boundsOf(const voxel::ColumnMask& mask)
{
  BlockRect rect{0, 0, kBlockSide, 0};
  std::uint32_t any = 0;
  forEachRow(mask,
             [&](std::int32_t y, std::uint32_t row)
             {
               any |= row;
               rect.yBegin = std::min(rect.yBegin, y);
               rect.yEnd = y + 1;
             });
  rect.xBegin = any ? __builtin_ctz(any) : 0;
  rect.xEnd = any ? 32 - __builtin_clz(any) : 0;
  return rect;
}
}  // namespace

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
  writeUnsupported(place, columns, supported);
  if (!any(supported)) return;
  m_slopeFilter.compute(m_supports, boundsOf(supported), m_slope);
  writeSupported(place, supported, stepsOrDrops(block, supported));
}

voxel::ColumnMask GroundPass::withSupport() const
{
  voxel::ColumnMask mask{};
  for (std::int32_t y = 0; y < kBlockSide; ++y)
  {
    const std::int32_t* support = m_supports.at(0, y);
    mask[static_cast<std::size_t>(y)] =
        rowWhere([&](std::int32_t x) { return support[x] != FloorTile::kNoFloor; });
  }
  return mask;
}

/** Where no ground is known nobody can stand, however free the air is. Writes all columns of a row
 * with such a cell, since whole rows are vectors; supported cells are to be written after it. */
void GroundPass::writeUnsupported(const BlockPlace& place, const voxel::ColumnMask& columns,
                                  const voxel::ColumnMask& supported)
{
  const auto writeRow = [&](std::int32_t y, std::uint32_t row)
  {
    if (row == supported[static_cast<std::size_t>(y)]) return;
    const float* aerial = m_layers.aerial.row(place.y + y) + place.x;
    float* slope = m_layers.slope.row(place.y + y) + place.x;
    float* ground = m_layers.ground.row(place.y + y) + place.x;
    forEachInRow(row,
                 [&](std::int32_t x)
                 {
                   slope[x] = Layers::kNone;
                   ground[x] = grid::isFree(aerial[x]) ? grid::kUnknown : aerial[x];
                 });
  };
  forEachRow(columns, writeRow);
}

void GroundPass::writeSupported(const BlockPlace& place, const voxel::ColumnMask& columns,
                                const voxel::ColumnMask& blocked)
{
  forEachRow(columns,
             [&](std::int32_t y, std::uint32_t row)
             {
               const double* slopes = m_slope.data() + y * kBlockSide;
               const std::uint32_t blockedRow = blocked[static_cast<std::size_t>(y)];
               float* slope = m_layers.slope.row(place.y + y) + place.x;
               float* ground = m_layers.ground.row(place.y + y) + place.x;
               forEachInRow(row,
                            [&](std::int32_t x)
                            {
                              const double steepness = slopes[x] / kSupportUnits;
                              slope[x] = static_cast<float>(steepness);
                              const bool steep = steepness > m_params.maxSlope;
                              ground[x] = steep || blockedRow >> x & 1u ? 1.0f : grid::kFree;
                            });
             });
}

/** The columns, of some with support, whose support differs from one of the 8 neighbours' by more
 * than a step, or is that of a drop edge. */
voxel::ColumnMask GroundPass::stepsOrDrops(voxel::BlockKey block, const voxel::ColumnMask& columns)
{
  if (!m_checkSteps) return {};
  voxel::ColumnMask out = besideStep(m_supports, columns, m_maxStep);
  if (!m_drops.isOn()) return out;
  const BlockPlace place(block, m_layers.frame());
  m_floors.load(m_layers.floor, block);
  forEachColumn(
      mayBeDropEdge(m_supports, m_floors, columns & ~out, m_drops.most()),
      [&](std::int32_t x, std::int32_t y)
      { out[static_cast<std::size_t>(y)] |= bitIf(m_drops.isEdge(place.x + x, place.y + y), x); });
  return out;
}

}  // namespace mrpt_mapconv::freespace
