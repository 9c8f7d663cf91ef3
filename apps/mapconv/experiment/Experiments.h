#pragma once

#include <mrpt/config/CConfigFileBase.h>

#include <string>

#include "experiment/report/Report.h"
#include "output/Progress.h"

namespace mapconv
{
/** What an experiment is given. */
struct ExperimentJob
{
  const mrpt::config::CConfigFileBase& ini;
  std::string iniFile;  //!< paths in it are relative to its folder
  bool quick = false;   //!< a few scans and pairs, to see that it works
  Progress& progress;
};

/** Each runs one kind of experiment.
 * \exception std::exception in one line naming file, section and key, or what else failed @{ */
/** The tables of Fredriksson et al. 2024: speed, sizes and quality of the free-space projection,
 * and paths on its maps; and what floors that were seen make better, edges of drops among it.
 * Sections: see config/experiments/freespace.ini. */
void runFreespaceExperiment(const ExperimentJob& job, Report& report);

/** Table I of Mora et al. 2024: 2D maps of 3D scans with the whole shape of objects and without
 * reflections, against the true world. Sections: see config/experiments/scan_shape.ini. */
void runScanShapeExperiment(const ExperimentJob& job, Report& report);

/** The comparisons of Zhou et al. 2023: mapping time, errors of heights, leaves, planes and steps
 * of adaptive terrain maps, beside a per-cell elevation map, MRPT's grid and octomaps. Sections:
 * see config/experiments/terrain.ini. */
void runTerrainExperiment(const ExperimentJob& job, Report& report);

/** The ground below simulated forests and of the ISPRS samples (Sithole and Vosselman 2004): errors
 * of the filters' points, and of the maps' heights. Sections: see config/experiments/ground.ini. */
void runGroundExperiment(const ExperimentJob& job, Report& report);
/** @} */

}  // namespace mapconv
