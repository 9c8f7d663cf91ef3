#include "input/ScanSettings.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/bits_math.h>
#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <array>
#include <charconv>
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
const std::string kMap = "map", kInsertion = "insertion";

void write(const ScanFlags& flags, CConfigFileMemory& ini)
{
  if (flags.resolution) ini.write(kMap, "resolution", jsonNumber(*flags.resolution));
  if (!flags.model.empty()) ini.write(kInsertion, "model", flags.model);
  if (flags.noReflectionFilter) ini.write(kInsertion, "reflectionFilter", "false");
  if (flags.no2D) ini.write(kInsertion, "insert2D", "false");
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

/** The same; errors name the file. */
ScanSettings readNaming(const std::string& path, const CConfigFileMemory& ini)
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
  throw std::runtime_error(path + ": " + params::oneLine(error));
}

std::string originOf(const StrictSection& section, const std::string& key,
                     const std::string& iniFile)
{
  return section.has(key) ? "is from " + iniFile : "is the default";
}

/** Cells so fine that maxRange is too many of them would only show at the first scan. */
void checkReach(const ScanSettings& settings, const CConfigFileMemory& ini,
                const std::string& iniFile, const ScanFlags& flags)
try
{
  settings.insertion.check(settings.resolution);
}
catch (const std::invalid_argument& error)
{
  const std::string resolution =
      flags.resolution ? "is from --resolution" : originOf({ini, kMap}, "resolution", iniFile);
  const std::string text = params::oneLine(error) + "; resolution " + resolution + ", maxRange " +
                           originOf({ini, kInsertion}, "maxRange", iniFile);
  if (flags.resolution) throw UsageError(text);
  throw std::runtime_error(text);
}

/** The double that is written as briefly as the float is: 0.65 and not 0.6499999761581421. */
double asWritten(float value)
{
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = 0;
  std::from_chars(text.data(), end, number);
  return number;
}

template <class Visitor>
void visitProfile(const scan::ProfileParams& params, const Visitor& visitor)
{
  visitor("model", scan::nameOf(params.model));
  visitor("objectMinZ", params.objectMinZ);
  visitor("objectMaxZ", params.objectMaxZ);
  visitor("reflectionFilter", params.reflectionFilter);
  visitor("structureMinZ", params.structureMinZ);
  visitor("structureMaxZ", params.structureMaxZ);
  visitor("minRange", params.minRange);
  visitor("maxRange", params.maxRange);
  visitor("sectors", params.sectors);
  visitor("structureGap",
          params.structureGap < 0 ? params.structureGap : mrpt::RAD2DEG(params.structureGap));
  visitor("structureTolerance", params.structureTolerance);
}

template <class Visitor>
void visitUpdate(const scan::UpdateParams& params, const Visitor& visitor)
{
  visitor("pHit", params.pHit);
  visitor("pMiss", params.pMiss);
  visitor("pMin", params.pMin);
  visitor("pMax", params.pMax);
}

template <class Visitor>
void visit2D(const mrpt::maps::COccupancyGridMap2D::TInsertionOptions& options,
             const Visitor& visitor)
{
  visitor("mapAltitude", asWritten(options.mapAltitude));
  visitor("useMapAltitude", options.useMapAltitude);
  visitor("maxDistanceInsertion", asWritten(options.maxDistanceInsertion));
  visitor("maxOccupancyUpdateCertainty", asWritten(options.maxOccupancyUpdateCertainty));
  visitor("maxFreenessUpdateCertainty", asWritten(options.maxFreenessUpdateCertainty));
  visitor("maxFreenessInvalidRanges", asWritten(options.maxFreenessInvalidRanges));
  visitor("considerInvalidRangesAsFreeSpace", options.considerInvalidRangesAsFreeSpace);
  visitor("decimation", static_cast<std::int32_t>(options.decimation));
  visitor("horizontalTolerance", asWritten(mrpt::RAD2DEG(options.horizontalTolerance)));
  visitor("CFD_features_gaussian_size", asWritten(options.CFD_features_gaussian_size));
  visitor("CFD_features_median_size", asWritten(options.CFD_features_median_size));
  visitor("wideningBeamsWithDistance", options.wideningBeamsWithDistance);
}

/** Shows a visitor(key, value) every setting of the ini file but the resolution. */
template <class Visitor>
void visit(const ScanSettings& settings, const Visitor& visitor)
{
  visitor("maxGridCells", settings.maxGridCells);
  visitProfile(settings.insertion.profile, visitor);
  visitUpdate(settings.insertion.update, visitor);
  visitor("insert2D", settings.insertion.insert2D);
  visit2D(settings.insertion2D, visitor);
}

std::string textOf(const std::string& value) { return value; }
std::string textOf(bool value) { return value ? "true" : "false"; }
std::string textOf(double value) { return jsonNumber(value); }
std::string textOf(std::int32_t value) { return std::to_string(value); }

std::vector<std::pair<std::string, std::string>> valuesOf(const ScanSettings& settings)
{
  std::vector<std::pair<std::string, std::string>> values;
  visit(settings,
        [&values](const char* key, const auto& value) { values.emplace_back(key, textOf(value)); });
  return values;
}
}  // namespace

ScanSettings readScanSettings(const std::string& iniFile, const ScanFlags& flags)
{
  CConfigFileMemory ini =
      iniFile.empty() ? CConfigFileMemory() : openIni(iniFile, {kInsertion, kMap});
  write(flags, ini);
  const ScanSettings settings = readNaming(iniFile.empty() ? "the options" : iniFile, ini);
  checkReach(settings, ini, iniFile, flags);
  return settings;
}

JsonObject settingsJson(const ScanSettings& settings)
{
  JsonObject json;
  visit(settings, [&json](const char* key, const auto& value) { json.add(key, value); });
  return json;
}

std::string changedText(const ScanSettings& settings)
{
  const auto values = valuesOf(settings), defaults = valuesOf(ScanSettings());
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] != defaults[i])
      text += (text.empty() ? "" : ", ") + values[i].first + " = " + values[i].second;
  return text;
}

JsonObject settingsJson(const scan::ProfileParams& params)
{
  JsonObject json;
  visitProfile(params, [&json](const char* key, const auto& value) { json.add(key, value); });
  return json;
}

std::string settingsText(const scan::ProfileParams& params)
{
  const auto range = [](double low, double high)
  { return jsonNumber(low) + " to " + jsonNumber(high) + " m"; };
  return scan::nameOf(params.model) + ", objects from " +
         range(params.objectMinZ, params.objectMaxZ) +
         (params.reflectionFilter
              ? ", walls from " + range(params.structureMinZ, params.structureMaxZ)
              : std::string(", no reflection filter"));
}

}  // namespace mapconv
