#include "ScanShapeResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
double precisionOf(const ScanShapeRun& run, ScanMethod method)
{
  return run.scores[static_cast<std::size_t>(method)].labels.precision();
}

void addSeeds(const ScanShapeResult& result, Report& report)
{
  Table table{
      "cut",
      "Whole shape without and with the cut",
      {"seed", "precision without", "precision with", "difference", "false obstacles without",
       "of these only ghosts", "false obstacles with", "of these only ghosts"},
      {}};
  for (const ScanShapeRun& run : result.runs)
  {
    const double without = precisionOf(run, ScanMethod::WholeShape);
    const double with = precisionOf(run, ScanMethod::WholeShapeCut);
    table.addRow({std::to_string(run.seed), fixed(without, 4), fixed(with, 4),
                  fixed(with - without, 4), std::to_string(run.uncutFalse.cells),
                  std::to_string(run.uncutFalse.onlyGhosts), std::to_string(run.cutFalse.cells),
                  std::to_string(run.cutFalse.onlyGhosts)});
  }
  table.note =
      "False obstacles: cells labelled occupied that are not so in truth. Only ghosts: of these, "
      "cells where all returns of the object slice only seemed to be, having been reflected.";
  report.addTable(table);
}

void addRegion(const ScanShapeResult& result, std::size_t i, Table& table)
{
  const MapRegion& region = result.settings.regions[i];
  const auto mean = [&](bool cut, const auto& value)
  {
    return meanOf(result.runs, [&](const ScanShapeRun& run)
                  { return value((cut ? run.cutRegions : run.uncutRegions)[i]); });
  };
  const auto found = [](const RegionScore& score) { return score.shareFound; };
  const auto dangerous = [](const RegionScore& score) { return score.occupiedLabelledFree; };
  const double area = result.runs.front().cutRegions[i].trueFreeArea;
  table.addRow({region.name, region.kind, fixed(area, 2), percent(mean(false, found)),
                percent(mean(true, found)), fixed(mean(false, dangerous), 1),
                fixed(mean(true, dangerous), 1)});
}

void addRegions(const ScanShapeResult& result, Report& report)
{
  Table table{"regions",
              "Behind doors and glass, without and with the cut, means of all drives",
              {"region", "behind", "true free area [m^2]", "found without", "found with",
               "occupied cells labelled free without", "occupied cells labelled free with"},
              {}};
  for (std::size_t i = 0; i < result.settings.regions.size(); ++i) addRegion(result, i, table);
  table.note =
      "Where a lintel spans a door, or glass reaches the ceiling, there is a structural element "
      "that scans do pass: what they tell of the other side is cut, and only what is seen from "
      "that side is found. A door that is open up to the ceiling has none.";
  report.addTable(table);
}
}  // namespace

void addCut(const ScanShapeResult& result, Report& report)
{
  report.addHeading("The cut at structural elements");
  addSeeds(result, report);
  if (!result.settings.regions.empty()) addRegions(result, report);
}

}  // namespace mapconv
