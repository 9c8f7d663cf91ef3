#include "IniFile.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/maps/MrptError.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "Console.h"

namespace mapconv
{
namespace
{
using mrpt::config::CConfigFileMemory;

std::string readText(const std::string& path)
{
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
    throw std::runtime_error(path + ": is a folder, not an ini file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened: " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/** MRPT passes over lines that it does not understand: a forgotten "=" would go unnoticed. */
void checkLines(const std::string& text)
{
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    const auto begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) continue;
    line = line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
    const bool comment = line[0] == ';' || line[0] == '#' || line.compare(0, 2, "//") == 0;
    const bool section = line[0] == '[' && line.find(']') != std::string::npos;
    const bool directive = line[0] == '@';  // MRPT's @define
    const auto equals = line.find('=');
    const bool entry = equals != std::string::npos && equals > 0;
    if (!comment && !section && !directive && !entry)
      throw std::runtime_error("line " + std::to_string(number) + ": '" + line +
                               "' is no section, comment or key = value");
  }
}

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
  const std::string text = readText(path);
  IniOptions options;
  try
  {
    checkLines(text);
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
