#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace mrpt_mapconv::freespace
{
/** The voxel key of a height that is a whole number of voxels (not NaN), or a whole number of
 * smaller units: float32 holds 24 bits, keys need 17 and 64ths of voxels 23, so this gets back
 * exactly the number that the height was made of. */
inline std::int32_t heightKey(float metres, double unitsPerMetre)
{
  constexpr double up = 4194304;  // makes the number positive, so that the cast rounds down
  return static_cast<std::int32_t>(static_cast<double>(metres) * unitsPerMetre + (up + 0.5)) -
         static_cast<std::int32_t>(up);
}

/** Heights of a block and of `halo` cells around it, in whole units. */
class FloorTile
{
 public:
  static constexpr std::int32_t kNoFloor = std::numeric_limits<std::int32_t>::min();

  /** \param units in a voxel */
  explicit FloorTile(std::int32_t halo, std::int32_t units = 1)
      : m_halo(halo),
        m_units(units),
        m_side(voxel::kBlockSide + 2 * halo),
        m_keys(static_cast<std::size_t>(m_side) * static_cast<std::size_t>(m_side))
  {
  }

  /** Reads the cells around a block; those outside the layer, and NaN, have no floor. */
  void load(const grid::Layer<float>& heights, voxel::BlockKey block);

  std::int32_t halo() const { return m_halo; }
  std::int32_t side() const { return m_side; }
  /** Floors from cell (x, y) on, counted from the block's first cell: −halo … 31 + halo. */
  const std::int32_t* at(std::int32_t x, std::int32_t y) const
  {
    return m_keys.data() + (y + m_halo) * m_side + x + m_halo;
  }

 private:
  std::int32_t m_halo, m_units, m_side;
  std::vector<std::int32_t> m_keys;
};

}  // namespace mrpt_mapconv::freespace
