#pragma once

#include <mrpt_mapconv/eval/CellMask.h>

#include <cstdint>
#include <utility>
#include <vector>

/** Maps of a few cells, for the tests of scores. */
namespace mrpt_mapconv::testing
{
using eval::CellMask;
using grid::GridFrame;
using grid::Layer;

inline constexpr float F = 0, O = 1, U = -1;

/** Cells beside each other, the first one with key x0. */
inline Layer<float> row(std::vector<float> cells, std::int32_t x0 = 0)
{
  Layer<float> layer(GridFrame{0.5, x0, 0, static_cast<std::int32_t>(cells.size()), 1}, 0);
  layer.cells() = std::move(cells);
  return layer;
}

/** All cells of a layer. */
inline CellMask mask(const Layer<float>& like) { return {like.frame(), 1}; }
}  // namespace mrpt_mapconv::testing
