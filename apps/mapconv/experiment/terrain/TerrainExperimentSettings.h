#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/eval/PlaneMatch.h>
#include <mrpt_mapconv/terrain/TerrainOptions.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiment/Experiments.h"

namespace mapconv
{
/** A line over the steps of a flight of stairs, which are all judged. */
struct StairsLine
{
  std::string name;
  mrpt::math::TPoint2D from, to;  //!< [m]
};

/** A world of the experiment: one section of the ini file. */
struct TerrainWorld
{
  std::string name;                 //!< the section
  std::string file;                 //!< the simulator's world file
  std::vector<StairsLine> flights;  //!< in it
};

/** The paper's mapping times for our resolutions [s]. */
struct PaperTimes
{
  std::vector<double> theirs, elevationMapping, voxblox;
};

/** Scans of a real sensor. */
struct RealLog
{
  std::string file;  //!< a rawlog; one that is not there is left out
  bool staticSensor = false;
  std::vector<double> resolutions;            //!< [m]
  mrpt_mapconv::terrain::PointLimits limits;  //!< of its points
};

struct TerrainExperimentSettings
{
  std::vector<TerrainWorld> worlds;
  std::vector<double> resolutions;  //!< [m]
  std::vector<double> poseNoise;    //!< times the worlds'; with 1, which times are taken with
  std::uint32_t seed = 1;
  int repetitions = 1;            //!< of what is timed, of which the shortest counts
  int maxScans = 0;               //!< of a walk; 0: all
  double octoMapFrom = 0.05;      //!< finest resolution that octomaps are made at [m]
  int octoMapEvery = 1;           //!< every how manyth scan they get
  double judgedSteps = 0.02;      //!< coarsest resolution at which stairs have targets [m]
  double pictured = 0.02;         //!< resolution of pictures, and of tables of planes and steps [m]
  std::size_t largestPlanes = 6;  //!< of a world, whose residuals are shown
  mrpt_mapconv::terrain::TerrainParams params;  //!< of all maps
  double overlap = 0.8;                         //!< of planes that are the same
  PaperTimes paper;
  std::optional<RealLog> real;
};

/** \exception std::exception in one line naming section, key and value */
TerrainExperimentSettings readTerrainExperimentSettings(const ExperimentJob& job);

}  // namespace mapconv
