#include "input/TerrainSettings.h"

#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "input/IniFile.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using mrpt::config::CConfigFileMemory;
using params::StrictSection;

namespace
{
const IniSection kMap{"map"};
const IniSection kInsertion{"terrainInsertion"};
const IniSection kTerrain{"terrain"};

/** Keys and flags for the robot's pose, which logs with covariances make useless. */
std::vector<std::string> poseSigmas(const CConfigFileMemory& file, const std::string& path,
                                    const TerrainFlags& flags)
{
  std::vector<std::string> given;
  const StrictSection section(file, kInsertion.name);
  for (const char* key : {"heightSigma", "rollSigma", "pitchSigma"})
    if (flags.insertion.given(key))
      given.push_back(flagName(key));
    else if (section.has(key))
      given.push_back(std::string(key) + " of " + path);
  return given;
}

/** The settings but the resolution as texts in the order of their lists. */
std::vector<std::pair<std::string, std::string>> textsOf(const TerrainSettings& settings)
{
  std::vector<std::pair<std::string, std::string>> texts{
      {"maxGridCells", params::textOf(settings.grid.maxGridCells)}};
  const auto add = [&texts](const char* key, const std::string& text)
  { texts.emplace_back(key, text); };
  params::forEachText(settings.insertion, add);
  params::forEachText(settings.terrain, add);
  return texts;
}
}  // namespace

TerrainSettings readTerrainSettings(const std::string& iniFile, const TerrainFlags& flags)
{
  const CConfigFileMemory file = openIni(iniFile, {kInsertion, kMap, kTerrain});
  CConfigFileMemory ini(file.getContent());
  flags.grid.writeTo(ini, kMap.name);
  flags.insertion.writeTo(ini, kInsertion.name);
  flags.terrain.writeTo(ini, kTerrain.name);
  const std::string path = iniFile.empty() ? "the options" : iniFile;
  TerrainSettings settings;
  try
  {
    readOptions(ini, kMap.name, path, settings.grid);
    readOptions(ini, kInsertion.name, path, settings.insertion);
    readOptions(ini, kTerrain.name, path, settings.terrain);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(path + ": " + params::oneLine(error));
  }
  settings.poseSigmas = poseSigmas(file, iniFile, flags);
  return settings;
}

JsonObject settingsJson(const TerrainSettings& settings)
{
  JsonObject json;
  json.add("maxGridCells", settings.grid.maxGridCells);
  addFields(settings.insertion, json);
  addFields(settings.terrain, json);
  return json;
}

std::string changedText(const TerrainSettings& settings)
{
  const auto defaults = textsOf(TerrainSettings());
  std::string changed;
  for (const auto& setting : textsOf(settings))
    if (std::find(defaults.begin(), defaults.end(), setting) == defaults.end())
      changed += (changed.empty() ? "" : ", ") + setting.first + " = " + setting.second;
  return changed;
}

}  // namespace mapconv
