#include "experiment/scan_shape/ScanShapeResult.h"

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

/** How a region is called in the first columns of a table. */
std::vector<std::string> regionCells(const ScanShapeResult& result, std::size_t i)
{
  const eval::MapRegion& region = result.settings.regions[i];
  return {region.name, region.kind};
}

/** What some maps of each drive say of a region: the shares that each finds, then the occupied
 * cells that each labels free, means of all drives. \param mapsOf gives the maps' scores in a run
 */
template <class MapsOf>
std::vector<std::string> scoresOf(const ScanShapeResult& result, const MapsOf& mapsOf)
{
  std::vector<std::string> found, dangerous;
  for (std::size_t map = 0; map < mapsOf(result.runs.front()).size(); ++map)
  {
    const auto mean = [&](const auto& value) {
      return meanOf(result.runs, [&](const ScanShapeRun& run) { return value(mapsOf(run)[map]); });
    };
    found.push_back(percent(mean([](const eval::RegionScore& score) { return score.shareFound; })));
    dangerous.push_back(
        fixed(mean([](const eval::RegionScore& score) { return score.occupiedLabelledFree; }), 1));
  }
  return joined(found, dangerous);
}

void addRegions(const ScanShapeResult& result, Report& report)
{
  Table table{"regions",
              "Behind doors and glass, maps of whole drives without and with the cut, means of all "
              "drives",
              {"region", "behind", "true free area [m^2]", "found without", "found with",
               "occupied cells labelled free without", "occupied cells labelled free with"},
              {}};
  for (std::size_t i = 0; i < result.settings.regions.size(); ++i)
  {
    const auto maps = [i](const ScanShapeRun& run) {
      return std::vector<eval::RegionScore>{run.uncutRegions[i], run.cutRegions[i]};
    };
    const double area = result.runs.front().cutRegions[i].trueFreeArea;
    table.addRow(joined(joined(regionCells(result, i), {fixed(area, 2)}), scoresOf(result, maps)));
  }
  table.note =
      "Where a lintel spans a door, or glass reaches the ceiling, there is a structural element "
      "that scans do pass: what they tell of the other side is cut. A door that is open up to the "
      "ceiling has none. On its way the robot enters most of the rooms, which hides that.";
  report.addTable(table);
}

std::vector<std::string> outsideCells(const ScanShapeResult& result, std::size_t margin,
                                      std::size_t region)
{
  const auto scoreIn = [&](const ScanShapeRun& run) -> const eval::OutsideScore&
  { return run.outside[margin][region]; };
  const auto maps = [&](const ScanShapeRun& run)
  {
    const auto& score = scoreIn(run).maps;
    return std::vector<eval::RegionScore>{score.real, score.uncut, score.cut};
  };
  const double scans =
      meanOf(result.runs, [&](const ScanShapeRun& run) { return scoreIn(run).scans; });
  return joined({fixed(scans, 1)}, scoresOf(result, maps));
}

void addRegionsFromOutside(const ScanShapeResult& result, Report& report)
{
  Table table{"regions_outside",
              "The same, maps of scans from outside the room behind only",
              {"region", "behind", "from [m]", "scans", "found, no ghosts", "found without",
               "found with", "occupied cells labelled free, no ghosts",
               "occupied cells labelled free without", "occupied cells labelled free with"},
              {}};
  for (std::size_t i = 0; i < result.settings.regions.size(); ++i)
    for (std::size_t margin = 0; margin < result.settings.margins.size(); ++margin)
      table.addRow(
          joined(joined(regionCells(result, i), {fixed(result.settings.margins[margin], 2)}),
                 outsideCells(result, margin, i)));
  table.note =
      "From: how far outside the room the sensor is at least; from near a door the lidar does not "
      "see up to its lintel, and nothing is cut. No ghosts: without the cut, of the returns that "
      "were not reflected on their way, which is what can be seen of the region from there. More "
      "than that without the cut is not seen but made up by ghosts; less with it is what the "
      "method "
      "loses where its assumption fails. A room may be seen through other doors and panes, too.";
  report.addTable(table);
}
}  // namespace

void addCut(const ScanShapeResult& result, Report& report)
{
  report.addHeading("The cut at structural elements");
  addSeeds(result, report);
  if (result.settings.regions.empty()) return;
  addRegions(result, report);
  addRegionsFromOutside(result, report);
}

}  // namespace mapconv
