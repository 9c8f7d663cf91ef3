#pragma once

#include <mrpt_mapconv/params/StrictSection.h>

#include <stdexcept>
#include <string>

#include "experiment/Experiments.h"

namespace mapconv
{
/** The path that a key `file` names, which is relative to the ini file's folder.
 * \exception std::runtime_error naming the section if there is no such key */
std::string readFile(mrpt_mapconv::params::StrictSection& section, const ExperimentJob& job);

/** Calls check(), whose complaint about a parameter then also names the section that it is of.
 * \exception std::runtime_error */
template <class Check>
void checkIn(const std::string& section, const Check& check)
{
  try
  {
    check();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("section '" + section + "': " + error.what());
  }
}

}  // namespace mapconv
