#pragma once

#include <mrpt/config/CConfigFileBase.h>

#include <string>

#include "Progress.h"
#include "Report.h"

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

/** The tables of Fredriksson et al. 2024: speed, sizes and quality of the free-space projection,
 * and paths on its maps. Sections: see config/experiments/freespace.ini.
 * \exception std::exception in one line naming file, section and key, or what else failed */
void runFreespaceExperiment(const ExperimentJob& job, Report& report);

}  // namespace mapconv
