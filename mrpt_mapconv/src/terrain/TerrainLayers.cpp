#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <cmath>
#include <limits>

#include "TerrainMapImpl.h"

namespace mrpt_mapconv::terrain
{
namespace
{
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/** Occupied if the ground is too steep, or a neighbour too high or too low. */
grid::Layer<float> traversabilityOf(const TerrainLayers& layers, const TerrainParams& params)
{
  const grid::GridFrame& frame = layers.height.frame();
  grid::Layer<float> out(frame, grid::kUnknown);
  const auto isStep = [&](std::int32_t x, std::int32_t y, float height)
  {
    for (std::int32_t ny = std::max(0, y - 1); ny <= std::min(frame.height - 1, y + 1); ++ny)
      for (std::int32_t nx = std::max(0, x - 1); nx <= std::min(frame.width - 1, x + 1); ++nx)
        if (std::fabs(static_cast<double>(layers.height.at(nx, ny)) - static_cast<double>(height)) >
            params.maxStep)
          return true;
    return false;
  };
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const float height = layers.height.at(x, y);
      if (std::isnan(height)) continue;
      const bool isSteep = static_cast<double>(layers.slope.at(x, y)) > params.maxSlope;
      out.at(x, y) = isSteep || isStep(x, y, height) ? 1.0f : grid::kFree;
    }
  return out;
}
}  // namespace

TerrainLayers TerrainMap::layers() const
{
  const grid::GridFrame all = frame();
  TerrainLayers layers;
  for (auto* layer :
       {&layers.height, &layers.sigma, &layers.plane, &layers.leafSide, &layers.slope})
    *layer = grid::Layer<float>(all, kNaN);
  for (const Tile* tile : m_impl->tiles.sorted())
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(tile->known[static_cast<std::size_t>(iy)],
                 [&](std::int32_t ix)
                 {
                   const CellRef cell{const_cast<Tile*>(tile), ix, iy};
                   const std::size_t at = all.indexOfKey(cell.keyX(), cell.keyY());
                   const Leaf leaf = m_impl->tree.at(cell);
                   const auto set = [at](grid::Layer<float>& layer, double value)
                   { layer.cells()[at] = static_cast<float>(value); };
                   set(layers.height, m_impl->heightAt(cell));
                   set(layers.leafSide, m_impl->resolution * (1 << leaf.level));
                   const std::int32_t index = m_impl->indexOf(leaf.plane);
                   if (index == kNoPlane)
                     return set(layers.sigma,
                                std::sqrt(this->cell(cell.keyX(), cell.keyY())->variance));
                   const TerrainPlane& plane = m_impl->list[static_cast<std::size_t>(index)];
                   set(layers.sigma, plane.rms);
                   set(layers.plane, index);
                   set(layers.slope, plane.slope());
                 });
  layers.traversability = traversabilityOf(layers, m_impl->params);
  return layers;
}

}  // namespace mrpt_mapconv::terrain
