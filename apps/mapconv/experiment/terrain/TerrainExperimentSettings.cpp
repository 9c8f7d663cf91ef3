#include "experiment/terrain/TerrainExperimentSettings.h"

#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "experiment/ExperimentIni.h"

namespace mapconv
{
using mrpt_mapconv::params::StrictSection;

namespace
{
const std::string kFlight = "flight.";

std::vector<std::string> readWords(StrictSection& section, const std::string& key)
{
  std::string text;
  section.read(key, text);
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

/** \exception std::runtime_error unless they are different, and ascending from above 0 */
void readResolutions(StrictSection& section, std::vector<double>& resolutions)
{
  section.read("resolutions", resolutions);
  double last = 0;
  for (const double resolution : resolutions)
  {
    if (!(resolution > last)) section.fail("resolutions", "ascending numbers > 0 [m]");
    last = resolution;
  }
  if (resolutions.empty())
    throw std::runtime_error("section '" + section.name() + "': resolutions = M… is missing");
}

void readNoise(StrictSection& section, std::vector<double>& factors)
{
  section.read("poseNoise", factors);
  const bool hasOne = std::count(factors.begin(), factors.end(), 1) > 0;
  if (!hasOne || *std::min_element(factors.begin(), factors.end()) < 0 ||
      std::set<double>(factors.begin(), factors.end()).size() != factors.size())
    section.fail("poseNoise", "different numbers >= 0, with 1 among them");
}

template <class Number>
void readAtLeast(StrictSection& section, const std::string& key, Number least, Number& value)
{
  section.read(key, value);
  if (!(value >= least)) section.fail(key, ">= " + std::to_string(least));
}

/** \return the names of the worlds */
std::vector<std::string> readRun(const ExperimentJob& job, TerrainExperimentSettings& settings)
{
  StrictSection section(job.ini, "experiment");
  section.ignore("kind");
  auto worlds = readWords(section, "worlds");
  if (worlds.empty()) throw std::runtime_error("section 'experiment': worlds = NAME… is missing");
  if (std::set<std::string>(worlds.begin(), worlds.end()).size() != worlds.size())
    section.fail("worlds", "each world once");
  readResolutions(section, settings.resolutions);
  readNoise(section, settings.poseNoise);
  section.read("seed", settings.seed);
  readAtLeast(section, "repetitions", 1, settings.repetitions);
  readAtLeast(section, "maxScans", 0, settings.maxScans);
  section.read("octoMapFrom", settings.octoMapFrom);
  readAtLeast(section, "octoMapEvery", 1, settings.octoMapEvery);
  section.read("judgedSteps", settings.judgedSteps);
  section.read("pictured", settings.pictured);
  section.read("overlap", settings.overlap);
  if (!(settings.overlap > 0.5 && settings.overlap <= 1))
    section.fail("overlap", "a share above 0.5, up to 1");
  section.refuseUnknown("this experiment");
  return worlds;
}

void readParams(const ExperimentJob& job, TerrainExperimentSettings& settings)
{
  StrictSection section(job.ini, "terrain");
  if (section.has("heightRule")) section.fail("heightRule", "left out: both rules are tried");
  if (section.has("localWindow")) section.fail("localWindow", "left out: all of a world is judged");
  mrpt_mapconv::params::readFields(section, settings.params);
  section.refuseUnknown("a terrain map");
  section.checked([&] { settings.params.check(); });
}

void readPaper(const ExperimentJob& job, TerrainExperimentSettings& settings)
{
  StrictSection section(job.ini, "paper");
  const auto read = [&](const std::string& key, std::vector<double>& seconds)
  {
    section.read(key, seconds);
    if (seconds.size() != settings.resolutions.size())
      section.fail(key, "a time for each resolution in section 'experiment' [s]");
  };
  read("theirs", settings.paper.theirs);
  read("elevationMapping", settings.paper.elevationMapping);
  read("voxblox", settings.paper.voxblox);
  section.refuseUnknown("the paper's table");
}

TerrainWorld readWorld(const ExperimentJob& job, const std::string& name)
{
  if (!job.ini.sectionExists(name))
    throw std::runtime_error("section 'experiment': worlds names '" + name +
                             "', but there is no such section");
  StrictSection section(job.ini, name);
  TerrainWorld world{name, readFile(section, job), {}};
  section.refuseUnknown("a world of this experiment");
  return world;
}

void readFlight(const ExperimentJob& job, const std::string& name,
                TerrainExperimentSettings& settings)
{
  StrictSection section(job.ini, name);
  std::string world;
  section.read("world", world);
  const auto at = std::find_if(settings.worlds.begin(), settings.worlds.end(),
                               [&](const TerrainWorld& w) { return w.name == world; });
  if (at == settings.worlds.end()) section.fail("world", "one of the experiment's worlds");
  std::vector<double> line;
  section.read("line", line);
  if (line.size() != 4 || (line[0] == line[2] && line[1] == line[3]))
    section.fail("line", "x y of its start and of its end [m]");
  section.refuseUnknown("a flight of stairs");
  at->flights.push_back({name.substr(kFlight.size()), {line[0], line[1]}, {line[2], line[3]}});
}

void readReal(const ExperimentJob& job, TerrainExperimentSettings& settings)
{
  if (!job.ini.sectionExists("real")) return;
  StrictSection section(job.ini, "real");
  RealLog real;
  real.file = readFile(section, job);
  section.read("staticSensor", real.staticSensor);
  readResolutions(section, real.resolutions);
  mrpt_mapconv::params::readFields(section, real.limits);
  section.checked([&] { real.limits.check(); });
  section.refuseUnknown("a real log");
  settings.real = real;
}

/** Flights, and whether all other sections mean something. */
void readOthers(const ExperimentJob& job, const std::vector<std::string>& worlds,
                TerrainExperimentSettings& settings)
{
  std::set<std::string> known(worlds.begin(), worlds.end());
  known.insert({"experiment", "terrain", "paper", "real"});
  std::vector<std::string> sections;
  job.ini.getAllSections(sections);
  for (const std::string& name : sections)
    if (name.rfind(kFlight, 0) == 0)
      readFlight(job, name, settings);
    else if (known.count(name) == 0)
      throw std::runtime_error("section '" + name +
                               "' means nothing in this experiment: correct its name or take it "
                               "out");
}

/** A few scans, and no resolution at which the truth alone takes long. */
void makeQuick(TerrainExperimentSettings& settings)
{
  constexpr double kFinest = 0.05;  // [m]
  const auto fine = static_cast<std::ptrdiff_t>(
      std::count_if(settings.resolutions.begin(), settings.resolutions.end(),
                    [](double resolution) { return resolution < kFinest; }));
  for (auto* list : {&settings.resolutions, &settings.paper.theirs,
                     &settings.paper.elevationMapping, &settings.paper.voxblox})
    list->erase(list->begin(), list->begin() + fine);
  settings.maxScans = 12;
  settings.repetitions = 1;
  settings.pictured = kFinest;
  settings.judgedSteps = kFinest;
}
}  // namespace

TerrainExperimentSettings readTerrainExperimentSettings(const ExperimentJob& job)
{
  TerrainExperimentSettings settings;
  const auto worlds = readRun(job, settings);
  readParams(job, settings);
  readPaper(job, settings);
  for (const std::string& name : worlds) settings.worlds.push_back(readWorld(job, name));
  readReal(job, settings);
  readOthers(job, worlds, settings);
  if (job.quick) makeQuick(settings);
  return settings;
}

}  // namespace mapconv
