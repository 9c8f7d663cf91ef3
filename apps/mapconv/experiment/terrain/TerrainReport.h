#pragma once

#include <vector>

#include "experiment/report/Report.h"
#include "experiment/terrain/RealTerrain.h"
#include "experiment/terrain/TerrainRun.h"

namespace mapconv
{
/** How heights and methods are called in the report. @{ */
const PerTerrainHeights<std::string>& heightsNames();
const PerTerrainMethod<std::string>& methodNames();
/** @} */

/** "0.05". */
std::string metres(double value);
/** Millimetres of metres, with two decimals. */
std::string millimetres(double value);

/** Each adds a part of the report. @{ */
/** Mapping times, beside the paper's. */
void addTimes(const TerrainResults& results, const TerrainExperimentSettings& settings,
              Report& report);
/** Errors of heights against the truth, with each noise of poses, and plane by plane. */
void addHeightErrors(const TerrainResults& results, const TerrainExperimentSettings& settings,
                     Report& report);
/** Leaves, memory and queries beside the flat grid. */
void addSizes(const TerrainResults& results, Report& report);
/** Recall and precision of planes. */
void addPlanes(const TerrainResults& results, const TerrainExperimentSettings& settings,
               Report& report);
/** Heights and depths of steps. */
void addSteps(const TerrainResults& results, const TerrainExperimentSettings& settings,
              Report& report);
/** Residuals of real scans to planes. */
void addRealScans(const std::vector<RealTerrain>& runs, Report& report);
/** Maps, histograms of errors, and profiles of stairs. */
void addPictures(const TerrainResults& results, Report& report);
/** @} */

}  // namespace mapconv
