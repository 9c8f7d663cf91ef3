#include "input/IniFile.h"

#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "output/Console.h"

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

CConfigFileMemory openIni(const std::string& path, const std::vector<std::string>& sections)
{
  CConfigFileMemory ini(mrpt_mapconv::params::readIniText(path));
  std::string known;
  for (const auto& section : sections) known += (known.empty() ? "[" : " and [") + section + "]";
  const std::string unknown = path + ": unknown section [";
  std::vector<std::string> present;
  ini.getAllSections(present);
  for (const auto& section : present)
    if (!contains(sections, section))
      printWarning(
          std::string(unknown).append(section).append("] has no effect; " + known + " do"));
  if (present.empty()) printWarning(path + ": has no section, so it changes nothing");
  return ini;
}

IniOptions readIni(const std::string& path)
{
  const CConfigFileMemory ini = openIni(path, {"conversion", "insertion"});
  IniOptions options;
  try
  {
    readSection(ini, "conversion", path, options.conversion);
    readSection(ini, "insertion", path, options.insertion);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(path + ": " + mrpt_mapconv::params::oneLine(error));
  }
  return options;
}

}  // namespace mapconv
