#include <algorithm>

#include "ScanShapeResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** The runs that took part in the sweep. */
std::vector<const ScanShapeRun*> sweptRuns(const ScanShapeResult& result)
{
  std::vector<const ScanShapeRun*> runs;
  const auto count =
      std::min(result.runs.size(), static_cast<std::size_t>(result.settings.sweep.seeds));
  for (std::size_t i = 0; i < count; ++i) runs.push_back(&result.runs[i]);
  return runs;
}

/** How many scans that say free it takes until the most occupied cell reads free. */
int scansToFree(const scan::LogOddsUpdate& update) { return -update.lowest() / update.miss() + 1; }

/** The mean scores of a trial that each run has, as `scoreIn` finds it. */
template <class ScoreIn>
std::vector<std::string> cellsOf(const std::vector<const ScanShapeRun*>& runs,
                                 const ScoreIn& scoreIn)
{
  std::vector<MapScore> scores;
  scores.reserve(runs.size());
  for (const ScanShapeRun* run : runs) scores.push_back(scoreIn(*run));
  return scoreCells(scores, 4);
}

void addUpdates(const std::vector<const ScanShapeRun*>& runs, Report& report)
{
  Table table{"increments",
              "Whole shape with the cut: increments of occupied and free cells",
              joined({"pHit", "pMiss", "units"},
                     joined(scoreHeader(), {"scans to free", "left by people", "not faded"})),
              {}};
  for (std::size_t i = 0; i < runs.front()->updateTrials.size(); ++i)
  {
    const scan::UpdateParams& params = runs.front()->updateTrials[i].params;
    const scan::LogOddsUpdate update(params);
    const auto mean = [&](const auto& value)
    {
      return meanOf(runs,
                    [&](const ScanShapeRun* run) { return value(run->updateTrials[i].people); });
    };
    const double left = mean([](const PeopleTraces& traces) { return traces.hitByPerson; });
    const double notFaded = mean([](const PeopleTraces& traces) { return traces.notFaded; });
    const auto scores =
        cellsOf(runs, [&](const ScanShapeRun& run) { return run.updateTrials[i].score; });
    table.addRow(joined(
        {fixed(params.pHit, 2), fixed(params.pMiss, 2),
         std::to_string(update.hit()) + "/" + std::to_string(update.miss())},
        joined(scores, {std::to_string(scansToFree(update)), fixed(left, 1), fixed(notFaded, 1)})));
  }
  table.note =
      "Means of " + std::to_string(runs.size()) + (runs.size() == 1 ? " drive. " : " drives. ") +
      "Units: of MRPT's cells, sixteenths of log-odds. Scans to free: how many that say free it "
      "takes until a cell that is as occupied as it can be has p < 0.5. Left by people: cells free "
      "in truth that have p > 0.5 at the end because of a person. Not faded: of these, the ones "
      "that at least ten scans since have said are free.";
  report.addTable(table);
}

void addProfiles(const std::vector<const ScanShapeRun*>& runs, Report& report)
{
  Table table{"parameters",
              "Whole shape with the cut: other parameters",
              joined({"parameter", "value"}, scoreHeader()),
              {}};
  for (std::size_t i = 0; i < runs.front()->profileTrials.size(); ++i)
  {
    const ProfileTrial& trial = runs.front()->profileTrials[i];
    table.addRow(
        joined({trial.parameter, trial.value},
               cellsOf(runs, [&](const ScanShapeRun& run) { return run.profileTrials[i].score; })));
  }
  report.addTable(table);
}
}  // namespace

void addSweep(const ScanShapeResult& result, Report& report)
{
  const auto runs = sweptRuns(result);
  if (runs.empty()) return;
  report.addHeading("Parameters");
  addUpdates(runs, report);
  addProfiles(runs, report);
}

}  // namespace mapconv
