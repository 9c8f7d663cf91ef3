#include "experiment/scan_shape/ScanShapeResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
const std::vector<ScanMethod>& allMethods()
{
  static const std::vector<ScanMethod> all = {ScanMethod::Scanner2D, ScanMethod::ClosestPoint,
                                              ScanMethod::Counts, ScanMethod::WholeShape,
                                              ScanMethod::WholeShapeCut};
  return all;
}

const eval::MapScore& scoreIn(const ScanShapeRun& run, ScanMethod method)
{
  return run.scores[static_cast<std::size_t>(method)];
}

void addMethod(const ScanShapeResult& result, ScanMethod method, Table& table)
{
  std::vector<eval::MapScore> scores;
  for (const ScanShapeRun& run : result.runs) scores.push_back(scoreIn(run, method));
  const PaperScore& paper = result.settings.paper[static_cast<std::size_t>(method)];
  const auto cells = joined({methodName(method)}, scoreCells(scores, 3));
  table.addRow(
      joined(cells, {fixed(paper.precision, 3), fixed(paper.recall, 3), fixed(paper.fScore, 3)}));
}

std::string countText(const ScanShapeResult& result)
{
  const eval::LabelScore& score = scoreIn(result.runs.front(), ScanMethod::WholeShapeCut).labels;
  return std::to_string(score.should) + " cells of " + fixed(result.settings.resolution, 2) + " m";
}
}  // namespace

std::string methodName(ScanMethod method)
{
  static const PerScanMethod<std::string> names = {
      "2D scanner (MRPT's own grid)", "closest point", "accumulated counts",
      "whole shape without the cut", "whole shape with the cut"};
  return names[static_cast<std::size_t>(method)];
}

std::vector<std::string> scoreHeader()
{
  return {"precision",           "recall",           "F-score",
          "occupied: precision", "occupied: recall", "occupied cells labelled free"};
}

std::vector<std::string> scoreCells(const std::vector<eval::MapScore>& scores, int decimals)
{
  const auto mean = [&](const auto& value) { return meanOf(scores, value); };
  return {
      fixed(mean([](const eval::MapScore& score) { return score.labels.precision(); }), decimals),
      fixed(mean([](const eval::MapScore& score) { return score.labels.recall(); }), decimals),
      fixed(mean([](const eval::MapScore& score) { return score.labels.fScore(); }), decimals),
      fixed(mean([](const eval::MapScore& score) { return score.occupied.precision(); }), decimals),
      fixed(mean([](const eval::MapScore& score) { return score.occupied.recall(); }), decimals),
      fixed(mean([](const eval::MapScore& score) { return score.occupiedLabelledFree; }), 1)};
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

void addScores(const ScanShapeResult& result, Report& report)
{
  Table table{"table1",
              "Table I: maps against the true world, means of all drives",
              joined(joined({"method"}, scoreHeader()),
                     {"paper: precision", "paper: recall", "paper: F-score"}),
              {}};
  for (const ScanMethod method : allMethods()) addMethod(result, method, table);
  table.note =
      "Precision: of the cells labelled free or occupied, wherever they are, those that are so in "
      "truth. Recall: of the cells that should be labelled, which are " +
      countText(result) +
      ", those that are: truly free cells connected to the start, and truly occupied ones beside "
      "them. Occupied: precision and recall of that label alone, again over all cells that have "
      "it, wherever they are, and over those that should have it. Cells labelled free are counted "
      "among all truly occupied ones. Accumulated counts (the paper's "
      "figure 7a) forget nothing: "
      "a cell is occupied if it ever was seen so, and free if it was only ever seen free.";
  report.addHeading("Quality");
  report.addTable(table);

  Table seeds{
      "table1_seeds", "The same, drive by drive", joined({"seed", "method"}, scoreHeader()), {}};
  for (const ScanShapeRun& run : result.runs)
    for (const ScanMethod method : allMethods())
      seeds.addRow(joined({std::to_string(run.seed), methodName(method)},
                          scoreCells({scoreIn(run, method)}, 3)));
  report.addTable(seeds);
}

void addPeople(const ScanShapeResult& result, Report& report)
{
  Table table{
      "people",
      "Walking people: cells of the map by whole shape with the cut",
      {"seed", "people were seen in", "free in truth", "p > 0.5 at the end", "last hit by a person",
       "since then free in 10 scans or more", "free in as many, but hit by something else"},
      {}};
  const auto add = [&](const std::string& seed, const eval::PeopleTraces& traces)
  {
    table.addRow({seed, std::to_string(traces.seen), std::to_string(traces.freeInTruth),
                  std::to_string(traces.occupied), std::to_string(traces.hitByPerson),
                  std::to_string(traces.notFaded), std::to_string(traces.hitByOthers)});
  };
  eval::PeopleTraces all;
  for (const ScanShapeRun& run : result.runs)
  {
    add(std::to_string(run.seed), run.people);
    all += run.people;
  }
  add("all", all);
  table.note =
      "Each column counts some of the cells of the one before it, but the last: cells of the "
      "fourth that something else was seen in since. The target for the last but one is 0. Counted "
      "from a record of all returns and updates.";
  report.addHeading("People");
  report.addTable(table);
}

}  // namespace mapconv
