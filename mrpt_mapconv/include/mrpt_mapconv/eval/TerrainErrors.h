#pragma once

#include <mrpt_mapconv/eval/CellMask.h>
#include <mrpt_mapconv/eval/TerrainTruth.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace mrpt_mapconv::eval
{
/** What errors come to; NaN for none. */
struct ErrorSummary
{
  std::size_t cells = 0;
  double bias = NAN;          //!< their mean
  double meanAbsolute = NAN;  //!< mean of their absolute values
  double rms = NAN;
};

/** Of errors as errorsOf() gives them. */
ErrorSummary summaryOf(const std::vector<double>& errors);

/** Map minus truth in the judged cells of each true plane that are finite in both, in the order of
 * truth.planes.
 * \exception std::invalid_argument for different resolutions */
std::vector<ErrorSummary> errorsOfPlanes(const grid::Layer<float>& map, const TerrainTruth& truth,
                                         const CellMask& judged);

/** Differences of a layer, in the cells of a plane, to the least-squares plane through them: rms
 * and mean absolute value; the bias is 0 but for rounding.
 * \param cells at least three of them, not on one line, are finite in the layer; else NaN */
ErrorSummary residualsToPlane(const grid::Layer<float>& heights, const CellMask& cells);

}  // namespace mrpt_mapconv::eval
