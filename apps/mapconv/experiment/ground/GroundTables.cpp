#include "experiment/ground/GroundTables.h"

#include <mrpt_mapconv/grid/LayerPicture.h>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
const std::vector<std::string> kOfPoints = {"filter",  "points", "ground", "type I",
                                            "type II", "total",  "kappa",  "s"};

std::vector<std::string> pointCells(const GroundResult& result, const GroundRun& run)
{
  return {result.cloud,
          run.filter,
          std::to_string(result.points),
          percent(result.groundShare),
          percent(run.points.typeI()),
          percent(run.points.typeII()),
          percent(run.points.total()),
          percent(run.points.kappa()),
          fixed(run.seconds, 2)};
}

Table newTable(const std::string& name, const std::string& title, const std::string& first)
{
  Table table{name, title, {first}, {}};
  table.header.insert(table.header.end(), kOfPoints.begin(), kOfPoints.end());
  return table;
}

std::string target(double limit, double error)
{
  return judged("<= " + percent(limit), error <= limit);
}

Table pointTable(const std::vector<GroundResult>& results, const GroundExperimentSettings& settings)
{
  Table table = newTable("ground_points", "Points of simulated forests", "world");
  for (const char* name : {"target I", "target II"}) table.header.emplace_back(name);
  for (std::size_t i = 0; i < results.size(); ++i)
    for (const GroundRun& run : results[i].runs)
    {
      auto row = pointCells(results[i], run);
      const bool isJudged = run.filter == settings.judged;
      const GroundWorld& world = settings.worlds[i];
      row.push_back(isJudged ? target(world.typeI, run.points.typeI()) : "");
      row.push_back(isJudged ? target(world.typeII, run.points.typeII()) : "");
      table.addRow(row);
    }
  table.note =
      "Type I: of the true ground points, those that were missed; type II: of the others, those "
      "that were taken for ground; kappa: 100 % without an error, 0 for chance. Total error and "
      "kappa are of a cloud that is nearly all leaves.";
  return table;
}

Table mapTable(const std::vector<GroundResult>& results)
{
  Table table{"ground_maps",
              "Heights of the maps less the true ground, metres",
              {"world", "filter", "RMSE", "bias", "measured cells", "RMSE (bias) there",
               "RMSE (bias) of inferred cells"},
              {}};
  const auto both = [](const eval::ErrorSummary& errors)
  { return fixed(errors.rms, 3) + " (" + fixed(errors.bias, 3) + ")"; };
  for (const GroundResult& result : results)
    for (const GroundRun& run : result.runs)
    {
      const eval::GroundMapScore& map = run.map;
      const double measured =
          static_cast<double>(map.measured.cells) / static_cast<double>(map.all.cells);
      table.addRow({result.cloud, run.filter, fixed(map.all.rms, 3), fixed(map.all.bias, 3),
                    percent(measured), both(map.measured), both(map.inferred)});
    }
  table.note = "In all cells that have ground in the world, at their centres.";
  return table;
}

void addErrorPictures(const GroundResult& result, Report& report)
{
  for (const GroundRun& run : result.runs)
  {
    const std::string title = "Error of the ground of " + result.cloud + ", " + run.filter;
    const grid::StyledLayer layer{"error", &run.errors, title, "m", grid::LayerKind::Height};
    grid::writeLayerPng(report.addPicture(result.cloud + "_" + run.filter, title), layer);
  }
}
}  // namespace

void addForests(const std::vector<GroundResult>& results, const GroundExperimentSettings& settings,
                Report& report)
{
  report.addTable(pointTable(results, settings));
  report.addTable(mapTable(results));
  for (const GroundResult& result : results) addErrorPictures(result, report);
}

void addSamples(const std::vector<GroundResult>& results, Report& report)
{
  Table table = newTable("ground_samples", "Points of samples that people classified", "sample");
  for (const GroundResult& result : results)
    for (const GroundRun& run : result.runs) table.addRow(pointCells(result, run));
  report.addTable(table);
}

}  // namespace mapconv
