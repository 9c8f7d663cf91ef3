#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>

#include <cstddef>

#include "UsedPoints.h"

namespace mrpt_mapconv::aerial
{
/** Where a point's company is looked for. */
struct Company
{
  double radius;  //!< around it [m]
  double below;   //!< down to so much [m]
  double above;   //!< up to so much [m]

  /** That of lowPointRadius and lowPointDepth, both enlarged if points are so far from each other
   * that the radius would be less than four of their distances. Ground falls by half of the radius
   * at most. */
  static Company of(const GroundParams& params, double pointDistance);
};

/** Takes points that are too low to be ground out of those that are used: echoes that came over a
 * detour. Such a point has too little Company: of the n points within its radius (cells of a fifth
 * of it), less than three others and lowPointShare·n at its height over the plane that fits all
 * points best. Where fewer than ten points are around, none is judged; nor if none would be left.
 *
 * Each point is judged by all that are used, so neither order nor threads matter; only points with
 * nothing but low points below them in their cell are looked at. */
void leaveOutLowPoints(const cloud::PointCloud& cloud, const GroundParams& params, int threads,
                       UsedPoints& used);

}  // namespace mrpt_mapconv::aerial
