#pragma once

#include <mrpt/img/TColor.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cstdint>
#include <vector>

namespace mrpt_mapconv::grid::picture
{
/** Colours that tell planes apart: few and well distinguishable ones, of which no two neighbours
 * have the same. */
class PlaneColors
{
 public:
  /** \param planes index of each cell's plane, from 0 on; NaN: none */
  explicit PlaneColors(const Layer<float>& planes);

  /** \param plane an index of the layer */
  const mrpt::img::TColor& of(std::int32_t plane) const;
  /** How many planes the layer has. */
  std::size_t planes() const { return m_planes; }

 private:
  std::vector<std::size_t> m_colors;  //!< by the plane's index
  std::size_t m_planes = 0;
};

/** Planes with less cells than that between them are neighbours. */
constexpr std::int32_t kPlaneGap = 3;

/** Colour of a cell without a plane; t in [0, 1]: dark grey (low) to light grey (high). */
mrpt::img::TColor bareColor(double t);

}  // namespace mrpt_mapconv::grid::picture
