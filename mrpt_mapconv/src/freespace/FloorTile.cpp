#include "FloorTile.h"

#include <algorithm>

namespace mrpt_mapconv::freespace
{
void FloorTile::load(const grid::Layer<float>& heights, voxel::BlockKey block)
{
  const grid::GridFrame& frame = heights.frame();
  const double inverse = m_units * (1.0 / frame.resolution);
  const std::int32_t xTile = block.x * voxel::kBlockSide - m_halo;  // key of the tile's first cell
  const std::int32_t yTile = block.y * voxel::kBlockSide - m_halo;
  const std::int32_t xBegin = std::max(xTile, frame.x0);
  const std::int32_t xEnd = std::min(xTile + m_side, frame.xEnd());
  for (std::int32_t y = 0; y < m_side; ++y)
  {
    std::int32_t* to = m_keys.data() + y * m_side;
    const std::int32_t ky = yTile + y;
    if (ky < frame.y0 || ky >= frame.yEnd() || xBegin >= xEnd)
    {
      std::fill_n(to, m_side, kNoFloor);
      continue;
    }
    std::fill_n(to, xBegin - xTile, kNoFloor);
    std::fill(to + (xEnd - xTile), to + m_side, kNoFloor);
    const float* from = heights.row(ky - frame.y0) + (xBegin - frame.x0);
    to += xBegin - xTile;
    for (std::int32_t i = 0; i < xEnd - xBegin; ++i)
    {
      // a number in any case: only then the compiler may convert cells as a vector
      const bool has = from[i] == from[i];
      const std::int32_t key = heightKey(has ? from[i] : 0.0f, inverse);
      to[i] = has ? key : kNoFloor;
    }
  }
}

}  // namespace mrpt_mapconv::freespace
