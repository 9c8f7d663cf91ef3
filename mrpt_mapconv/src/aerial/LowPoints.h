#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>

#include "UsedPoints.h"

namespace mrpt_mapconv::aerial
{
/** Takes points that are too low to be ground out of those that are used: echoes that came over a
 * detour. Such a point has too little company: of the n points within lowPointRadius (cells of a
 * fifth of it), at most lowPointShare·n others lie less than lowPointDepth above it, or anywhere
 * below. Where fewer than three points are around, none is judged.
 *
 * Each point is judged by all that are used, so neither order nor threads matter; only points with
 * nothing but low points below them in their cell are looked at. */
void leaveOutLowPoints(const cloud::PointCloud& cloud, const GroundParams& params, int threads,
                       UsedPoints& used);

}  // namespace mrpt_mapconv::aerial
