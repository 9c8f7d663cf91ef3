#include "experiment/ExperimentIni.h"

#include <filesystem>
#include <stdexcept>

namespace mapconv
{
std::string readFile(mrpt_mapconv::params::StrictSection& section, const ExperimentJob& job,
                     const std::string& key)
{
  std::string file;
  section.read(key, file);
  if (file.empty())
    throw std::runtime_error("section '" + section.name() + "': " + key + " = FILE is missing");
  return (std::filesystem::path(job.iniFile).parent_path() / file).string();
}

}  // namespace mapconv
