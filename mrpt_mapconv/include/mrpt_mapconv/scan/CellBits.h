#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace mrpt_mapconv::scan
{
/** A set of cells within a frame, one bit for each: bit b of word w of a row is column 64·w + b. */
class CellBits
{
 public:
  /** Makes it empty on another frame; memory is kept. */
  void reset(const grid::GridFrame& frame)
  {
    m_frame = frame;
    m_words = (static_cast<std::size_t>(frame.width) + 63) / 64;
    m_bits.assign(m_words * static_cast<std::size_t>(frame.height), 0);
  }

  const grid::GridFrame& frame() const { return m_frame; }
  std::size_t wordsPerRow() const { return m_words; }
  std::uint64_t* row(std::int32_t iy)
  {
    return m_bits.data() + m_words * static_cast<std::size_t>(iy);
  }
  const std::uint64_t* row(std::int32_t iy) const
  {
    return m_bits.data() + m_words * static_cast<std::size_t>(iy);
  }

  /** Column ix, row iy, counted from the frame's corner. */
  bool test(std::int32_t ix, std::int32_t iy) const { return (row(iy)[ix >> 6] >> (ix & 63)) & 1; }
  void set(std::int32_t ix, std::int32_t iy) { row(iy)[ix >> 6] |= std::uint64_t(1) << (ix & 63); }
  /** True for the key of a cell of the set; false for one outside the frame. */
  bool containsKey(std::int32_t kx, std::int32_t ky) const
  {
    return m_frame.containsKey(kx, ky) && test(kx - m_frame.x0, ky - m_frame.y0);
  }
  /** Number of cells in the set. */
  std::size_t count() const;

 private:
  grid::GridFrame m_frame;
  std::size_t m_words = 0;
  std::vector<std::uint64_t> m_bits;
};

}  // namespace mrpt_mapconv::scan
