#include <cmath>

#include "experiment/terrain/TerrainReport.h"

namespace mapconv
{
namespace
{
constexpr double kPaperCoarsest = 0.523;  // its time at 0.1 m by that of elevation mapping
constexpr double kCoarsest = 0.1;         // [m]

double timeOf(const PerTerrainMethod<double>& seconds, TerrainMethod method)
{
  return seconds[static_cast<std::size_t>(method)];
}

/** The sum of all worlds. */
PerTerrainMethod<double> sumOf(const TerrainResults& results, std::size_t resolution)
{
  PerTerrainMethod<double> sum{};
  for (const TerrainWorldResult& result : results)
    for (std::size_t i = 0; i < kTerrainMethods; ++i) sum[i] += result.runs[resolution].seconds[i];
  return sum;
}

std::vector<std::string> row(const std::string& world, double resolution,
                             const PerTerrainMethod<double>& seconds)
{
  std::vector<std::string> cells = {world, metres(resolution)};
  for (const double time : seconds) cells.push_back(fixed(time, 2));
  return cells;
}

Table timeTable(const TerrainResults& results, const TerrainExperimentSettings& settings)
{
  Table table{"times", "Mapping time of all scans, seconds", {"world", "L [m]"}, {}};
  for (const std::string& name : methodNames()) table.header.push_back(name);
  for (std::size_t i = 0; i < settings.resolutions.size(); ++i)
  {
    for (const TerrainWorldResult& result : results)
      table.addRow(row(result.world.name, settings.resolutions[i], result.runs[i].seconds));
    table.addRow(row("all", settings.resolutions[i], sumOf(results, i)));
  }
  table.note =
      "Our maps can be queried after each scan: their planes and leaves have followed. So can the "
      "elevation map all of whose cells are fused after each scan, as ANYbotics' node does. "
      "MRPT's grid has its size from the start, averages heights and knows no variances; octomaps "
      "stand in for Voxblox. Where no threads are named there is one. Points are in memory, in the "
      "sensor's frame; those of octomaps in the map's. " +
      (settings.octoMapEvery > 1 ? "Octomaps got one of " + std::to_string(settings.octoMapEvery) +
                                       " scans, and their time is multiplied by that."
                                 : "");
  return table;
}

std::string target(double resolution, double ratio)
{
  return resolution == kCoarsest ? judged("<= " + fixed(kPaperCoarsest, 3), ratio <= kPaperCoarsest)
                                 : judged("< 1", ratio < 1);
}

Table ratioTable(const TerrainResults& results, const TerrainExperimentSettings& settings)
{
  Table table{"time_ratios",
              "Our time by that of others, all worlds, beside the paper's",
              {"L [m]", "our map", "by elevation map, fused", "target", "paper",
               "by elevation map, not fused", "by CHeightGridMap2D", "by octomap",
               "paper: by Voxblox", "paper's seconds (theirs, elevation mapping, Voxblox)"},
              {}};
  for (std::size_t i = 0; i < settings.resolutions.size(); ++i)
  {
    const auto seconds = sumOf(results, i);
    const PaperTimes& paper = settings.paper;
    for (const TerrainMethod method : {TerrainMethod::Fused, TerrainMethod::FusedTwoThreads,
                                       TerrainMethod::Maximum, TerrainMethod::MaximumTwoThreads})
    {
      const auto ratio = [&](TerrainMethod other)
      { return timeOf(seconds, method) / timeOf(seconds, other); };
      const double fused = ratio(TerrainMethod::ElevationFused);
      table.addRow(
          {metres(settings.resolutions[i]), methodNames()[static_cast<std::size_t>(method)],
           fixed(fused, 2), target(settings.resolutions[i], fused),
           fixed(paper.theirs[i] / paper.elevationMapping[i], 3),
           fixed(ratio(TerrainMethod::ElevationRaw), 2), fixed(ratio(TerrainMethod::HeightGrid), 2),
           fixed(ratio(TerrainMethod::OctoMap), 3), fixed(paper.theirs[i] / paper.voxblox[i], 3),
           fixed(paper.theirs[i], 2) + " / " + fixed(paper.elevationMapping[i], 2) + " / " +
               fixed(paper.voxblox[i], 2)});
    }
  }
  table.note =
      "The paper's times are of other scans on another machine: only ratios can be compared. Its "
      "heights are those of the highest points.";
  return table;
}
}  // namespace

void addTimes(const TerrainResults& results, const TerrainExperimentSettings& settings,
              Report& report)
{
  report.addHeading("Mapping time");
  report.addTable(timeTable(results, settings));
  report.addTable(ratioTable(results, settings));
}

}  // namespace mapconv
