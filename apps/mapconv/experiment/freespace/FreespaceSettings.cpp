#include "experiment/freespace/FreespaceSettings.h"

#include <mrpt_mapconv/params/StrictSection.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "experiment/ExperimentIni.h"

namespace mapconv
{
using mrpt_mapconv::freespace::ConversionParams;
using mrpt_mapconv::freespace::FloorFrom;
using mrpt_mapconv::params::StrictSection;

namespace
{
std::vector<std::string> words(const std::string& text)
{
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

std::vector<std::string> readWords(StrictSection& section, const std::string& key)
{
  std::string text;
  section.read(key, text);
  return words(text);
}

ConversionParams readConversion(const ExperimentJob& job, const std::string& name)
{
  ConversionParams params;
  StrictSection section(job.ini, name);
  mrpt_mapconv::params::readFields(section, params);
  section.refuseUnknown("a conversion");
  section.checked([&] { params.check(); });
  return params;
}

/** Section [strictConversion], with the keys of a world's section in place of its own. */
ConversionParams readStrict(const ExperimentJob& job, StrictSection& world)
{
  ConversionParams params = readConversion(job, "strictConversion");
  mrpt_mapconv::params::readFields(world, params);
  world.checked([&] { params.check(); });
  for (const StrictSection& section : {StrictSection(job.ini, "strictConversion"), world})
    if (section.has("floorFrom") && params.floorFrom != FloorFrom::LowestFree)
      section.fail("floorFrom", "lowestFree, which the rows 'seen' are compared with");
  return params;
}

PaperFigures readPaper(StrictSection& section)
{
  PaperFigures paper;
  section.read("paperFullRatio", paper.fullRatio);
  section.read("paperPartialRatio", paper.partialRatio);
  section.read("paperSizes", paper.sizes);
  if (paper.sizes.size() != 3) section.fail("paperSizes", "three percentages");
  return paper;
}

DropsWorld readDrops(StrictSection& section)
{
  DropsWorld drops;
  section.read("ramp", drops.ramp);
  std::vector<double> way;
  section.read("rampWay", way);
  if (way.size() != 4) section.fail("rampWay", "x y of its start and x y of its goal [m]");
  drops.from = {way[0], way[1]};
  drops.to = {way[2], way[3]};
  if (section.has("targetEdgesFound")) section.read("targetEdgesFound", drops.edgesFound.emplace());
  if (section.has("targetFloating")) section.read("targetFloating", drops.floating.emplace());
  return drops;
}

FreespaceWorld readWorld(const ExperimentJob& job, const std::string& name)
{
  FreespaceWorld world;
  world.name = name;
  if (!job.ini.sectionExists(name))
    throw std::runtime_error("section 'experiment': worlds names '" + name +
                             "', but there is no such section");
  StrictSection section(job.ini, name);
  world.file = readFile(section, job);
  world.sensors = readWords(section, "sensors");
  section.read("resolution", world.resolution);
  if (!(world.resolution > 0)) section.fail("resolution", "> 0 m");
  section.read("sliceBelow", world.sliceBelow);
  section.read("sliceAbove", world.sliceAbove);
  if (!(-world.sliceBelow < world.sliceAbove)) section.fail("sliceAbove", "above -sliceBelow");
  section.read("robotRadius", world.robotRadius);
  if (!(world.robotRadius > 0)) section.fail("robotRadius", "> 0 m");
  section.read("safetyRadius", world.safetyRadius);
  if (!(world.safetyRadius >= world.robotRadius)) section.fail("safetyRadius", ">= robotRadius");
  world.lowWalls = readWords(section, "lowWalls");
  world.objects = readWords(section, "objects");
  world.strict = readStrict(job, section);
  section.read("judged", world.isJudged);
  if (section.has("ramp")) world.drops = readDrops(section);
  if (section.has("paperSizes")) world.paper = readPaper(section);
  section.refuseUnknown("a world of this experiment");
  return world;
}
}  // namespace

FreespaceSettings readFreespaceSettings(const ExperimentJob& job)
{
  FreespaceSettings settings;
  StrictSection section(job.ini, "experiment");
  section.ignore("kind");
  const auto worlds = readWords(section, "worlds");
  if (worlds.empty()) throw std::runtime_error("section 'experiment': worlds = NAME… is missing");
  section.read("repetitions", settings.repetitions);
  if (settings.repetitions < 1) section.fail("repetitions", ">= 1");
  section.read("pairs", settings.pairs);
  if (settings.pairs < 0) section.fail("pairs", ">= 0");
  section.read("maxScans", settings.maxScans);
  if (settings.maxScans < 0) section.fail("maxScans", ">= 0 (0: all)");
  section.refuseUnknown("this experiment");
  settings.conversion = readConversion(job, "conversion");
  for (const std::string& name : worlds)
  {
    if (std::count(worlds.begin(), worlds.end(), name) > 1)
      section.fail("worlds", "each world once");
    settings.worlds.push_back(readWorld(job, name));
    if (settings.worlds.back().safetyRadius > settings.conversion.minClearance / 2)
      StrictSection(job.ini, name)
          .fail("safetyRadius", "at most half of minClearance in section 'conversion'");
  }
  if (job.quick)
  {
    settings.repetitions = 2;
    settings.pairs = 3;
    settings.maxScans = 8;
  }
  return settings;
}

}  // namespace mapconv
