#pragma once

#include <mrpt_mapconv/eval/TrueSteps.h>

#include <string>
#include <vector>

#include "output/Json.h"

namespace mapconv
{
/** True steps with those of a map, as a table with a header [m]; empty: none. */
std::string stepMatchesCsv(const std::vector<mrpt_mapconv::eval::StepMatch>& steps);
/** Lines of a summary, one a step. */
std::string stepMatchesText(const std::vector<mrpt_mapconv::eval::StepMatch>& steps);
/** How many there are and were found, and the worst errors [m]. */
void addStepMatches(const std::vector<mrpt_mapconv::eval::StepMatch>& steps, JsonObject& json);

}  // namespace mapconv
