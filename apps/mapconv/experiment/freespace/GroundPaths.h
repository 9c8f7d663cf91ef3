#pragma once

#include <mrpt_mapconv/eval/NoPath.h>

#include <array>
#include <map>
#include <vector>

#include "experiment/freespace/Ways.h"

namespace mapconv
{
/** What became of a ground robot's start–goal pairs on one map. */
struct GroundPaths
{
  std::vector<Way> ways;  //!< those that were found
  std::map<mrpt_mapconv::eval::NoPath, std::size_t> notFound;
  std::size_t leaveFree = 0;   //!< of those found, how many leave truly free cells
  std::size_t touchWorld = 0;  //!< on how many the robot's body touches the true world

  /** Pairs whose ends the map lets the robot stand in. */
  std::size_t standable() const;
  /** Share of these that were found. */
  double shareFound() const;
};

/** The pairs of a world and their ways on each of its ground maps. */
struct GroundRuns
{
  std::vector<Pair> pairs;
  std::array<GroundPaths, kGroundMaps> onMap;
};

/** Plans the pairs on each map. The robot's body is a sphere that rolls a step (maxStep, at least a
 * voxel) above the true ground. */
GroundRuns planGroundPairs(const FreespaceWorld& world, const mrpt_mapconv::sim::World& bodies,
                           const octomap::OcTree& tree, const FreespaceMaps& maps, int pairs,
                           Progress& progress);

}  // namespace mapconv
