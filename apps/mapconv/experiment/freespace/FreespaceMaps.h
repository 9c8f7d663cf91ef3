#pragma once

#include <mrpt_mapconv/eval/CellMask.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <array>
#include <string>
#include <vector>

#include "experiment/freespace/Exploration.h"

namespace mapconv
{
/** Milliseconds of each repetition of a conversion of the whole map, on one thread. */
using FullCosts = PerMethod<std::vector<double>>;

/** A map for a ground robot that climbs no steps. */
struct GroundMap
{
  std::string name;  //!< for tables
  mrpt_mapconv::freespace::ConversionParams params;
  mrpt_mapconv::freespace::Layers layers;
};

/** With floorFrom = lowestFree, "strict", and with floorFrom = seen, all else alike. */
constexpr std::size_t kGroundMaps = 2;

/** The 2D maps of a finished voxel map, and the truth. */
struct FreespaceMaps
{
  std::array<GroundMap, kGroundMaps> ground;
  mrpt_mapconv::freespace::Layers truth;
  mrpt_mapconv::eval::CellMask inView;  //!< cells with a 3D return

  // for the paper's tables
  mrpt_mapconv::freespace::Layers layers;  //!< with the paper's parameters
  mrpt_mapconv::grid::Layer<float> slice, wholeHeight;
  FullCosts costs;
};

/** Converts the map; for the paper's tables in every way, timing it; the methods take turns. */
FreespaceMaps makeMaps(const Exploration& run, const mrpt_mapconv::sim::Scenario& scenario,
                       const FreespaceWorld& world, const FreespaceSettings& settings,
                       Progress& progress);

}  // namespace mapconv
