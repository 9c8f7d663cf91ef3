#include "experiment/terrain/TerrainReport.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
constexpr double kLessError = 0.627;  // the paper's claim

using Summaries = PerTerrainHeights<eval::ErrorSummary>;

const eval::ErrorSummary& of(const Summaries& errors, TerrainHeights heights)
{
  return errors[static_cast<std::size_t>(heights)];
}

/** How much less the mean absolute error of our map is than that of the fused baseline, [.., 1]. */
double lessError(const Summaries& errors, TerrainHeights ours)
{
  return 1 -
         of(errors, ours).meanAbsolute / of(errors, TerrainHeights::ElevationFused).meanAbsolute;
}

std::string target(double noise, double less)
{
  return noise == 1 ? judged(">= " + percent(kLessError), less >= kLessError) : "";
}

/** Errors of all runs in some of the cells, those with targets or not. */
Table errorTable(const TerrainResults& results, const std::string& name, const std::string& title,
                 Summaries NoiseErrors::*cells, bool hasTarget)
{
  Table table{name, title, {"world", "L [m]", "pose noise", "cells"}, {}};
  for (const std::string& map : heightsNames()) table.header.push_back(map);
  for (const std::string ours : {"fused", "maximum"})
  {
    table.header.push_back(ours + ": less than elevation map, fused");
    if (hasTarget) table.header.push_back(ours + ": target");
  }
  for (const TerrainWorldResult& result : results)
    for (const TerrainRun& run : result.runs)
      for (const NoiseErrors& noise : run.errors)
      {
        const Summaries& errors = noise.*cells;
        std::vector<std::string> row = {result.world.name, metres(run.resolution),
                                        metres(noise.noise), std::to_string(errors.front().cells)};
        for (const auto& summary : errors) row.push_back(millimetres(summary.meanAbsolute));
        for (const TerrainHeights ours : {TerrainHeights::Fused, TerrainHeights::Maximum})
        {
          const double less = lessError(errors, ours);
          row.push_back(percent(less));
          if (hasTarget) row.push_back(target(noise.noise, less));
        }
        table.addRow(row);
      }
  return table;
}

Table clearTable(const TerrainResults& results)
{
  Table table = errorTable(results, "height_errors",
                           "Mean absolute error of heights away from jumps, millimetres",
                           &NoiseErrors::clear, true);
  table.note =
      "Pose noise: times the worlds' own. Cells that all four maps know and that are more than a "
      "cell away from a jump. The paper claims " +
      percent(kLessError) + " less error.";
  return table;
}

Table farTable(const TerrainResults& results)
{
  Table table = errorTable(results, "height_errors_far_from_jumps",
                           "The same where noise of ranges does not reach across a jump",
                           &NoiseErrors::far, false);
  table.note =
      "Cells that are farther from a jump than three standard deviations of a range: nearer by, "
      "points of walls and risers lie in cells of the ground, and beyond the faces that they are "
      "of.";
  return table;
}

Table apartTable(const TerrainResults& results)
{
  Table table{"height_errors_at_jumps",
              "The same within a cell of a jump or under other surfaces, with the worlds' pose "
              "noise, millimetres",
              {"world", "L [m]", "cells"},
              {}};
  for (const std::string& name : heightsNames()) table.header.push_back(name);
  for (const TerrainWorldResult& result : results)
    for (const TerrainRun& run : result.runs)
      for (const NoiseErrors& errors : run.errors)
      {
        if (errors.noise != 1) continue;
        std::vector<std::string> row = {result.world.name, metres(run.resolution),
                                        std::to_string(errors.apart.front().cells)};
        for (const auto& summary : errors.apart) row.push_back(millimetres(summary.meanAbsolute));
        table.addRow(row);
      }
  table.note =
      "These cells have no single true height: the one that is compared is that of the lowest "
      "surface at the cell's centre.";
  return table;
}

/** Where a plane is [m]. */
std::string middleOf(const terrain::TerrainPlane& plane)
{
  return fixed(plane.x, 1) + " " + fixed(plane.y, 1) + " " + fixed(plane.z, 2);
}

std::string rmsAndBias(const eval::ErrorSummary& errors)
{
  return millimetres(errors.rms) + " (" + millimetres(errors.bias) + ")";
}

Table planeTable(const TerrainResults& results, const TerrainExperimentSettings& settings)
{
  Table table{"plane_residuals",
              "Heights against the largest true planes at L = " + metres(settings.pictured) +
                  " m, away from jumps: rms (bias), millimetres",
              {"world", "plane at [m]", "slope", "cells"},
              {}};
  for (const std::string& name : heightsNames()) table.header.push_back(name);
  for (const TerrainWorldResult& result : results)
    for (const TerrainRun& run : result.runs)
    {
      if (run.resolution != settings.pictured) continue;
      for (const PlaneErrors& plane : run.planes)
      {
        std::vector<std::string> row = {result.world.name, middleOf(plane.plane),
                                        fixed(plane.plane.slope(), 2),
                                        std::to_string(plane.errors.front().cells)};
        for (const auto& errors : plane.errors) row.push_back(rmsAndBias(errors));
        table.addRow(row);
      }
    }
  table.note = "With the worlds' pose noise. A plane is named by its middle, x y z.";
  return table;
}
}  // namespace

void addHeightErrors(const TerrainResults& results, const TerrainExperimentSettings& settings,
                     Report& report)
{
  report.addHeading("Heights");
  report.addTable(clearTable(results));
  report.addTable(farTable(results));
  report.addTable(apartTable(results));
  report.addTable(planeTable(results, settings));
}

void addRealScans(const std::vector<RealTerrain>& runs, Report& report)
{
  Table table{"real_residuals",
              "Real scans: heights of cells against the planes fitted to them, rms, millimetres",
              {"L [m]", "plane at [m]", "slope", "cells"},
              {}};
  for (const std::string& name : heightsNames()) table.header.push_back(name);
  for (const RealTerrain& run : runs)
    for (const RealPlane& real : run.largest)
    {
      std::vector<std::string> row = {metres(run.resolution), middleOf(real.plane),
                                      fixed(real.plane.slope(), 2),
                                      std::to_string(real.plane.cells)};
      for (const auto& residuals : real.residuals) row.push_back(millimetres(residuals.rms));
      table.addRow(row);
    }
  for (const RealTerrain& run : runs)
    table.note += "At " + metres(run.resolution) + " m: " + std::to_string(run.scans) +
                  " scans with " + std::to_string(run.points) + " points, " +
                  std::to_string(run.cells) + " cells in " + std::to_string(run.leaves) +
                  " leaves, " + std::to_string(run.planes) + " planes. ";
  table.note +=
      "There is no truth: cells are those of the largest planes of our map with fused heights, "
      "which by this lie near a plane there. Each map's heights, ours those of cells before planes "
      "replace them, are compared with the least-squares plane through themselves.";
  report.addHeading("Real scans");
  report.addTable(table);
}

}  // namespace mapconv
