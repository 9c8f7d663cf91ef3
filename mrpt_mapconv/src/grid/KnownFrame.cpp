#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::grid
{
namespace
{
/** `isKnown` is asked of values, row by row from either end, so that a map that is known all over
 * is hardly looked at. */
template <class IsKnown>
GridFrame frameOf(const Layer<float>& layer, const IsKnown& isKnown)
{
  const GridFrame& all = layer.frame();
  const auto hasKnown = [&](std::int32_t iy)
  { return std::any_of(layer.row(iy), layer.row(iy) + all.width, isKnown); };
  std::int32_t yLow = 0, yHigh = all.height - 1;
  while (yLow <= yHigh && !hasKnown(yLow)) ++yLow;
  if (yLow > yHigh) return {all.resolution, all.x0, all.y0, 0, 0, all.shift};
  while (!hasKnown(yHigh)) --yHigh;

  std::int32_t xLow = all.width, xHigh = -1;
  for (std::int32_t iy = yLow; iy <= yHigh; ++iy)
  {
    const float* row = layer.row(iy);
    xLow = static_cast<std::int32_t>(std::find_if(row, row + xLow, isKnown) - row);
    for (std::int32_t ix = all.width - 1; ix > xHigh; --ix)
      if (isKnown(row[ix])) xHigh = ix;
  }
  return {all.resolution,   all.x0 + xLow,    all.y0 + yLow,
          xHigh - xLow + 1, yHigh - yLow + 1, all.shift};
}

/** Larger by some cells on all sides, but within another one. */
GridFrame grown(const GridFrame& frame, std::int32_t cells, const GridFrame& within)
{
  const std::int32_t x0 = std::max(frame.x0 - cells, within.x0),
                     y0 = std::max(frame.y0 - cells, within.y0);
  return {frame.resolution,
          x0,
          y0,
          std::min(frame.xEnd() + cells, within.xEnd()) - x0,
          std::min(frame.yEnd() + cells, within.yEnd()) - y0,
          frame.shift};
}
}  // namespace

GridFrame knownFrame(const Layer<float>& layer, LayerKind kind)
{
  if (kind == LayerKind::Occupancy)
    return frameOf(layer, [](float value) { return isFree(value) || isOccupied(value); });
  if (kind == LayerKind::Evidence) return frameOf(layer, [](float value) { return value > 0; });
  return frameOf(layer, [](float value) { return std::isfinite(value); });
}

GridFrame shownFrame(const std::vector<StyledLayer>& layers)
{
  const GridFrame& all = layers.at(0).layer->frame();
  GridFrame known{all.resolution, all.x0, all.y0, 0, 0, all.shift};
  for (const StyledLayer& layer : layers)
    known = unite(known, knownFrame(*layer.layer, layer.kind));
  if (known.empty()) return all;
  return grown(known, std::max(2, std::max(known.width, known.height) / 20), all);
}

}  // namespace mrpt_mapconv::grid
