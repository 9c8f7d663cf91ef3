#include <algorithm>
#include <cmath>

#include "experiment/terrain/TerrainReport.h"

namespace mapconv
{
namespace
{
constexpr double kMostHeightError = 0.005;  // [m]

/** Of the steps of a flight at one resolution. */
struct FlightFigures
{
  std::size_t steps = 0, found = 0;
  double worstHeight = NAN, worstDepth = NAN;  //!< absolute errors [m]
};

FlightFigures figuresOf(const std::vector<JudgedStep>& steps, const std::string& flight)
{
  FlightFigures figures;
  for (const JudgedStep& step : steps)
  {
    if (step.flight != flight) continue;
    ++figures.steps;
    if (!step.found) continue;
    ++figures.found;
    figures.worstHeight = std::fmax(figures.worstHeight, std::abs(step.heightError()));
    figures.worstDepth = std::fmax(figures.worstDepth, std::abs(step.depthError()));
  }
  return figures;
}

std::string target(const FlightFigures& figures, double worst, double most, const std::string& text,
                   bool isJudged)
{
  return isJudged ? judged(text, figures.found == figures.steps && worst <= most) : "";
}

void addRow(const std::string& world, const std::string& flight, double resolution,
            const std::string& rule, const std::vector<JudgedStep>& steps, bool isJudged,
            Table& table)
{
  const FlightFigures figures = figuresOf(steps, flight);
  table.addRow({world, flight, metres(resolution), rule,
                std::to_string(figures.found) + " of " + std::to_string(figures.steps),
                millimetres(figures.worstHeight),
                target(figures, figures.worstHeight, kMostHeightError, "all within 5 mm", isJudged),
                millimetres(figures.worstDepth),
                target(figures, figures.worstDepth, resolution, "all within a cell", isJudged)});
}

Table flightTable(const TerrainResults& results, const TerrainExperimentSettings& settings)
{
  Table table{
      "flights",
      "Flights of stairs: worst errors of their steps, millimetres",
      {"world", "flight", "L [m]", "rule", "steps found", "height", "target", "depth", "target"},
      {}};
  for (const TerrainWorldResult& result : results)
    for (const StairsLine& flight : result.world.flights)
      for (const TerrainRun& run : result.runs)
      {
        const bool isJudged = run.resolution <= settings.judgedSteps;
        addRow(result.world.name, flight.name, run.resolution, "fused", run.fused.steps, isJudged,
               table);
        addRow(result.world.name, flight.name, run.resolution, "maximum", run.maximum.steps,
               isJudged, table);
      }
  table.note =
      "True steps are those of the ground along a line over the flight; the depth is that "
      "of the upper tread, where another step ends it on the line. Targets are for L up "
      "to " +
      metres(settings.judgedSteps) + " m.";
  return table;
}

Table stepTable(const TerrainResults& results, const TerrainExperimentSettings& settings)
{
  Table table{"steps",
              "Each step at L = " + metres(settings.pictured) + " m, fused heights, metres",
              {"world", "flight", "at [m]", "true height", "height", "error [mm]", "true depth",
               "depth", "error [mm]"},
              {}};
  for (const TerrainWorldResult& result : results)
    for (const TerrainRun& run : result.runs)
    {
      if (run.resolution != settings.pictured) continue;
      for (const JudgedStep& step : run.fused.steps)
      {
        std::vector<std::string> row = {result.world.name, step.flight,
                                        fixed(step.truth.x, 2) + " " + fixed(step.truth.y, 2)};
        const auto add = [&](double truth, double found)
        {
          row.push_back(fixed(truth, 3));
          row.push_back(fixed(found, 3));
          row.push_back(fixed(1e3 * (found - truth), 1));
        };
        add(step.truth.height, step.found ? step.found->height : NAN);
        add(step.truth.depth, step.found ? step.found->depth : NAN);
        table.addRow(row);
      }
    }
  return table;
}
}  // namespace

void addSteps(const TerrainResults& results, const TerrainExperimentSettings& settings,
              Report& report)
{
  report.addHeading("Stairs");
  report.addTable(flightTable(results, settings));
  report.addTable(stepTable(results, settings));
}

}  // namespace mapconv
