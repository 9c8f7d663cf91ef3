#pragma once

#include <mrpt_mapconv/eval/CellMask.h>

#include <cstddef>
#include <vector>

namespace mrpt_mapconv::eval
{
/** Map minus truth in the judged cells that are finite in both layers, row by row. */
std::vector<double> errorsOf(const grid::Layer<float>& map, const grid::Layer<float>& truth,
                             const CellMask& judged);

/** A root mean square error and the number of cells that it is of. */
struct Rmse
{
  double value = 0;  //!< in the layers' unit; NaN for no cells
  std::size_t cells = 0;
};

/** Of errorsOf(). */
Rmse rmse(const grid::Layer<float>& map, const grid::Layer<float>& truth, const CellMask& judged);

}  // namespace mrpt_mapconv::eval
