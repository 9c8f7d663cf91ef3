#include "experiment/ground/GroundExperimentSettings.h"

#include <mrpt_mapconv/params/StrictSection.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "experiment/ExperimentIni.h"

namespace mapconv
{
using mrpt_mapconv::params::StrictSection;

namespace
{
constexpr int kQuick = 10;  // of a flight's scans, one of so many

const std::string kWorld = "world.", kSample = "sample.", kFilter = "filter.";

bool begins(const std::string& section, const std::string& prefix)
{
  return section.compare(0, prefix.size(), prefix) == 0;
}

std::string nameOf(const StrictSection& section)
{
  return section.name().substr(section.name().find('.') + 1);
}

void readShare(StrictSection& section, const std::string& key, double& share)
{
  if (!section.has(key))
    throw std::runtime_error("section '" + section.name() + "': " + key + " = SHARE is missing");
  section.read(key, share);
  if (!(share >= 0 && share <= 1)) section.fail(key, "a share, 0 to 1");
}

GroundWorld readWorld(StrictSection& section, const ExperimentJob& job)
{
  GroundWorld world{nameOf(section), readFile(section, job)};
  readShare(section, "typeI", world.typeI);
  readShare(section, "typeII", world.typeII);
  section.refuseUnknown("a world of this experiment");
  return world;
}

GroundSample readSample(StrictSection& section, const ExperimentJob& job)
{
  GroundSample sample{nameOf(section), readFile(section, job), readFile(section, job, "ground")};
  section.refuseUnknown("a sample of this experiment");
  return sample;
}

NamedFilter readFilter(StrictSection& section)
{
  NamedFilter filter{nameOf(section), {}};
  mrpt_mapconv::params::readFields(section, filter.params);
  section.refuseUnknown("a ground filter");
  section.checked([&] { filter.params.check(); });
  return filter;
}

void readRun(const ExperimentJob& job, GroundExperimentSettings& settings)
{
  StrictSection section(job.ini, "experiment");
  section.ignore("kind");
  section.read("seed", settings.seed);
  section.read("threads", settings.threads);
  if (settings.threads < 0) section.fail("threads", ">= 0 (0: all cores)");
  section.read("judged", settings.judged);
  if (std::none_of(settings.filters.begin(), settings.filters.end(),
                   [&](const NamedFilter& filter) { return filter.name == settings.judged; }))
    section.fail("judged", "the NAME of one of the sections filter.NAME");
  section.refuseUnknown("this experiment");
}
}  // namespace

GroundExperimentSettings readGroundExperimentSettings(const ExperimentJob& job)
{
  GroundExperimentSettings settings;
  std::vector<std::string> sections;
  job.ini.getAllSections(sections);
  for (const std::string& name : sections)
  {
    StrictSection section(job.ini, name);
    if (begins(name, kWorld))
      settings.worlds.push_back(readWorld(section, job));
    else if (begins(name, kSample))
      settings.samples.push_back(readSample(section, job));
    else if (begins(name, kFilter))
      settings.filters.push_back(readFilter(section));
    else if (name != "experiment")
      throw std::runtime_error("section '" + name +
                               "' means nothing here: it must be experiment, world.NAME, "
                               "sample.NAME or filter.NAME");
  }
  readRun(job, settings);
  if (settings.worlds.empty())
    throw std::runtime_error("section 'experiment': there is no world: a section world.NAME");
  if (job.quick) settings.everyScan = kQuick;
  return settings;
}

}  // namespace mapconv
