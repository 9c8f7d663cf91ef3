#pragma once

#include <mrpt_mapconv/eval/PlaneMatch.h>
#include <mrpt_mapconv/eval/TerrainErrors.h>
#include <mrpt_mapconv/eval/TrueSteps.h>

#include <string>
#include <utility>
#include <vector>

#include "experiment/terrain/TerrainMappings.h"

namespace mapconv
{
/** Errors of heights with some noise of poses. */
struct NoiseErrors
{
  double noise = 0;  //!< times the world's
  /** In cells that all maps know, away from jumps and within a cell of them. */
  PerTerrainHeights<mrpt_mapconv::eval::ErrorSummary> clear, apart;
  /** In those that no noise of ranges reaches across a jump. */
  PerTerrainHeights<mrpt_mapconv::eval::ErrorSummary> far;
};

/** A true step, and the one that a map has for it. */
struct JudgedStep : mrpt_mapconv::eval::StepMatch
{
  std::string flight;
};

/** Errors in the cells of a true plane, away from jumps. */
struct PlaneErrors
{
  mrpt_mapconv::terrain::TerrainPlane plane;
  PerTerrainHeights<mrpt_mapconv::eval::ErrorSummary> errors;
};

/** What became of the cells of one of our maps. */
struct AdaptiveMap
{
  std::size_t cells = 0, leaves = 0, memory = 0;  //!< [bytes]
  std::size_t planes = 0;
  mrpt_mapconv::eval::Agreement match;
  std::vector<JudgedStep> steps;  //!< of all flights
};

/** A world at one resolution. */
struct TerrainRun
{
  double resolution = 0;  //!< [m]
  PerTerrainMethod<double> seconds{};
  std::vector<NoiseErrors> errors;  //!< of each noise
  // with the world's noise of poses:
  AdaptiveMap fused, maximum;
  std::size_t elevationCells = 0, elevationMemory = 0;  //!< [bytes]
  QueryTimes queries;
  std::vector<PlaneErrors> planes;  //!< the largest, by their judged cells
  // only at the resolution of pictures; else empty:
  mrpt_mapconv::terrain::TerrainLayers layers;
  PerTerrainHeights<mrpt_mapconv::grid::Layer<float>> heights;
  mrpt_mapconv::eval::TerrainTruth truth;
};

/** All of a world. */
struct TerrainWorldResult
{
  TerrainWorld world;
  std::size_t scans = 0, points = 0;
  std::vector<TerrainRun> runs;  //!< of each resolution
};
using TerrainResults = std::vector<TerrainWorldResult>;

/** Maps a walk at one resolution in all ways, and judges the maps. */
TerrainRun runTerrain(const TerrainWalk& walk, const TerrainWorld& world, double resolution,
                      const TerrainExperimentSettings& settings, Progress& progress);

}  // namespace mapconv
