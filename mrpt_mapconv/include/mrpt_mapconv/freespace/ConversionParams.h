#pragma once

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

  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;

  /** Voxels that a free range needs: max(1, ceil(minClearance/res − 1e-6)). */
  std::int32_t minRunVoxels(double resolution) const;
  /** Largest floor difference in voxels that is no step; only meaningful with maxStep > 0. */
  std::int32_t maxStepVoxels(double resolution) const;
  /** Height of the lowest straight step that the slope test marks: maxSlope·res·(2·S_A+1)/1.5 [m].
   * Averaging over the window hides lower ones; maxStep finds them. */
  double minStep(double resolution) const;
};

}  // namespace mrpt_mapconv::freespace
