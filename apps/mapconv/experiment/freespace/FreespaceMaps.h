#pragma once

#include <mrpt_mapconv/eval/CellMask.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <vector>

#include "experiment/freespace/Exploration.h"

namespace mapconv
{
/** Milliseconds of each repetition of a conversion of the whole map, on one thread. */
using FullCosts = PerMethod<std::vector<double>>;

/** The 2D maps of a finished voxel map, and the truth. */
struct FreespaceMaps
{
  mrpt_mapconv::freespace::Layers layers;  //!< with the paper's parameters
  mrpt_mapconv::freespace::Layers strict;  //!< for a robot that climbs no steps
  mrpt_mapconv::grid::Layer<float> slice, wholeHeight;
  mrpt_mapconv::freespace::Layers truth;
  mrpt_mapconv::eval::CellMask seen;  //!< cells with a 3D return
  FullCosts costs;
};

/** Converts the map in every way, timing it; the methods take turns. */
FreespaceMaps makeMaps(const Exploration& run, const mrpt_mapconv::sim::Scenario& scenario,
                       const FreespaceWorld& world, const FreespaceSettings& settings,
                       Progress& progress);

}  // namespace mapconv
