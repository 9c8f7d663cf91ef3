#include "input/IniFile.h"

#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <stdexcept>

#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using mrpt::config::CConfigFileBase;
using mrpt::config::CConfigFileMemory;

namespace
{
const IniSection kConversion{"conversion"};
const IniSection kVoxelInsertion{"voxelInsertion", "insertion"};

std::string listOf(const std::vector<IniSection>& sections)
{
  std::string list;
  for (const auto& section : sections) list += (list.empty() ? "[" : " and [") + section.name + "]";
  return list;
}

/** What is wrong with a section's name; empty if nothing is. */
std::string complaintAbout(const std::string& name, const std::vector<IniSection>& sections,
                           const CConfigFileBase& ini)
{
  for (const auto& section : sections)
  {
    if (name == section.name) return "";
    if (section.oldName.empty() || name != section.oldName) continue;
    if (nameIn(ini, section) == section.name)
      return "section [" + name + "] has no effect beside [" + section.name +
             "], which is its new name";
    return "section [" + name + "] is now called [" + section.name + "]; the old name still works";
  }
  return "unknown section [" + name + "] has no effect; " + listOf(sections) + " do";
}

/** Reads one section into `options`, which must be valid in the end.
 * \return the keys that it changes */
template <class Options>
std::vector<std::string> readSection(const CConfigFileMemory& ini, const IniSection& name,
                                     const std::string& path, Options& options)
{
  params::StrictSection section(ini, nameIn(ini, name));
  params::readFields(section, options);
  section.checked([&options] { options.check(); });
  warnUnknownKeys(section, path);
  return changedKeys(section, options);
}
}  // namespace

CConfigFileMemory openIni(const std::string& path, const std::vector<IniSection>& sections)
{
  if (path.empty()) return {};
  CConfigFileMemory ini(params::readIniText(path));
  std::vector<std::string> present;
  ini.getAllSections(present);
  for (const auto& name : present)
    if (const auto complaint = complaintAbout(name, sections, ini); !complaint.empty())
      printWarning(std::string(path).append(": ").append(complaint));
  if (present.empty()) printWarning(path + ": has no section, so it changes nothing");
  return ini;
}

std::string nameIn(const CConfigFileBase& ini, const IniSection& section)
{
  const bool onlyOld = !section.oldName.empty() && !ini.sectionExists(section.name) &&
                       ini.sectionExists(section.oldName);
  return onlyOld ? section.oldName : section.name;
}

void warnUnknownKeys(const params::StrictSection& section, const std::string& path)
{
  const std::string begin = path + ": [" + section.name() + "] unknown key '";
  for (const auto& key : section.unknownKeys())
    printWarning(std::string(begin).append(key).append("' has no effect"));
}

IniOptions readIni(const std::string& path, const FieldFlags<freespace::ConversionParams>& flags)
{
  const CConfigFileMemory ini = openIni(path, {kConversion, kVoxelInsertion});
  IniOptions options;
  try
  {
    options.conversionKeys = readSection(ini, kConversion, path, options.conversion);
    options.insertionKeys = readSection(ini, kVoxelInsertion, path, options.insertion);
    flags.applyTo(options.conversion.params);
    options.conversion.check();
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error((path.empty() ? "the options" : path) + ": " + params::oneLine(error));
  }
  return options;
}

}  // namespace mapconv
