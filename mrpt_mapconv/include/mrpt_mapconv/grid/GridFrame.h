#pragma once

#include <cstddef>
#include <cstdint>

namespace mrpt_mapconv::grid
{
/** Where a 2D grid lies: an integer cell frame.
 *
 * Cell keys are signed integers; cell (kx, ky) covers [kx+shift, kx+shift+1)·resolution in x and
 * likewise in y, in metres of the map frame. The grid holds width × height cells, its first cell
 * has the key (x0, y0). Metres appear only at the edge: no cell is ever found by dividing metres.
 */
struct GridFrame
{
  double resolution = 0;               //!< size of a cell [m]
  std::int32_t x0 = 0, y0 = 0;         //!< key of the first cell (lowest x, lowest y)
  std::int32_t width = 0, height = 0;  //!< size in cells
  double shift = 0;  //!< of all cells [cells]; −0.5: they are centred on multiples of resolution

  bool empty() const { return width <= 0 || height <= 0; }
  std::size_t size() const
  {
    return empty() ? 0 : static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  std::int32_t xEnd() const { return x0 + width; }   //!< one past the last key in x
  std::int32_t yEnd() const { return y0 + height; }  //!< one past the last key in y
  bool containsKey(std::int32_t kx, std::int32_t ky) const
  {
    return kx >= x0 && ky >= y0 && kx < xEnd() && ky < yEnd();
  }
  /** Row-major index of the cell with key (kx, ky), which must lie inside. */
  std::size_t indexOfKey(std::int32_t kx, std::int32_t ky) const
  {
    return static_cast<std::size_t>(ky - y0) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(kx - x0);
  }

  double xMin() const { return edgeOf(x0); }      //!< [m]
  double yMin() const { return edgeOf(y0); }      //!< [m]
  double xMax() const { return edgeOf(xEnd()); }  //!< [m]
  double yMax() const { return edgeOf(yEnd()); }  //!< [m]
  /** The lower edge of the cells with that key in x or y [m]. */
  double edgeOf(std::int32_t key) const { return (key + shift) * resolution; }
  /** Their centre [m]. */
  double centreOf(std::int32_t key) const { return (key + shift + 0.5) * resolution; }

  bool operator==(const GridFrame& o) const
  {
    return resolution == o.resolution && x0 == o.x0 && y0 == o.y0 && width == o.width &&
           height == o.height && shift == o.shift;
  }
  bool operator!=(const GridFrame& o) const { return !(*this == o); }
};

/** The smallest frame that holds both (of the same resolution and shift); an empty one adds
 * nothing. */
GridFrame unite(const GridFrame& a, const GridFrame& b);

}  // namespace mrpt_mapconv::grid
