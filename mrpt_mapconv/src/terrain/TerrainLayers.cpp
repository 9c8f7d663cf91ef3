#include <algorithm>
#include <cmath>
#include <limits>

#include "TerrainMapImpl.h"
#include "Traversability.h"

namespace mrpt_mapconv::terrain
{
namespace
{
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/** What is the same in all cells of a leaf. */
struct LeafValues
{
  float side, sigma, plane, slope;
};

void fillCell(TerrainLayers& layers, std::size_t at, double height, const LeafValues& values)
{
  layers.height.cells()[at] = static_cast<float>(height);
  layers.leafSide.cells()[at] = values.side;
  layers.sigma.cells()[at] = values.sigma;
  layers.plane.cells()[at] = values.plane;
  layers.slope.cells()[at] = values.slope;
}

/** The cells of a leaf that lie in a tile. */
template <class Visit>
void forEachCell(const Leaf& leaf, const Tile& tile, const Visit& visit)
{
  const std::int32_t side = std::min(std::int32_t{1} << std::min(leaf.level, kTileBits), kTileSide);
  const std::int32_t x = leaf.level > kTileBits ? tile.keyX(0) : leaf.x,
                     y = leaf.level > kTileBits ? tile.keyY(0) : leaf.y;
  for (std::int32_t ky = y; ky < y + side; ++ky)
    for (std::int32_t kx = x; kx < x + side; ++kx) visit(kx, ky);
}
}  // namespace

/** Fills the cells of a leaf in a tile. */
void TerrainMap::Impl::fillLeaf(const Leaf& leaf, const Tile& tile, TerrainLayers& layers) const
{
  const grid::GridFrame& frame = layers.height.frame();
  LeafValues values{static_cast<float>(resolution * (1 << leaf.level)), kNaN, kNaN, kNaN};
  const std::int32_t index = indexOf(leaf.plane);
  if (index == kNoPlane)
  {
    const CellSums& sums = tile.sums[Tile::indexOf(leaf.x & kTileMask, leaf.y & kTileMask)];
    values.sigma = static_cast<float>(std::sqrt(varianceOf(sums)));
    return fillCell(layers, frame.indexOfKey(leaf.x, leaf.y), kHeightUnit * leaf.height, values);
  }
  const TerrainPlane& plane = list[static_cast<std::size_t>(index)];
  values.sigma = static_cast<float>(plane.rms);
  values.plane = static_cast<float>(index);
  values.slope = static_cast<float>(plane.slope());
  const Plane& exact = planes.at(leaf.plane).plane;
  forEachCell(leaf, tile,
              [&](std::int32_t kx, std::int32_t ky) {
                fillCell(layers, frame.indexOfKey(kx, ky), kHeightUnit * exact.at(kx, ky), values);
              });
}

/** Marks cells in which something stands or hangs above the height that its points have on average,
 * as a table does of which some beams see the top and some the floor below. */
void TerrainMap::Impl::markWhatStands(const Tile& tile, TerrainLayers& layers) const
{
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    forEachBit(tile.known[static_cast<std::size_t>(iy)],
               [&](std::int32_t ix)
               {
                 const std::size_t at =
                     layers.height.frame().indexOfKey(tile.keyX(ix), tile.keyY(iy));
                 const double above = kHeightUnit * tile.sums[Tile::indexOf(ix, iy)].highestZ() -
                                      static_cast<double>(layers.height.cells()[at]);
                 if (above > params.maxStep) layers.traversability.cells()[at] = 1;
               });
}

TerrainLayers TerrainMap::layers() const
{
  const grid::GridFrame all = frame();
  TerrainLayers layers;
  for (auto* layer :
       {&layers.height, &layers.sigma, &layers.plane, &layers.leafSide, &layers.slope})
    *layer = grid::Layer<float>(all, kNaN);
  for (const Tile* tile : m_impl->tiles.sorted())
    m_impl->tree.forEachOf(*tile, [&](const Leaf& leaf) { m_impl->fillLeaf(leaf, *tile, layers); });
  layers.traversability = traversabilityOf(layers, m_impl->params);
  for (const Tile* tile : m_impl->tiles.sorted()) m_impl->markWhatStands(*tile, layers);
  return layers;
}

}  // namespace mrpt_mapconv::terrain
