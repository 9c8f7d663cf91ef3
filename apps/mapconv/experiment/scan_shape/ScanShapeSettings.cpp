#include "experiment/scan_shape/ScanShapeSettings.h"

#include <mrpt_mapconv/maps/GridInsertionOptions.h>
#include <mrpt_mapconv/params/StrictSection.h>
#include <mrpt_mapconv/scan/ScanInsertionOptions.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "experiment/ExperimentIni.h"

namespace mapconv
{
using namespace mrpt_mapconv;
using params::StrictSection;

namespace
{
const std::string kRegion = "region.";

/** Whole numbers from 1 on, each once. */
template <class Number>
std::vector<Number> readCounts(StrictSection& section, const std::string& key)
{
  std::vector<double> numbers;
  section.read(key, numbers);
  const double most = static_cast<double>(std::numeric_limits<Number>::max());
  for (const double number : numbers)
    if (number < 1 || number > most || number != std::floor(number))
      section.fail(key, "a list of whole numbers >= 1");
  if (std::set<double>(numbers.begin(), numbers.end()).size() != numbers.size())
    section.fail(key, "a list of different numbers");
  return {numbers.begin(), numbers.end()};
}

/** Numbers of which there must be so many. */
std::vector<double> readSome(StrictSection& section, const std::string& key, std::size_t count,
                             const std::string& meaning)
{
  std::vector<double> numbers;
  section.read(key, numbers);
  if (numbers.size() != count) section.fail(key, meaning);
  return numbers;
}

void readRun(const ExperimentJob& job, ScanShapeSettings& settings)
{
  StrictSection section(job.ini, "experiment");
  section.ignore("kind");
  settings.world = readFile(section, job);
  settings.seeds = readCounts<std::uint32_t>(section, "seeds");
  if (settings.seeds.empty())
    throw std::runtime_error("section 'experiment': seeds = NUMBER… is missing");
  section.read("resolution", settings.resolution);
  if (!(settings.resolution > 0)) section.fail("resolution", "> 0 m");
  section.read("maxScans", settings.maxScans);
  if (settings.maxScans < 0) section.fail("maxScans", ">= 0 (0: all)");
  section.refuseUnknown("this experiment");
}

/** How the full method inserts scans; the others differ from it as their names say. */
void readInsertion(const ExperimentJob& job, ScanShapeSettings& settings)
{
  StrictSection section(job.ini, "wholeShapeCut");
  for (const char* key : {"model", "reflectionFilter", "insert2D"})
    if (section.has(key)) section.fail(key, "left out: each method of the experiment sets it");
  scan::TScanInsertionOptions options;
  options.readFrom(section);
  section.refuseUnknown("the insertion of 3D scans");
  section.checked([&] { options.check(); });
  settings.profile = options.profile;
  settings.update = options.update;
}

void readScanner(const ExperimentJob& job, ScanShapeSettings& settings)
{
  StrictSection section(job.ini, "scanner2D");
  maps::readGridInsertionOptions(section, settings.scanner);
  section.refuseUnknown("the insertion of 2D scans");
}

void readPaper(const ExperimentJob& job, ScanShapeSettings& settings)
{
  StrictSection section(job.ini, "paper");
  const auto read = [&](const std::string& key, ScanMethod method)
  {
    const auto row = readSome(section, key, 3, "three numbers, precision recall F-score");
    settings.paper[static_cast<std::size_t>(method)] = {row[0], row[1], row[2]};
  };
  read("scanner2D", ScanMethod::Scanner2D);
  read("closestPoint", ScanMethod::ClosestPoint);
  read("wholeShapeCut", ScanMethod::WholeShapeCut);
  section.refuseUnknown("the paper's table");
}

void checkSweep(const StrictSection& section, const ScanShapeSettings& settings)
{
  scan::UpdateParams update = settings.update;
  for (const double pHit : settings.sweep.pHit)
    for (const double pMiss : settings.sweep.pMiss)
    {
      update.pHit = pHit;
      update.pMiss = pMiss;
      section.checked([&] { update.check(); });
    }
  scan::ProfileParams profile = settings.profile;
  for (const double tolerance : settings.sweep.structureTolerance)
  {
    profile.structureTolerance = tolerance;
    section.checked([&] { profile.check(); });
  }
}

void readSweep(const ExperimentJob& job, ScanShapeSettings& settings)
{
  StrictSection section(job.ini, "sweep");
  ScanShapeSweep& sweep = settings.sweep;
  sweep.seeds = readCounts<std::uint32_t>(section, "seeds");
  for (const std::uint32_t seed : sweep.seeds)  // nothing is tuned on what is reported
    if (std::count(settings.seeds.begin(), settings.seeds.end(), seed) > 0)
      section.fail("seeds", "a list of others than the seeds in section 'experiment'");
  section.read("pHit", sweep.pHit);
  section.read("pMiss", sweep.pMiss);
  section.read("structureTolerance", sweep.structureTolerance);
  sweep.sectors = readCounts<std::int32_t>(section, "sectors");
  section.refuseUnknown("the sweep");
  checkSweep(section, settings);
}

sim::Footprint readRectangle(StrictSection& section, const std::string& key)
{
  const std::string meaning = "four numbers, xMin yMin xMax yMax [m], each max above its min";
  const auto sides = readSome(section, key, 4, meaning);
  const sim::Footprint rectangle{sides[0], sides[1], sides[2], sides[3]};
  if (!(rectangle.xMin < rectangle.xMax && rectangle.yMin < rectangle.yMax))
    section.fail(key, meaning);
  return rectangle;
}

eval::MapRegion readRegion(const ExperimentJob& job, const std::string& name)
{
  static const std::vector<std::string> kinds = {"lintelDoor", "openDoor", "ceilingPane"};
  StrictSection section(job.ini, name);
  eval::MapRegion region;
  region.name = name.substr(kRegion.size());
  int kind = -1;
  section.readChoice("kind", kinds, kind);
  if (kind < 0) section.fail("kind", "lintelDoor or openDoor or ceilingPane");
  region.kind = kinds[static_cast<std::size_t>(kind)];
  region.area = readRectangle(section, "area");
  region.room = readRectangle(section, "room");
  section.refuseUnknown("a region");
  return region;
}

void readMargins(const ExperimentJob& job, ScanShapeSettings& settings)
{
  StrictSection section(job.ini, "regions");
  section.read("margins", settings.margins);
  for (const double margin : settings.margins)
    if (margin < 0) section.fail("margins", "a list of numbers >= 0 [m]");
  section.refuseUnknown("the regions");
}

void readRegions(const ExperimentJob& job, ScanShapeSettings& settings)
{
  const std::set<std::string> others = {"experiment", "wholeShapeCut", "scanner2D",
                                        "paper",      "sweep",         "regions"};
  std::vector<std::string> sections;
  job.ini.getAllSections(sections);
  for (const std::string& name : sections)
    if (name.rfind(kRegion, 0) == 0)
      settings.regions.push_back(readRegion(job, name));
    else if (others.count(name) == 0)
      throw std::runtime_error("section '" + name +
                               "' means nothing in this experiment: correct its name or take it "
                               "out");
}
}  // namespace

ScanShapeSettings readScanShapeSettings(const ExperimentJob& job)
{
  ScanShapeSettings settings;
  readRun(job, settings);
  readInsertion(job, settings);
  readScanner(job, settings);
  readPaper(job, settings);
  readSweep(job, settings);
  readMargins(job, settings);
  readRegions(job, settings);
  if (job.quick)
  {
    settings.seeds.resize(1);
    settings.sweep.seeds.resize(std::min<std::size_t>(settings.sweep.seeds.size(), 1));
    settings.maxScans = 8;
  }
  return settings;
}

void failRegion(const ExperimentJob& job, const eval::MapRegion& region, const std::string& key,
                const std::string& right)
{
  StrictSection(job.ini, kRegion + region.name).fail(key, right);
}

}  // namespace mapconv
