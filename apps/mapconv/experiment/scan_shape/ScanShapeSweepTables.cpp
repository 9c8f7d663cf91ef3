#include <mrpt/core/format.h>

#include "experiment/scan_shape/ScanShapeResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
using Runs = std::vector<ScanShapeRun>;

/** How many scans that say free it takes until the most occupied cell reads free. */
int scansToFree(const scan::LogOddsUpdate& update) { return -update.lowest() / update.miss() + 1; }

/** The mean scores of a trial that each run has, as `scoreIn` finds it. */
template <class ScoreIn>
std::vector<std::string> cellsOf(const Runs& runs, const ScoreIn& scoreIn)
{
  std::vector<eval::MapScore> scores;
  scores.reserve(runs.size());
  for (const ScanShapeRun& run : runs) scores.push_back(scoreIn(run));
  return scoreCells(scores, 4);
}

/** Numbers as a text, "1, 2 and 3". */
std::string listOf(const std::vector<std::uint32_t>& numbers)
{
  std::string list;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    list += (i == 0 ? "" : i + 1 < numbers.size() ? ", " : " and ") + std::to_string(numbers[i]);
  return list;
}

std::string drivesText(const ScanShapeSettings& settings)
{
  const auto& seeds = settings.sweep.seeds;
  return seeds.size() == 1
             ? "The drive of seed " + listOf(seeds) + ", which is not in the tables above."
             : "Means of the drives of seeds " + listOf(seeds) +
                   ", which are not in the tables above.";
}

/** The best increments of those that free any cell in so many scans as people may take to fade. */
std::string guaranteeText(const Runs& runs)
{
  double bestScore = -1;
  scan::UpdateParams best;
  const auto& trials = runs.front().updateTrials;
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    const double score = meanOf(
        runs, [&](const ScanShapeRun& run) { return run.updateTrials[i].score.labels.fScore(); });
    if (scansToFree(scan::LogOddsUpdate(trials[i].params)) > eval::kScansToFade ||
        score <= bestScore)
      continue;
    bestScore = score;
    best = trials[i].params;
  }
  if (bestScore < 0) return "No pair guarantees that ten scans free any cell.";
  const scan::LogOddsUpdate update(best);
  return mrpt::format(
      "Of the pairs that guarantee that ten scans free any cell the best is %.2f/%.2f (%d x %d > "
      "%d).",
      best.pHit, best.pMiss, eval::kScansToFade, update.miss(), -update.lowest());
}

void addUpdates(const ScanShapeResult& result, Report& report)
{
  const Runs& runs = result.sweepRuns;
  Table table{"increments",
              "Whole shape with the cut: increments of occupied and free cells",
              joined({"pHit", "pMiss", "units"},
                     joined(scoreHeader(), {"scans to free", "left by people", "not faded"})),
              {}};
  for (std::size_t i = 0; i < runs.front().updateTrials.size(); ++i)
  {
    const scan::UpdateParams& params = runs.front().updateTrials[i].params;
    const scan::LogOddsUpdate update(params);
    const auto mean = [&](const auto& value)
    {
      return meanOf(runs,
                    [&](const ScanShapeRun& run) { return value(run.updateTrials[i].people); });
    };
    const double left = mean([](const eval::PeopleTraces& traces) { return traces.hitByPerson; });
    const double notFaded = mean([](const eval::PeopleTraces& traces) { return traces.notFaded; });
    const auto scores =
        cellsOf(runs, [&](const ScanShapeRun& run) { return run.updateTrials[i].score; });
    table.addRow(joined(
        {fixed(params.pHit, 2), fixed(params.pMiss, 2),
         std::to_string(update.hit()) + "/" + std::to_string(update.miss())},
        joined(scores, {std::to_string(scansToFree(update)), fixed(left, 1), fixed(notFaded, 1)})));
  }
  table.note =
      drivesText(result.settings) +
      " Units: of MRPT's cells, sixteenths of log-odds. Scans to free: how many that say free it "
      "takes until a cell that is as occupied as it can be has p < 0.5. Left by people: cells free "
      "in truth that have p > 0.5 at the end because of a person. Not faded: of these, the ones "
      "that at least ten scans since have said are free. " +
      guaranteeText(runs);
  report.addTable(table);
}

void addProfiles(const ScanShapeResult& result, Report& report)
{
  const Runs& runs = result.sweepRuns;
  Table table{"parameters",
              "Whole shape with the cut: other parameters",
              joined({"parameter", "value"}, scoreHeader()),
              {}};
  for (std::size_t i = 0; i < runs.front().profileTrials.size(); ++i)
  {
    const ProfileTrial& trial = runs.front().profileTrials[i];
    table.addRow(
        joined({trial.parameter, trial.value},
               cellsOf(runs, [&](const ScanShapeRun& run) { return run.profileTrials[i].score; })));
  }
  table.note = drivesText(result.settings);
  report.addTable(table);
}
}  // namespace

void addSweep(const ScanShapeResult& result, Report& report)
{
  if (result.sweepRuns.empty()) return;
  report.addHeading("Parameters");
  addUpdates(result, report);
  addProfiles(result, report);
}

}  // namespace mapconv
