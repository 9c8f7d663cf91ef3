#pragma once

#include <vector>

#include "experiment/ground/GroundRun.h"
#include "experiment/report/Report.h"

namespace mapconv
{
/** Each adds a part of the report. @{ */
/** Errors of points and maps of all worlds, beside the limits, and where maps are wrong. */
void addForests(const std::vector<GroundResult>& results, const GroundExperimentSettings& settings,
                Report& report);
/** Errors of points of all samples. */
void addSamples(const std::vector<GroundResult>& results, Report& report);
/** @} */

}  // namespace mapconv
