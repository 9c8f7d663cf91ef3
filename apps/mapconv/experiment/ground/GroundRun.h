#pragma once

#include <mrpt_mapconv/eval/GroundMapScore.h>
#include <mrpt_mapconv/eval/GroundScore.h>
#include <mrpt_mapconv/eval/LabelledCloud.h>

#include <optional>
#include <string>
#include <vector>

#include "experiment/ground/GroundExperimentSettings.h"

namespace mapconv
{
/** What a filter made of a cloud. */
struct GroundRun
{
  std::string filter;
  mrpt_mapconv::eval::GroundScore points;
  double seconds = 0;
  // where the whole ground is known, not only that of the points:
  mrpt_mapconv::eval::GroundMapScore map;
  mrpt_mapconv::grid::Layer<float> errors;  //!< of the map [m]
};

/** What all filters made of it. */
struct GroundResult
{
  std::string cloud;
  std::size_t points = 0;
  double groundShare = 0;  //!< of the points, in truth
  std::vector<GroundRun> runs;
};

/** Finds the ground of a forest, as it is seen from above, with all filters.
 * \exception std::exception in one line naming the file if it cannot be read */
GroundResult runForest(const GroundWorld& world, const GroundExperimentSettings& settings,
                       Progress& progress);

/** The same of a real cloud. */
GroundResult runSample(const GroundSample& sample, const GroundExperimentSettings& settings);

}  // namespace mapconv
