#pragma once

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/sim/World.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::test
{
/** A world from the text of its file, without section [world] if that is not looked at. */
inline sim::World worldOf(const std::string& text,
                          const std::vector<std::string>& otherSections = {})
{
  const bool complete = text.find("[world]") != std::string::npos;
  const std::string bounds = "[world]\nbounds = -50 -50 -10 50 50 20\n";
  const mrpt::config::CConfigFileMemory ini((complete ? "" : bounds) + text);
  return sim::World::fromIni(ini, otherSections);
}

inline std::vector<sim::Solid> solidsAt(const sim::World& world, double x, double y)
{
  std::vector<sim::Solid> solids;
  world.solidsAt(x, y, solids);
  return solids;
}
}  // namespace mrpt_mapconv::test
