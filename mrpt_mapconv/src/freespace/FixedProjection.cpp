#include <mrpt/core/format.h>
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/FixedProjection.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../grid/Parallel.h"

namespace mrpt_mapconv::freespace
{
namespace
{
using voxel::kBlockColumns;
using voxel::kBlockSide;

/** The z keys [begin, end) of the voxels that overlap an open interval. */
struct KeyInterval
{
  std::int32_t begin, end;
};

KeyInterval keysWithin(double zMin, double zMax, double resolution)
{
  constexpr double slack =
      1e-6;  // of a voxel: an interval's end on a face takes no voxel beyond it
  // a million lies beyond every key, also those of an infinite height
  const auto toKey = [](double key)
  { return static_cast<std::int32_t>(std::clamp(key, -1e6, 1e6)); };
  return {toKey(std::floor(zMin / resolution + slack)),
          toKey(std::ceil(zMax / resolution - slack))};
}

/** For each column of a block, whether a plane has a voxel in the interval. */
std::array<bool, kBlockColumns> anyWithin(const voxel::ColumnBlock& block,
                                          const std::uint64_t* plane, KeyInterval keys)
{
  std::array<std::uint64_t, kBlockColumns> found{};
  for (std::int32_t w = 0; w < block.words(); ++w)
  {
    const std::int32_t zWord = block.zMin() + 64 * w;
    const std::int32_t begin = std::max(keys.begin - zWord, 0);
    const std::int32_t end = std::min(keys.end - zWord, 64);
    if (begin >= end) continue;
    const std::uint64_t voxels = (~std::uint64_t{0} >> (64 - (end - begin))) << begin;
    const std::uint64_t* words = plane + static_cast<std::ptrdiff_t>(w) * kBlockColumns;
    for (std::size_t c = 0; c < found.size(); ++c) found[c] |= words[c] & voxels;
  }
  std::array<bool, kBlockColumns> any{};
  for (std::size_t c = 0; c < found.size(); ++c) any[c] = found[c] != 0;
  return any;
}

KeyInterval checkedKeys(double zMin, double zMax, double resolution)
{
  params::require(zMin < zMax, "zMin", zMin, "below zMax = " + mrpt::format("%g", zMax));
  return keysWithin(zMin, zMax, resolution);
}

/** Writes the wanted columns of a block that has been read. */
void writeBlock(const voxel::ColumnBlock& block, KeyInterval keys, grid::Layer<float>& layer)
{
  const auto free = anyWithin(block, block.freePlane(), keys);
  const auto occupied = anyWithin(block, block.occupiedPlane(), keys);
  const std::int32_t x0 = block.key().x * kBlockSide - layer.frame().x0;
  const std::int32_t y0 = block.key().y * kBlockSide - layer.frame().y0;
  for (std::int32_t y = 0; y < kBlockSide; ++y)
    for (std::int32_t x = 0; x < kBlockSide; ++x)
    {
      const auto column = static_cast<std::size_t>(y * kBlockSide + x);
      if (block.wanted()[static_cast<std::size_t>(y)] >> x & 1u)
        layer.at(x0 + x, y0 + y) = occupied[column] ? 1.0f
                                   : free[column]   ? grid::kFree
                                                    : grid::kUnknown;
    }
}

void projectColumns(const voxel::VoxelSource& source, const voxel::ColumnSet& columns,
                    KeyInterval keys, grid::Layer<float>& layer, int threads)
{
  const std::vector<voxel::ColumnSet::Blocks::value_type> blocks(columns.blocks().begin(),
                                                                 columns.blocks().end());
  grid::inParallel(blocks.size(), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     voxel::ColumnBlock block;
                     for (std::size_t i = begin; i < end; ++i)
                     {
                       block.start(blocks[i].first, blocks[i].second);
                       source.read(block);
                       writeBlock(block, keys, layer);
                     }
                   });
}
}  // namespace

grid::Layer<float> projectFixed(const voxel::VoxelSource& source, double zMin, double zMax,
                                int threads)
{
  const KeyInterval keys = checkedKeys(zMin, zMax, source.resolution());
  const grid::GridFrame frame = frameOf(source);
  grid::Layer<float> layer(frame, grid::kUnknown);
  projectColumns(source, voxel::ColumnSet::of(frame), keys, layer, threads);
  return layer;
}

void updateFixed(const voxel::VoxelSource& source, const voxel::ColumnSet& changed, double zMin,
                 double zMax, grid::Layer<float>& layer, int threads)
{
  const KeyInterval keys = checkedKeys(zMin, zMax, source.resolution());
  const grid::GridFrame frame = grownFrame(layer.frame(), changed.bounds(source.resolution()));
  if (frame != layer.frame()) layer = layer.onFrame(frame, grid::kUnknown);
  projectColumns(source, changed.clipped(frame), keys, layer, threads);
}

}  // namespace mrpt_mapconv::freespace
