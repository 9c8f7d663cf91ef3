#pragma once

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/freespace/ConversionOptions.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/voxel/VoxelInsertionOptions.h>

#include <map>
#include <string>
#include <vector>

#include "input/FieldFlags.h"

namespace mapconv
{
/** A section that an ini file (-c) may have. */
struct IniSection
{
  std::string name;
  std::string oldName = {};  //!< how it was called before; read with a warning
};

/** The text of an ini file as MRPT reads it. Warns about sections other than these, and about old
 * names.
 * \param path empty: no file, and no section
 * \exception std::runtime_error in one line naming the file: missing, unreadable, or a line that is
 * no ini */
mrpt::config::CConfigFileMemory openIni(const std::string& path,
                                        const std::vector<IniSection>& sections);
/** How the file calls a section: by its old name if only that is there. */
std::string nameIn(const mrpt::config::CConfigFileBase& ini, const IniSection& section);
/** Warns about keys that nobody has read, naming the file. */
void warnUnknownKeys(const mrpt_mapconv::params::StrictSection& section, const std::string& path);

/** Reads the fields of a struct that has a list of them, and warns about keys that it does not
 * have. \param path what warnings name \exception std::runtime_error, std::invalid_argument naming
 * section, key and value */
template <class Options>
void readOptions(const mrpt::config::CConfigFileBase& ini, const std::string& name,
                 const std::string& path, Options& options)
{
  mrpt_mapconv::params::StrictSection section(ini, name);
  mrpt_mapconv::params::readFields(section, options);
  section.checked([&options] { options.check(); });
  warnUnknownKeys(section, path);
}

/** The keys of a section that have other values than by default. */
template <class Options>
std::vector<std::string> changedKeys(const mrpt_mapconv::params::StrictSection& section,
                                     const Options& options)
{
  std::map<std::string, std::string> defaults;
  mrpt_mapconv::params::forEachText(
      Options(), [&defaults](const char* key, const std::string& text) { defaults[key] = text; });
  std::vector<std::string> keys;
  mrpt_mapconv::params::forEachText(options,
                                    [&](const char* key, const std::string& text)
                                    {
                                      if (section.has(key) && text != defaults[key])
                                        keys.emplace_back(key);
                                    });
  return keys;
}

/** What the ini file and the flags of `convert` and `project` may set. */
struct IniOptions
{
  mrpt_mapconv::freespace::TConversionOptions conversion;  //!< section [conversion]
  mrpt_mapconv::voxel::TVoxelInsertionOptions insertion;   //!< section [voxelInsertion]
  /** The keys to which the file gives other values than their defaults. @{ */
  std::vector<std::string> conversionKeys, insertionKeys;
  /** @} */
};

/** Reads an ini file, in which flags replace what they stand for; what is in neither keeps its
 * default. Warns about sections and keys that mean nothing here.
 * \param path empty: none
 * \exception std::runtime_error in one line naming the file and what is wrong with it: missing,
 * unreadable, a line that is no ini, or (with section, key and value) a value that is not valid */
IniOptions readIni(const std::string& path,
                   const FieldFlags<mrpt_mapconv::freespace::ConversionParams>& flags = {});

}  // namespace mapconv
