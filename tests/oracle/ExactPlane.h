#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace mrpt_mapconv::oracle
{
struct Cell;

/** A height (dx, dy) cells away, counted from any zero; nothing if there is none. */
using HeightAt = std::function<std::optional<std::int64_t>(int dx, int dy)>;

/** Least squares over a window of 2·window + 1 cells, in exact integers; fills the cell's slope.
 * \param unitsPerVoxel what heights are counted in: 1 for whole voxels */
void fitPlane(int window, const HeightAt& heightAt, int unitsPerVoxel, double maxSlope, Cell& cell);

}  // namespace mrpt_mapconv::oracle
