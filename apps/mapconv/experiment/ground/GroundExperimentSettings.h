#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/Experiments.h"

namespace mapconv
{
/** A simulated forest, and what errors its ground may be found with. */
struct GroundWorld
{
  std::string name, file;
  double typeI = 0, typeII = 0;  //!< at most
};

/** A cloud whose ground was classified by people. */
struct GroundSample
{
  std::string name, file, groundFile;
};

/** A way to find the ground. */
struct NamedFilter
{
  std::string name;
  mrpt_mapconv::aerial::GroundParams params;
};

/** An experiment's ini file. */
struct GroundExperimentSettings
{
  std::vector<GroundWorld> worlds;
  std::vector<GroundSample> samples;
  std::vector<NamedFilter> filters;
  std::string judged;  //!< the filter that has to keep the worlds' limits
  std::uint32_t seed = 1;
  std::int32_t threads = 1;  //!< of the filters; 0: all cores
  int everyScan = 1;         //!< of a flight, how manyth is taken
};

/** \exception std::runtime_error naming section, key and value, and what would be right */
GroundExperimentSettings readGroundExperimentSettings(const ExperimentJob& job);

}  // namespace mapconv
