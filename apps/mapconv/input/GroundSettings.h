#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>

#include <string>

#include "input/FieldFlags.h"

namespace mapconv
{
/** Reads section [ground] of an ini file, in which flags replace what they stand for; what is in
 * neither keeps its default. Warns about sections and keys that mean nothing here.
 * \param iniFile empty: none
 * \exception std::runtime_error in one line naming the file and what is wrong with it */
mrpt_mapconv::aerial::GroundParams readGroundParams(
    const std::string& iniFile, const FieldFlags<mrpt_mapconv::aerial::GroundParams>& flags);

}  // namespace mapconv
