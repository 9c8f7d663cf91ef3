#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>
#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/** What the filters of `aerial` are made of, point by point and cell by cell. */
namespace mrpt_mapconv::oracle
{
/** For each cell the height of its lowest used point, or of that nearest to its centre: all points
 * are tried for each. NaN without one. */
grid::Layer<float> pointHeights(const cloud::PointCloud& cloud,
                                const std::vector<std::uint8_t>& used, const grid::GridFrame& frame,
                                aerial::CollisionRule rule);

/** The nearest cell with a height, of all; then the lowest, then the first. */
std::uint32_t nearestWithHeight(const grid::Layer<float>& heights, std::size_t cell);

/** Empty cells become the mean of their neighbours, over and over until nothing moves. */
grid::Layer<double> membrane(const grid::Layer<float>& heights);

/** The opening by its definition: the highest of the lowest in all discs that hold the cell. */
grid::Layer<float> opening(const grid::Layer<float>& surface, int radius);

/** Indices of points that have too little company among the points in cells of a fifth of the
 * radius whose centres are within it, and of which the same goes for all below in their cell.
 * \param distance of points on average [m] */
std::vector<std::size_t> lonePoints(const cloud::PointCloud& cloud,
                                    const aerial::GroundParams& params, double distance);

/** A cloth of double heights, particle by particle and constraint by constraint, settled once
 * below a surface from which the plane that fits best was taken off.
 * Within a row all constraints of a length are worked on at once, as from the heights before. */
grid::Layer<double> settledCloth(const grid::Layer<float>& surface,
                                 const aerial::GroundParams& params);

}  // namespace mrpt_mapconv::oracle
