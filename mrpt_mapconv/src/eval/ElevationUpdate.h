#pragma once

#include <mrpt_mapconv/eval/ElevationMap.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "../terrain/PointBatch.h"

namespace mrpt_mapconv::eval
{
/** What becomes of variances [m²] between scans. */
struct VarianceLimits
{
  explicit VarianceLimits(const ElevationMapParams& params)
      : least(static_cast<float>(params.minVariance)), most(static_cast<float>(params.maxVariance))
  {
  }
  /** Infinite: the cell is forgotten. */
  float operator()(float variance) const
  {
    const float bounded = variance < least ? least : variance;
    return bounded <= most ? bounded : std::numeric_limits<float>::infinity();
  }

  float least, most;
};

/** What an update depends on beside the points. */
struct UpdateRule
{
  /** \param number of the scan, from 1 */
  UpdateRule(const ElevationMapParams& params, std::uint32_t number)
      : limits(params),
        noise(static_cast<float>(params.multiHeightNoise)),
        threshold(static_cast<float>(params.mahalanobisDistanceThreshold)),
        scan(2 * number)
  {
  }

  VarianceLimits limits;
  float noise;         //!< [m²]
  float threshold;     //!< [σ]
  std::uint32_t scan;  //!< as in a cell without a fused point
};

/** Updates cells by the points of a batch; those that are not finite are left out.
 * \param cells the grid's cells, which hold all the points
 * \return number of points that are finite */
std::size_t updateCells(const terrain::PointModel::Batch& points, std::size_t count,
                        const UpdateRule& rule, grid::Layer<ElevationMap::Cell>& cells);

}  // namespace mrpt_mapconv::eval
