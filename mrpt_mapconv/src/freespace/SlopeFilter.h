#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "FloorTile.h"

namespace mrpt_mapconv::freespace
{
/** Cells [xBegin, xEnd) × [yBegin, yEnd) of a block. */
struct BlockRect
{
  std::int32_t xBegin, xEnd, yBegin, yEnd;
};

/** Slope of the floor by least squares (Fredriksson et al. 2024, eqs. 1–4).
 *
 * The plane z = a·x + b·y + c through a window's floors needs only the window's moments, which are
 * slid along: the cost of a cell does not depend on the window. Floors and offsets are integers and
 * the moments are summed as integers, so they are exact whatever the order of summing, and the
 * moments about the mean (n·Sxz − Sx·Sz …) do not depend on where x, y and z are counted from.
 */
class SlopeFilter
{
 public:
  explicit SlopeFilter(std::int32_t window);

  /** Slopes sqrt(a² + b²) of the cells of `rect` into slope[32·y + x]; NaN where the cell has no
   * floor, fewer than three cells of its window have one, or all those lie on one line.
   * \param tile its halo is the window */
  void compute(const FloorTile& tile, const BlockRect& rect,
               std::array<double, voxel::kBlockColumns>& slope);

 private:
  /** Moments of the window's part of each column of the tile. */
  struct ColumnMoments
  {
    std::vector<std::int32_t> n, y, yy, z;
    std::vector<std::int64_t> yz;
  };
  /** Moments of the window. */
  struct Moments
  {
    std::int64_t n = 0, x = 0, xx = 0, y = 0, xy = 0, yy = 0, z = 0, xz = 0, yz = 0;
  };

  void clearColumns();
  template <std::int32_t sign>
  void addRow(const std::int32_t* floors, std::int32_t y, std::int32_t count);
  template <std::int32_t sign>
  void addColumn(Moments& m, std::int32_t x) const;
  void slideAlong(const std::int32_t* floors, const BlockRect& rect, double* slope) const;
  double slopeOf(const Moments& m) const;

  std::int32_t m_window;
  std::int32_t m_zReference = 0;  // keeps the sums small
  ColumnMoments m_columns;
};

}  // namespace mrpt_mapconv::freespace
