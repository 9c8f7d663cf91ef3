#pragma once

#include <mrpt_mapconv/eval/CellMask.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace mrpt_mapconv::eval
{
/** A part of all, [0, 1]; NaN of nothing. */
inline double share(std::size_t part, std::size_t all)
{
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all)
                 : std::numeric_limits<double>::quiet_NaN();
}

/** \exception std::invalid_argument if they differ by more than rounding */
inline void checkResolution(const grid::GridFrame& a, const grid::GridFrame& b)
{
  if (std::abs(a.resolution - b.resolution) > 1e-6 * a.resolution)
    throw std::invalid_argument("the map's cells are " + std::to_string(a.resolution) +
                                " m, those of the truth " + std::to_string(b.resolution) + " m");
}

/** A layer on another frame, whose resolution differs at most by rounding. */
template <class T>
grid::Layer<T> on(grid::GridFrame frame, const grid::Layer<T>& layer, T fill)
{
  checkResolution(layer.frame(), frame);
  return layer.onFrame(frame, fill);
}

inline bool isKnown(float cell) { return grid::isFree(cell) || grid::isOccupied(cell); }

/** Map, truth and mask on the frame of the truth. */
struct ComparedMaps
{
  ComparedMaps(const grid::Layer<float>& map, const grid::Layer<float>& truth_,
               const CellMask& mask)
      : said(on(truth_.frame(), map, grid::kUnknown)),
        truth(truth_),
        judged(on(truth_.frame(), mask, std::uint8_t{0}))
  {
  }

  /** Calls see(x, y) for each judged cell whose truth is known. */
  template <class See>
  void forEachJudged(const See& see) const
  {
    for (std::int32_t y = 0; y < truth.frame().height; ++y)
      for (std::int32_t x = 0; x < truth.frame().width; ++x)
        if (judged.at(x, y) && isKnown(truth.at(x, y))) see(x, y);
  }

  grid::Layer<float> said;
  const grid::Layer<float>& truth;
  CellMask judged;
};

/** Whether a cell within `reach` cells of (x, y) has the label that is asked for. */
inline bool hasLabel(const grid::Layer<float>& layer, std::int32_t x, std::int32_t y,
                     std::int32_t reach, bool free)
{
  const grid::GridFrame& frame = layer.frame();
  for (std::int32_t ny = std::max(y - reach, 0); ny <= std::min(y + reach, frame.height - 1); ++ny)
    for (std::int32_t nx = std::max(x - reach, 0); nx <= std::min(x + reach, frame.width - 1); ++nx)
    {
      const float cell = layer.at(nx, ny);
      if (free ? grid::isFree(cell) : grid::isOccupied(cell)) return true;
    }
  return false;
}

}  // namespace mrpt_mapconv::eval
