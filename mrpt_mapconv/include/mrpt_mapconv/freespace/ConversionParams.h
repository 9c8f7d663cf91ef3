#pragma once

#include <mrpt_mapconv/params/Fields.h>
#include <mrpt_mapconv/voxel/UnknownVoxels.h>

#include <cstdint>

namespace mrpt_mapconv::freespace
{
/** Parameters of the free-space projection; the defaults are Table I of Fredriksson et al. 2024. */
struct ConversionParams
{
  double minClearance = 1.0;  //!< R_maxZ: a free range must be at least this high [m]
  double minOccupancy =
      0.5;  //!< O_min: least share of a neighbour's free range that blocks, [0, 1]
  std::int32_t slopeWindow = 2;  //!< S_A: half side of the slope's window [cells], 1 … 100
  double maxSlope = 2.0;         //!< R_MS: a ground robot's steepest slope [m/m]
  double maxStep = 0.0;  //!< highest step between 8-neighbours for a ground robot [m]; 0 = off
  voxel::ReadingParams reading = {};  //!< how the voxel map is read

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    using params::flag;
    v("minClearance", p.minClearance, "m", "a free range must be at least this high", flag("M"));
    v("minOccupancy", p.minOccupancy, "",
      "least share of a neighbour's free range that blocks, 0 to 1", flag("P"));
    v("slopeWindow", p.slopeWindow, "cells",
      "half side of the window over which a cell's slope is fitted", flag("N"));
    v("maxSlope", p.maxSlope, "m/m", "steepest slope for a ground robot", flag("S"));
    v("maxStep", p.maxStep, "m", "highest step for a ground robot; 0 = not looked at", flag("M"));
    voxel::ReadingParams::visit(p.reading, v);
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;

  /** Voxels that a free range needs: max(1, ceil(minClearance/res − 1e-6)). */
  std::int32_t minRunVoxels(double resolution) const;
  /** Largest floor difference in voxels that is no step; only meaningful with maxStep > 0. */
  std::int32_t maxStepVoxels(double resolution) const;
  /** Height of the lowest straight step that the slope test marks: maxSlope·res·(2·S_A+1)/1.5 [m].
   * Averaging over the window hides lower ones; maxStep finds them. */
  double minStep(double resolution) const;
  /** Height of the lowest straight wall, one cell thick, around which the slope test marks cells:
   * ((S_A+1)(2·S_A+1)/3)·maxSlope·res [m]. They lie S_A cells away from it on either side: on the
   * wall the slope is 0, and a single post is marked at 2·S_A+1 times that height only. */
  double minThinWall(double resolution) const;
};

}  // namespace mrpt_mapconv::freespace
