#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/sim/Scenario.h>
#include <octomap/OcTree.h>

#include <array>
#include <memory>
#include <vector>

#include "experiment/freespace/FreespaceSettings.h"
#include "output/Progress.h"

namespace mapconv
{
/** The ways to make a 2D map that are compared. */
enum class Method
{
  FreeSpace,      //!< floor, ceiling, slope and both occupancies
  Slice,          //!< fixed projection of the slice
  WholeHeight,    //!< fixed projection of the whole height
  SliceByLeaves,  //!< the same two as OctoMap's server makes them
  WholeHeightByLeaves
};
constexpr std::size_t kMethods = 5;

/** A value for each method. */
template <class Value>
using PerMethod = std::array<Value, kMethods>;

/** What it cost to bring the 2D maps up to date after a moment's scans. */
struct UpdateCost
{
  std::size_t changedColumns = 0;
  PerMethod<double> ms{};
};

/** A run through a world in which the voxel map grows scan by scan. */
struct Exploration
{
  std::unique_ptr<octomap::OcTree> tree;
  std::vector<UpdateCost> updates;          //!< of a world for the paper's tables
  mrpt_mapconv::grid::Layer<float> inView;  //!< 3D returns per cell, without noise
  double startHeight = 0;                   //!< of the sensor when it began [m]
  std::size_t scans = 0, points = 0;
};

/** Simulates the scenario and, for the paper's tables, times the updates, all of them on one
 * thread; the methods take turns in being first. Scans are inserted at the estimated poses. */
Exploration explore(const mrpt_mapconv::sim::Scenario& scenario, const FreespaceWorld& world,
                    const FreespaceSettings& settings, Progress& progress);

}  // namespace mapconv
