#pragma once

#include <mrpt_mapconv/params/StrictSection.h>

#include <string>

#include "experiment/Experiments.h"

namespace mapconv
{
/** The path that a key names, which is relative to the ini file's folder.
 * \exception std::runtime_error naming the section if there is no such key */
std::string readFile(mrpt_mapconv::params::StrictSection& section, const ExperimentJob& job,
                     const std::string& key = "file");

}  // namespace mapconv
