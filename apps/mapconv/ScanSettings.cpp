#include "ScanSettings.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/maps/MrptError.h>
#include <mrpt_mapconv/maps/StrictSection.h>

#include <stdexcept>

#include "Command.h"
#include "Console.h"
#include "IniFile.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using maps::StrictSection;
using mrpt::config::CConfigFileMemory;

namespace
{
const std::string kMap = "map", kInsertion = "insertion";

void write(const ScanFlags& flags, CConfigFileMemory& ini)
{
  if (flags.resolution) ini.write(kMap, "resolution", jsonNumber(*flags.resolution));
  if (!flags.model.empty()) ini.write(kInsertion, "model", flags.model);
  if (flags.noReflectionFilter) ini.write(kInsertion, "reflectionFilter", "false");
  if (flags.structure.empty()) return;
  ini.write(kInsertion, "structureMinZ", jsonNumber(flags.structure.at(0)));
  ini.write(kInsertion, "structureMaxZ", jsonNumber(flags.structure.at(1)));
}

/** The filter is on by default, but nobody knows where the ceiling is. */
void requireStructure(StrictSection insertion)
{
  bool filter = true;
  insertion.read("reflectionFilter", filter);
  if (!filter || insertion.has("structureMinZ") || insertion.has("structureMaxZ")) return;
  throw UsageError(
      "the reflection filter needs a slice of heights just under the ceiling: give --structure MIN "
      "MAX [m], or structureMinZ and structureMaxZ in section [insertion] of an ini file (-c), or "
      "do without the filter (--no-reflection-filter)");
}

/** The map itself knows which resolutions it can have. */
void checkResolution(double resolution)
try
{
  static_cast<void>(CScanShapeGridMap2D(resolution));
}
catch (const std::invalid_argument& error)
{
  throw std::runtime_error("section '" + kMap + "': " + error.what());
}

void readMap(StrictSection& section, ScanSettings& settings)
{
  section.read("resolution", settings.resolution);
  checkResolution(settings.resolution);
  section.read("maxGridCells", settings.maxGridCells);
  if (settings.maxGridCells < 1) section.fail("maxGridCells", ">= 1");
}

void warnUnknown(const StrictSection& section, const std::string& path)
{
  const std::string begin = path + ": [" + section.name() + "] unknown key '";
  for (const auto& key : section.unknownKeys())
    printWarning(std::string(begin).append(key).append("' has no effect"));
}

ScanSettings readSections(const CConfigFileMemory& ini, const std::string& path)
{
  ScanSettings settings;
  StrictSection map(ini, kMap), insertion(ini, kInsertion);
  readMap(map, settings);
  settings.insertion.readFrom(insertion);
  maps::readGridInsertionOptions(insertion, settings.insertion2D);
  warnUnknown(map, path);
  warnUnknown(insertion, path);
  return settings;
}
}  // namespace

ScanSettings readScanSettings(const std::string& iniFile, const ScanFlags& flags)
{
  CConfigFileMemory ini =
      iniFile.empty() ? CConfigFileMemory() : openIni(iniFile, {kInsertion, kMap});
  write(flags, ini);
  const std::string path = iniFile.empty() ? "the options" : iniFile;
  try
  {
    requireStructure({ini, kInsertion});
    return readSections(ini, path);
  }
  catch (const UsageError&)
  {
    throw;
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(path + ": " + maps::oneLine(error));
  }
}

std::string nameOf(scan::Model model)
{
  return model == scan::Model::WholeShape ? "wholeShape" : "closestPoint";
}

JsonObject settingsJson(const scan::ProfileParams& params)
{
  JsonObject json;
  json.add("model", nameOf(params.model));
  json.add("objectMinZ", params.objectMinZ).add("objectMaxZ", params.objectMaxZ);
  json.add("reflectionFilter", params.reflectionFilter);
  json.add("structureMinZ", params.structureMinZ).add("structureMaxZ", params.structureMaxZ);
  json.add("minRange", params.minRange).add("maxRange", params.maxRange);
  return json;
}

std::string settingsText(const scan::ProfileParams& params)
{
  const auto range = [](double low, double high)
  { return jsonNumber(low) + " to " + jsonNumber(high) + " m"; };
  return nameOf(params.model) + ", objects from " + range(params.objectMinZ, params.objectMaxZ) +
         (params.reflectionFilter
              ? ", walls from " + range(params.structureMinZ, params.structureMaxZ)
              : std::string(", no reflection filter"));
}

}  // namespace mapconv
