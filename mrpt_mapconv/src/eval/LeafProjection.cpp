#include <mrpt_mapconv/eval/LeafProjection.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::eval
{
using grid::GridFrame;
using grid::Layer;

namespace
{
constexpr std::int32_t kOffset = voxel::kOctomapKeyOffset;

octomap::key_type octomapKey(double key)
{
  return static_cast<octomap::key_type>(std::clamp(key + kOffset, 0.0, 65535.0));
}

/** Clears the rectangle to unknown. */
void clear(const GridFrame& cells, Layer<float>& layer)
{
  const GridFrame& frame = layer.frame();
  for (std::int32_t ky = cells.y0; ky < cells.yEnd(); ++ky)
    std::fill_n(layer.row(ky - frame.y0) + (cells.x0 - frame.x0), cells.width, grid::kUnknown);
}

/** Marks the cells below a leaf, as far as they lie in the rectangle. */
void mark(const GridFrame& leaf, const GridFrame& cells, bool occupied, Layer<float>& layer)
{
  const GridFrame& frame = layer.frame();
  const std::int32_t xBegin = std::max(leaf.x0, cells.x0),
                     xEnd = std::min(leaf.xEnd(), cells.xEnd());
  const std::int32_t yBegin = std::max(leaf.y0, cells.y0),
                     yEnd = std::min(leaf.yEnd(), cells.yEnd());
  for (std::int32_t ky = yBegin; ky < yEnd; ++ky)
  {
    float* row = layer.row(ky - frame.y0) - frame.x0;
    for (std::int32_t kx = xBegin; kx < xEnd; ++kx)
      if (occupied)
        row[kx] = 1;
      else if (row[kx] < 0)
        row[kx] = grid::kFree;
  }
}
}  // namespace

void projectByLeaves(const octomap::OcTree& tree, double zMin, double zMax, const GridFrame& cells,
                     Layer<float>& layer)
{
  clear(cells, layer);
  const double res = tree.getResolution();
  const octomap::OcTreeKey low(octomapKey(cells.x0), octomapKey(cells.y0),
                               octomapKey(std::floor(zMin / res + 1e-6)));
  const octomap::OcTreeKey high(octomapKey(cells.xEnd() - 1), octomapKey(cells.yEnd() - 1),
                                octomapKey(std::ceil(zMax / res - 1e-6) - 1));
  for (auto it = tree.begin_leafs_bbx(low, high), end = tree.end_leafs_bbx(); it != end; ++it)
  {
    const octomap::OcTreeKey key = it.getIndexKey();
    const auto side = static_cast<std::int32_t>(1) << (tree.getTreeDepth() - it.getDepth());
    mark({res, key[0] - kOffset, key[1] - kOffset, side, side}, cells, tree.isNodeOccupied(*it),
         layer);
  }
}

}  // namespace mrpt_mapconv::eval
