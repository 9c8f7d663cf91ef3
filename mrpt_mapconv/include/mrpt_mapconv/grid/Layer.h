#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>

#include <algorithm>
#include <vector>

namespace mrpt_mapconv::grid
{
/** One value per cell of a GridFrame, row by row from the lowest y, each row from the lowest x. */
template <class T>
class Layer
{
 public:
  Layer() = default;
  Layer(const GridFrame& frame, T value) : m_frame(frame), m_cells(frame.size(), value) {}

  const GridFrame& frame() const { return m_frame; }
  std::vector<T>& cells() { return m_cells; }
  const std::vector<T>& cells() const { return m_cells; }

  /** The cell at column ix, row iy, counted from the frame's corner. */
  T& at(std::int32_t ix, std::int32_t iy) { return row(iy)[ix]; }
  const T& at(std::int32_t ix, std::int32_t iy) const { return row(iy)[ix]; }
  T* row(std::int32_t iy) { return m_cells.data() + offset(iy); }
  const T* row(std::int32_t iy) const { return m_cells.data() + offset(iy); }

  /** This layer laid on another frame of the same resolution: shared cells keep their values, the
   * others get `fill`. */
  Layer onFrame(const GridFrame& frame, T fill) const
  {
    Layer out(frame, fill);
    const std::int32_t xBegin = std::max(frame.x0, m_frame.x0);
    const std::int32_t xEnd = std::min(frame.xEnd(), m_frame.xEnd());
    const std::int32_t yEnd = std::min(frame.yEnd(), m_frame.yEnd());
    if (xBegin >= xEnd) return out;
    for (std::int32_t ky = std::max(frame.y0, m_frame.y0); ky < yEnd; ++ky)
      std::copy_n(row(ky - m_frame.y0) + (xBegin - m_frame.x0), xEnd - xBegin,
                  out.row(ky - frame.y0) + (xBegin - frame.x0));
    return out;
  }

 private:
  std::size_t offset(std::int32_t iy) const
  {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(m_frame.width);
  }

  GridFrame m_frame;
  std::vector<T> m_cells;
};

}  // namespace mrpt_mapconv::grid
