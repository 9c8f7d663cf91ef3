#pragma once

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/freespace/ConversionOptions.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>

#include <string>
#include <vector>

namespace mapconv
{
/** What an ini file may set. */
struct IniOptions
{
  mrpt_mapconv::freespace::TConversionOptions conversion;  //!< section [conversion]
  mrpt_mapconv::voxel::TVoxelInsertionOptions insertion;   //!< section [insertion]
};

/** The text of an ini file as MRPT reads it. Warns about sections other than these.
 * \exception std::runtime_error in one line naming the file: missing, unreadable, or a line that is
 * no ini */
mrpt::config::CConfigFileMemory openIni(const std::string& path,
                                        const std::vector<std::string>& sections);

/** Reads an ini file; what is not in it keeps its default. Warns about sections and keys that mean
 * nothing here.
 * \exception std::runtime_error in one line naming the file and what is wrong with it: missing,
 * unreadable, a line that is no ini, or (with section, key and value) a value that is not valid */
IniOptions readIni(const std::string& path);

}  // namespace mapconv
