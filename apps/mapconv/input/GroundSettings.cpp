#include "input/GroundSettings.h"

#include <mrpt_mapconv/params/Require.h>

#include <stdexcept>

#include "input/IniFile.h"

namespace mapconv
{
using namespace mrpt_mapconv;

aerial::GroundParams readGroundParams(const std::string& iniFile,
                                      const FieldFlags<aerial::GroundParams>& flags)
{
  const IniSection kGround{"ground"};
  mrpt::config::CConfigFileMemory ini(openIni(iniFile, {kGround}).getContent());
  flags.writeTo(ini, kGround.name);
  const std::string path = iniFile.empty() ? "the options" : iniFile;
  aerial::GroundParams params;
  try
  {
    readOptions(ini, kGround.name, path, params);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error(path + ": " + params::oneLine(error));
  }
  return params;
}

}  // namespace mapconv
