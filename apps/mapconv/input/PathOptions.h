#pragma once

#include <mrpt_mapconv/path/LiftPath.h>

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "input/MapFolder.h"

namespace mapconv
{
/** What `plan` and `lift` share: a converted map, a robot, and how its path gets heights. */
struct PathOptions
{
  std::string dir, robot, outputFile;
  std::optional<double> heightOffset, lookahead, safetyRadius;
  bool unknownIsPassable = false;
  bool json = false;
};

/** `safetyDefault` tells in the help what --safety-radius is without being given. */
void addPathOptions(CLI::App& app, PathOptions& options, const std::string& safetyDefault);

/** Defaults: lookahead 0.5 m; heightOffset 0 for a ground robot, minClearance/2 for an aerial one.
 * \param safetyRadius [m], unless the options give one
 * \exception UsageError for the flag that is not valid */
mrpt_mapconv::path::LiftParams liftParamsOf(const PathOptions& options, const MapFolder& map,
                                            double safetyRadius);

/** \exception UsageError unless that is a name that ends in .csv */
void checkCsvName(const std::string& file);

}  // namespace mapconv
