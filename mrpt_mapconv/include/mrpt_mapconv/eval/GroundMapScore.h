#pragma once

#include <mrpt_mapconv/aerial/Ground.h>
#include <mrpt_mapconv/eval/TerrainErrors.h>

namespace mrpt_mapconv::eval
{
/** Errors of a map of the ground, its heights less the true ones, in the cells that have a true one
 * [m]. */
struct GroundMapScore
{
  ErrorSummary all;
  ErrorSummary measured, inferred;  //!< cells with a ground point, and those without
};

/** \param truth heights of the ground [m]; NaN where there is none
 * \exception std::invalid_argument for different resolutions */
GroundMapScore scoreGroundMap(const aerial::GroundLayers& map, const grid::Layer<float>& truth);

}  // namespace mrpt_mapconv::eval
