#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <array>
#include <cstddef>

#include "experiment/terrain/TerrainExperimentSettings.h"
#include "experiment/terrain/TerrainWalk.h"

namespace mapconv
{
/** The ways to map scans whose times are compared. */
enum class TerrainMethod
{
  Fused,            //!< our map with fused heights, on one thread
  Maximum,          //!< our map with the highest points
  FusedTwoThreads,  //!< the same on two threads
  MaximumTwoThreads,
  ElevationFused,  //!< the baseline, all of whose cells are fused after each scan
  ElevationRaw,    //!< the baseline without that
  HeightGrid,      //!< MRPT's CHeightGridMap2D
  OctoMap          //!< the octree of MRPT's COctoMap
};
constexpr std::size_t kTerrainMethods = 8;

/** The maps whose heights are compared. */
enum class TerrainHeights
{
  Fused,
  Maximum,
  ElevationFused,
  ElevationRaw
};
constexpr std::size_t kTerrainHeights = 4;

/** A value for each. @{ */
template <class Value>
using PerTerrainMethod = std::array<Value, kTerrainMethods>;
template <class Value>
using PerTerrainHeights = std::array<Value, kTerrainHeights>;
/** @} */

/** All maps of a walk whose heights are judged. */
struct TerrainMappings
{
  mrpt_mapconv::terrain::TerrainMap fused, maximum;
  mrpt_mapconv::grid::Layer<float> elevationFused, elevationRaw;  //!< heights [m]
  std::size_t elevationMemory = 0;                                //!< of the baseline [bytes]
};

/** Makes them; planes follow after each scan. \param noise index of the settings' poseNoise */
TerrainMappings mappingsOf(const TerrainWalk& walk, std::size_t noise, double resolution,
                           const TerrainExperimentSettings& settings);

/** How long each method takes for all scans, each of which can be queried before the next one, the
 * shortest time of the settings' repetitions [s]; NaN: it is not made at that resolution. What is
 * not the method's own work, as the points of octomaps in the map's frame, is not part of it. */
PerTerrainMethod<double> mappingTimes(const TerrainWalk& walk, std::size_t noise, double resolution,
                                      const TerrainExperimentSettings& settings,
                                      Progress& progress);

/** Nanoseconds for the height at a place. */
struct QueryTimes
{
  double leaves = 0;  //!< TerrainMap::at(): height, normal and plane
  double cells = 0;   //!< a flat grid's cell: its height
};
QueryTimes queryTimes(const mrpt_mapconv::terrain::TerrainMap& map,
                      const mrpt_mapconv::grid::Layer<float>& cells);

}  // namespace mapconv
