#include "input/MapCounts.h"

#include <mrpt/config/CConfigFile.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "output/Console.h"

namespace mapconv
{
namespace
{
const std::string kSuffix = "_count";

/** The map's name in a key NAME_count; empty for other keys. */
std::string mapOf(const std::string& key)
{
  if (key.size() <= kSuffix.size()) return "";
  const auto length = key.size() - kSuffix.size();
  return key.compare(length, kSuffix.size(), kSuffix) == 0 ? key.substr(0, length) : "";
}

bool isRegistered(const std::string& map)
{
  return mrpt::maps::internal::TMetricMapTypesRegistry::Instance().getAllRegistered().count(map) !=
         0;
}

/** Other things can be counted as well: it is a map if it has sections of its own or stands beside
 * maps. */
bool isMeantAsMap(const std::string& map, const std::string& section,
                  const std::vector<std::string>& sections, const std::vector<std::string>& keys)
{
  const std::string prefix = section + "_" + map + "_";
  return std::any_of(sections.begin(), sections.end(),
                     [&](const std::string& s) { return s.rfind(prefix, 0) == 0; }) ||
         std::any_of(keys.begin(), keys.end(),
                     [&](const std::string& key) { return isRegistered(mapOf(key)); });
}
}  // namespace

void warnUnknownMaps(const std::string& iniFile)
{
  if (!std::filesystem::is_regular_file(iniFile)) return;
  const mrpt::config::CConfigFile ini(iniFile);
  std::vector<std::string> sections;
  ini.getAllSections(sections);
  for (const auto& section : sections)
  {
    std::vector<std::string> keys;
    ini.getAllKeys(section, keys);
    for (const auto& key : keys)
    {
      const std::string map = mapOf(key);
      if (map.empty() || isRegistered(map) || !isMeantAsMap(map, section, sections, keys)) continue;
      printWarning(iniFile + ": section '" + section + "': " + key + ": there is no map class '" +
                   map + "'; MRPT ignores it");
    }
  }
}

}  // namespace mapconv
