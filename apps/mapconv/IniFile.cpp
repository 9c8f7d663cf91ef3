#include "IniFile.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/maps/IniText.h>
#include <mrpt_mapconv/maps/MrptError.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "Console.h"

namespace mapconv
{
namespace
{
using mrpt::config::CConfigFileMemory;

std::vector<std::string> keysOf(const CConfigFileMemory& ini, const std::string& section)
{
  std::vector<std::string> keys;
  ini.getAllKeys(section, keys);
  return keys;
}

bool contains(const std::vector<std::string>& list, const std::string& text)
{
  return std::find(list.begin(), list.end(), text) != list.end();
}

/** Reads one section into `options`; the keys that they know are those that they save. */
template <class Options>
void readSection(const CConfigFileMemory& ini, const std::string& section, const std::string& path,
                 Options& options)
{
  const std::string where = path + ": [" + section + "] unknown key '";
  CConfigFileMemory defaults, known;
  options.saveToConfigFile(defaults, section);
  const auto knownKeys = keysOf(defaults, section);
  for (const auto& key : keysOf(ini, section))
  {
    if (contains(knownKeys, key))
      known.write(section, key, ini.read_string(section, key, ""));
    else
      printWarning(std::string(where).append(key).append("' has no effect"));
  }
  options.loadFromConfigFile(known, section);
}
}  // namespace

IniOptions readIni(const std::string& path)
{
  const std::string text = mrpt_mapconv::maps::readIniText(path);
  IniOptions options;
  try
  {
    const CConfigFileMemory ini(text);
    const std::string unknown = path + ": unknown section [";
    std::vector<std::string> sections;
    ini.getAllSections(sections);
    for (const auto& section : sections)
      if (section != "conversion" && section != "insertion")
        printWarning(std::string(unknown).append(section).append(
            "] has no effect; [conversion] and [insertion] do"));
    if (sections.empty()) printWarning(path + ": has no section, so it changes nothing");
    readSection(ini, "conversion", path, options.conversion);
    readSection(ini, "insertion", path, options.insertion);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(path + ": " + mrpt_mapconv::maps::oneLine(error));
  }
  return options;
}

}  // namespace mapconv
