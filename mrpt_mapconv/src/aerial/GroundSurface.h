#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>
#include <mrpt_mapconv/grid/Layer.h>

#include "UsedPoints.h"

namespace mrpt_mapconv::aerial
{
/** Where a filter has found the ground, on cells without gaps that reach beyond all points. */
struct GroundSurface
{
  grid::Layer<float> height;     //!< at the cells' centres [m]
  grid::Layer<float> tolerance;  //!< points at most so much above it are ground [m]
  bool hasSettled = true;        //!< false: of a cloth that was stopped before it rested
};

/** The cloth simulation filter: the cloth is pressed against the lowest points, then, with
 * slopeSmoothing, fixed to those that drawOn() finds and left to settle once more.
 *
 * The lowest point of a cell lies below its middle where the ground is steep, by up to half a cell
 * times the slope: GroundParams::heightScale makes up for that. */
GroundSurface clothGround(const cloud::PointCloud& cloud, const UsedPoints& used,
                          const GroundParams& params, int threads);

/** The simple morphological filter of Pingel et al.: cells of the lowest surface that an opening
 * with a disc of r cells, for r from 1 to smrfWindow, lowers by more than smrfSlope·r cells are
 * objects, and the rest, filled, is the ground. Cells that are more than 5 m/m lower than all four
 * neighbours are no ground either. Since a disc ends at the map's border, steep ground is taken for
 * an object there at the upper end. */
GroundSurface morphologicalGround(const cloud::PointCloud& cloud, const UsedPoints& used,
                                  const GroundParams& params, int threads);

/** How steep a surface without gaps is at each cell, from `reach` cells before to as many behind it
 * in x and y [m/m]. */
grid::Layer<float> slopeOf(const grid::Layer<float>& surface, std::int32_t reach);

/** A layer's value at a place between the centres of its cells [m]: bilinear, as of the nearest
 * such place beyond the outermost ones. */
float interpolate(const grid::Layer<float>& layer, double x, double y);

}  // namespace mrpt_mapconv::aerial
