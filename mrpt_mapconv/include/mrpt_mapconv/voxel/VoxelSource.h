#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>
#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace mrpt_mapconv::voxel
{
/** What is known of a voxel. */
enum class VoxelState : std::uint8_t
{
  Unknown,
  Free,
  Occupied
};

/** A rectangle of column keys, both corners included. */
struct KeyRect
{
  std::int32_t xMin = 0, yMin = 0, xMax = -1, yMax = -1;
};

/** The frame of the cells in a rectangle. */
inline grid::GridFrame frameOf(const KeyRect& rect, double resolution)
{
  return {resolution, rect.xMin, rect.yMin, rect.xMax - rect.xMin + 1, rect.yMax - rect.yMin + 1};
}

/** The one interface through which every voxel map is read.
 *
 * Voxels are addressed by signed integer keys: voxel k covers [k·resolution, (k+1)·resolution) on
 * each axis (an OctoMap key minus 32768). Reading does not change the map, and several threads may
 * read blocks at once.
 */
class VoxelSource
{
 public:
  virtual ~VoxelSource() = default;
  /** Size of the finest voxel [m]. */
  virtual double resolution() const = 0;
  /** The columns' bounding box: all known voxels lie in it; nothing if no voxel is known. */
  virtual std::optional<KeyRect> bounds() const = 0;
  /** Marks all known voxels of the block's wanted columns, after ColumnBlock::start(). */
  virtual void read(ColumnBlock& block) const = 0;
  /** z key of the highest known voxel; nothing if none is known. Reads the whole map, unless the
   * source knows a shorter way. */
  virtual std::optional<std::int32_t> top() const;
};

/** Whether any voxel of a map is free. */
bool hasFreeVoxel(const VoxelSource& source);
/** How many voxels of a map are known. */
std::size_t knownVoxels(const VoxelSource& source);

}  // namespace mrpt_mapconv::voxel
