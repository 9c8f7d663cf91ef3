#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/sim/World.h>

namespace mrpt_mapconv::sim
{
/** What is asked of a world. */
struct TruthParams
{
  double minClearance = 1.0;  //!< a vertical gap must be at least this high to fly in [m]
  double robotHeight = 1.0;   //!< of the ground robot [m]
  double maxSlope = 0.5;      //!< steepest ground for it [m/m]; the comparisons' truthSlope
  double maxStep = 0.1;       //!< highest jump of the ground for it [m]; their truthStep

  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
};

/** The frame of the cells that a world's bounds touch.
 * \param resolution [m]
 * \exception std::invalid_argument if that would be more than 4e7 cells, or 1e5 on a side */
grid::GridFrame frameOf(const World& world, double resolution);

/** True layers, evaluated at the cells' centres from the geometry, never from a map.
 *
 * A gap is a part of the vertical line, within the world's bounds, between two solids, or above
 * the highest one (its ceiling is then +infinity); what is below the lowest solid is no gap.
 * - floor, ceiling: bottom of the lowest, top of the highest gap that is ≥ minClearance [m]; NaN:
 *   there is none;
 * - slope: of the surface at `floor` [m/m]; NaN where floor is;
 * - aerial: 0 where there is such a gap, 1 where there are solids but no gap, −1 without a solid;
 * - ground: 0 where the gap above the lowest solid is at least the robot's height, the slope there
 *   is ≤ maxSlope and no jump > maxStep of the lowest solid's top lies within half a cell; 1 where
 *   not; −1 without a solid. Jumps are looked for between neighbouring points of a lattice with 8
 *   steps to a cell, whose outermost points lie 1e-6 m beyond the cell's borders, though never
 *   beyond the bounds; next to a place without a solid is a jump.
 * Cells with their centre beyond the bounds are unknown. A value within 1e-9 of a limit keeps it.
 *
 * \param threads 0 = all cores */
freespace::Layers truthLayers(const World& world, const grid::GridFrame& frame,
                              const TruthParams& params, int threads = 0);

/** What can be hit between two heights: 1 where a solid reaches into zMin … zMax (by more than
 * 1e-9 m) anywhere in the cell, 0 where none does and there is ground, −1 where there is none: no
 * solid at zMin or below under the cell's centre. Cells with their centre beyond the bounds are −1.
 *
 * Solids are looked for on a lattice with 8 steps to a cell, whose outermost points lie 1e-6 m
 * within the cell's borders, though never beyond the bounds. So a body that ends on a border is not
 * in the cell beyond, and none that is at least a step wide (6 mm in cells of 5 cm) is missed where
 * it stands along the cells; where it is turned or round, at most the tip of a corner is.
 *
 * \param zMin,zMax heights in the world's frame [m], whatever its bounds
 * \param threads 0 = all cores
 * \exception std::invalid_argument unless zMin < zMax, both finite */
grid::Layer<float> obstacleLayer(const World& world, const grid::GridFrame& frame, double zMin,
                                 double zMax, int threads = 0);

}  // namespace mrpt_mapconv::sim
