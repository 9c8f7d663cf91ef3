#pragma once

#include <mrpt_mapconv/maps/StrictSection.h>

#include <stdexcept>
#include <string>

namespace mrpt_mapconv::sim
{
/** Throws the one-line error for a key that nobody asked for, if there is one.
 * \param owner e.g. "a lidar" */
inline void refuseUnknownKeys(const maps::StrictSection& section, const std::string& owner)
{
  const auto keys = section.unknownKeys();
  if (keys.empty()) return;
  throw std::runtime_error("section '" + section.name() + "': '" + keys.front() +
                           "' is not a key of " + owner + ": correct its name or take it out");
}
}  // namespace mrpt_mapconv::sim
