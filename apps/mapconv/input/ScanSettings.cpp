#include "input/ScanSettings.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "input/IniFile.h"
#include "input/UsageError.h"
#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using mrpt::config::CConfigFileMemory;
using params::StrictSection;

namespace
{
const IniSection kMap{"map"};
const IniSection kInsertion{"scanInsertion", "insertion"};

void writeSlice(const std::string& slice, const std::vector<double>& ends, CConfigFileMemory& ini,
                const std::string& section)
{
  if (ends.empty()) return;
  if (ends.at(0) >= ends.at(1))
    throw UsageError("--" + slice + " " + jsonNumber(ends[0]) + " " + jsonNumber(ends[1]) +
                     " is not valid: MIN must be below MAX");
  ini.write(section, slice + "MinZ", jsonNumber(ends[0]));
  ini.write(section, slice + "MaxZ", jsonNumber(ends[1]));
}

void write(const ScanFlags& flags, CConfigFileMemory& ini)
{
  const std::string insertion = nameIn(ini, kInsertion);
  flags.grid.writeTo(ini, kMap.name);
  flags.profile.writeTo(ini, insertion);
  if (flags.noReflectionFilter) ini.write(insertion, "reflectionFilter", "false");
  if (flags.no2D) ini.write(insertion, "insert2D", "false");
  writeSlice("object", flags.object, ini, insertion);
  writeSlice("structure", flags.structure, ini, insertion);
}

/** The filter is on by default, but nobody knows where the ceiling is. */
bool lacksStructure(StrictSection insertion)
{
  bool filter = true;
  insertion.read("reflectionFilter", filter);
  return filter && !insertion.has("structureMinZ") && !insertion.has("structureMaxZ");
}

void readMap(StrictSection& section, scan::ScanGridParams& grid)
{
  params::readFields(section, grid);
  section.checked([&] { grid::requireResolution(grid.resolution); });
  if (grid.maxGridCells < 1) section.fail("maxGridCells", ">= 1");
}

ScanSettings readSections(const CConfigFileMemory& ini, const std::string& path)
{
  ScanSettings settings;
  StrictSection map(ini, kMap.name), insertion(ini, nameIn(ini, kInsertion));
  readMap(map, settings.grid);
  settings.insertion.readFrom(insertion);
  maps::readGridInsertionOptions(insertion, settings.insertion2D);
  warnUnknownKeys(map, path);
  warnUnknownKeys(insertion, path);
  return settings;
}

/** The same; errors name the file. */
ScanSettings readNaming(const std::string& path, CConfigFileMemory& ini)
try
{
  const std::string insertion = nameIn(ini, kInsertion);
  const bool lacking = lacksStructure({ini, insertion});
  if (lacking) ini.write(insertion, "reflectionFilter", "false");
  ScanSettings settings = readSections(ini, path);
  settings.lacksStructure = lacking;
  return settings;
}
catch (const std::exception& error)
{
  throw std::runtime_error(path + ": " + params::oneLine(error));
}

/** Notes what is said of walls though none are looked for, and of 2D scans that are left out.
 * \param section of the file, without what flags say */
void noteUnused(const ScanSettings& settings, const StrictSection& section,
                const std::string& iniFile, const ScanFlags& flags, NoEffect& noEffect)
{
  const auto because = [&iniFile](bool flag, const std::string& name, const std::string& key)
  { return flag ? name : key + " = false of " + iniFile; };
  if (!settings.insertion.profile.reflectionFilter && !settings.lacksStructure)
  {
    const std::string why =
        because(flags.noReflectionFilter, "--no-reflection-filter", "reflectionFilter") +
        " looks for no walls";
    auto keys = changedKeys(section, settings.insertion.profile);
    const auto isUsed = [&flags](const std::string& key)
    {
      const bool replaced = !flags.structure.empty() && key.back() == 'Z';
      return key.compare(0, 9, "structure") != 0 || replaced;
    };
    keys.erase(std::remove_if(keys.begin(), keys.end(), isUsed), keys.end());
    if (!flags.structure.empty()) noEffect.add({"--structure"}, why);
    noEffect.addKeys(keys, iniFile, why);
  }
  if (!settings.insertion.insert2D)
    noEffect.addKeys(changedKeys(section, settings.insertion2D), iniFile,
                     because(flags.no2D, "--no-2d", "insert2D") + " leaves 2D scans out");
}

/** Where a value comes from, for people. */
template <class Params>
std::string originOf(const FieldFlags<Params>& flags, const StrictSection& section,
                     const std::string& key, const std::string& iniFile)
{
  if (flags.given(key)) return "is from " + flagName(key);
  return section.has(key) ? "is from " + iniFile : "is the default";
}

/** Cells so fine that maxRange is too many of them would only show at the first scan. */
void checkReach(const ScanSettings& settings, const CConfigFileMemory& ini,
                const std::string& iniFile, const ScanFlags& flags)
try
{
  settings.insertion.check(settings.grid.resolution);
}
catch (const std::invalid_argument& error)
{
  const std::string text =
      params::oneLine(error) + "; resolution " +
      originOf(flags.grid, {ini, kMap.name}, "resolution", iniFile) + ", maxRange " +
      originOf(flags.profile, {ini, nameIn(ini, kInsertion)}, "maxRange", iniFile);
  if (flags.grid.given("resolution") || flags.profile.given("maxRange")) throw UsageError(text);
  throw std::runtime_error(text);
}

/** The settings that are set, but the resolution, as texts in the order of their lists. */
std::vector<std::pair<std::string, std::string>> textsOf(const ScanSettings& settings)
{
  std::vector<std::pair<std::string, std::string>> texts{
      {"maxGridCells", params::textOf(settings.grid.maxGridCells)}};
  const auto add = [&texts](const char* key, const std::string& text)
  { texts.emplace_back(key, text); };
  params::forEachText(settings.insertion, add);
  params::forEachText(settings.insertion2D, add);
  return texts;
}
}  // namespace

ScanSettings readScanSettings(const std::string& iniFile, const ScanFlags& flags,
                              NoEffect& noEffect)
{
  const CConfigFileMemory file = openIni(iniFile, {kInsertion, kMap});
  CConfigFileMemory ini(file.getContent());
  write(flags, ini);
  const ScanSettings settings = readNaming(iniFile.empty() ? "the options" : iniFile, ini);
  checkReach(settings, ini, iniFile, flags);
  noteUnused(settings, {file, nameIn(file, kInsertion)}, iniFile, flags, noEffect);
  return settings;
}

void requireStructure(const ScanSettings& settings)
{
  if (!settings.lacksStructure) return;
  throw UsageError(
      "the reflection filter needs a slice of heights just under the ceiling: give --structure MIN "
      "MAX [m], or structureMinZ and structureMaxZ in section [scanInsertion] of an ini file (-c), "
      "or do without the filter (--no-reflection-filter)");
}

JsonObject settingsJson(const ScanSettings& settings)
{
  JsonObject json;
  json.add("maxGridCells", settings.grid.maxGridCells);
  addFields(settings.insertion, json);
  addFields(settings.insertion2D, json);
  return json;
}

std::string changedText(const ScanSettings& settings)
{
  const auto defaults = textsOf(ScanSettings());
  std::string changed;
  for (const auto& setting : textsOf(settings))
    if (std::find(defaults.begin(), defaults.end(), setting) == defaults.end())
      changed += (changed.empty() ? "" : ", ") + setting.first + " = " + setting.second;
  return changed;
}

}  // namespace mapconv
