#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <sstream>

#include "experiment/freespace/FreespaceResult.h"
#include "experiment/report/Spread.h"

namespace mapconv
{
namespace grid = mrpt_mapconv::grid;

namespace
{
const PerMethod<const char*> kNames = {"free-space projection: all layers",
                                       "fixed projection of the slice (ours)",
                                       "fixed projection of the whole height (ours)",
                                       "fixed projection of the slice (OctoMap's iterator)",
                                       "fixed projection of the whole height (OctoMap's iterator)"};

std::vector<double> updatesOf(const FreespaceResult& result, std::size_t method)
{
  std::vector<double> values;
  for (const UpdateCost& cost : result.run.updates) values.push_back(cost.ms[method]);
  return values;
}

bool isSlice(std::size_t method)
{
  return method == static_cast<std::size_t>(Method::Slice) ||
         method == static_cast<std::size_t>(Method::SliceByLeaves);
}

/** "1.25 (paper 2.4)" for free-space against the slice. */
std::string ratioText(double ours, double theirs, double paper)
{
  const std::string text = fixed(ours / theirs, 2);
  return paper > 0 ? text + " (paper " + fixed(paper, 1) + ")" : text;
}

/** A target for a ratio, and whether it is met. */
std::string ratioTarget(double value, double most)
{
  return judged("<= " + fixed(most, 0), value <= most);
}

/** The target of a full conversion: to be faster than a fixed projection of the whole height. */
std::string fullTarget(std::size_t method, double ratio)
{
  const bool whole = method == static_cast<std::size_t>(Method::WholeHeight) ||
                     method == static_cast<std::size_t>(Method::WholeHeightByLeaves);
  return whole ? ratioTarget(ratio, 1) : "";
}

Table fullTable(const Results& results)
{
  Table table{"table2_full",
              "Table II: conversion of the whole map, milliseconds, one thread",
              {"world", "method", "median", "mean", "worst", "free-space / this method", "target"},
              {}};
  for (const FreespaceResult& result : results)
  {
    const double ours = spreadOf(result.maps.costs[0]).median;
    for (std::size_t method = 0; method < kMethods; ++method)
    {
      const Spread spread = spreadOf(result.maps.costs[method]);
      const double paper = isSlice(method) ? result.world.paper->fullRatio : 0;
      table.addRow({result.world.name, kNames[method], fixed(spread.median, 2),
                    fixed(spread.mean, 2), fixed(spread.most, 2),
                    method == 0 ? "1" : ratioText(ours, spread.median, paper),
                    fullTarget(method, ours / spread.median)});
    }
  }
  table.note =
      "The paper: 0.23 s (cave) and 6.07 s (outdoor) against 0.094 s and 2.84 s. \"Ours\" reads "
      "the "
      "octree just as the free-space projection does, so that the two can hardly differ where "
      "reading is most of the work; OctoMap's iterator (begin_leafs_bbx) is how OctoMap's server "
      "projects, and so what the paper compares with.";
  return table;
}

Table updateTable(const Results& results)
{
  Table table{"table2_updates",
              "Table II: updates while the voxel map grows scan by scan, milliseconds, one thread",
              {"world", "method", "updates", "median", "mean", "quartiles", "worst",
               "free-space / this method"},
              {}};
  for (const FreespaceResult& result : results)
  {
    const double ours = spreadOf(updatesOf(result, 0)).median;
    for (std::size_t method = 0; method < kMethods; ++method)
    {
      const auto values = updatesOf(result, method);
      const Spread spread = spreadOf(values);
      const double paper = isSlice(method) ? result.world.paper->partialRatio : 0;
      table.addRow({result.world.name, kNames[method], std::to_string(values.size()),
                    fixed(spread.median, 2), fixed(spread.mean, 2),
                    fixed(spread.lowerQuartile, 2) + " to " + fixed(spread.upperQuartile, 2),
                    fixed(spread.most, 2),
                    method == 0 ? "1" : ratioText(ours, spread.median, paper)});
    }
  }
  table.note =
      "The paper: 0.10 s (cave) and 0.83 s (outdoor) against 0.042 s and 0.38 s. Inserting the "
      "scans is not part of these times.";
  return table;
}

std::size_t knownColumns(const FreespaceResult& result)
{
  const auto& cells = result.maps.wholeHeight.cells();
  return cells.size() -
         static_cast<std::size_t>(std::count(cells.begin(), cells.end(), grid::kUnknown));
}

/** Microseconds per changed column of each update, less a fixed millisecond. */
std::vector<double> costsPerColumn(const FreespaceResult& result)
{
  std::vector<double> costs;
  for (const UpdateCost& cost : result.run.updates)
    costs.push_back(1e3 * std::max(0.0, cost.ms[0] - 1.0) /
                    static_cast<double>(cost.changedColumns));
  return costs;
}

Table columnTable(const Results& results)
{
  Table table{"update_cost_per_column",
              "Cost of an update for each changed column, after a fixed millisecond [µs]",
              {"world", "full conversion per column (all / known ones)", "changed columns (median)",
               "update per changed column: median", "quartiles", "median / full (all / known)",
               "target", "updates above it"},
              {}};
  for (const FreespaceResult& result : results)
  {
    const double full = 1e3 * spreadOf(result.maps.costs[0]).median;
    const double perColumn = full / static_cast<double>(result.maps.layers.frame().size());
    const double perKnown = full / static_cast<double>(knownColumns(result));
    const auto costs = costsPerColumn(result);
    const Spread spread = spreadOf(costs);
    std::vector<double> changed;
    for (const UpdateCost& cost : result.run.updates)
      changed.push_back(static_cast<double>(cost.changedColumns));
    const auto over = std::count_if(costs.begin(), costs.end(),
                                    [&](double value) { return value > 2 * perColumn; });
    table.addRow({result.world.name, fixed(perColumn, 3) + " / " + fixed(perKnown, 3),
                  fixed(spreadOf(changed).median, 0), fixed(spread.median, 3),
                  fixed(spread.lowerQuartile, 3) + " to " + fixed(spread.upperQuartile, 3),
                  fixed(spread.median / perColumn, 2) + " / " + fixed(spread.median / perKnown, 2),
                  ratioTarget(spread.median / perColumn, 2),
                  std::to_string(over) + " of " + std::to_string(costs.size())});
  }
  table.note =
      "Known columns hold at least one known voxel; the rest of the map's rectangle costs a full "
      "conversion next to nothing. The target is taken against all columns.";
  return table;
}

/** One line of gnuplot's data per update: changed columns, then the methods' milliseconds. */
std::string updateData(const Results& results)
{
  std::ostringstream data;
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    data << "$w" << i << " << EOD\n";
    for (const UpdateCost& cost : results[i].get().run.updates)
    {
      data << cost.changedColumns;
      for (const double ms : cost.ms) data << ' ' << ms;
      data << '\n';
    }
    data << "EOD\n";
  }
  return data.str();
}

std::string boxPlot(const Results& results)
{
  std::ostringstream script;
  script << updateData(results)
         << "set style fill solid 0.35 border -1\nset style boxplot outliers pointtype 7\n"
         << "set logscale y\nset ylabel 'update [ms]'\nset grid ytics\nunset key\n"
         << "set pointsize 0.3\nset multiplot layout 1," << results.size() << "\n";
  for (std::size_t i = 0; i < results.size(); ++i)
    script << "set title '" << results[i].get().world.name
           << "' noenhanced\nset xtics ('free-space' 1, 'slice' 2, 'whole' 3, 'slice, OctoMap' 4, "
              "'whole, "
              "OctoMap' 5) scale 0 rotate by -30\n"
           << "plot $w" << i << " using (1):2 with boxplot lc rgb '#0072b2', $w" << i
           << " using (2):3 with boxplot lc rgb '#e69f00', $w" << i
           << " using (3):4 with boxplot lc rgb '#999999', $w" << i
           << " using (4):5 with boxplot lc rgb '#e69f00', $w" << i
           << " using (5):6 with boxplot lc rgb '#999999'\n";
  script << "unset multiplot\n";
  return script.str();
}

std::string scatterPlot(const Results& results)
{
  std::ostringstream script;
  script << updateData(results)
         << "set xlabel 'changed columns'\nset ylabel 'update [ms]'\nset grid\nset logscale xy\n"
         << "set key outside bottom center horizontal\nset rmargin 4\nset format x '%.0s%c'\n"
         << "set multiplot layout 1," << results.size() << "\n";
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    script << "set title '" << results[i].get().world.name << "' noenhanced\nplot ";
    const PerMethod<const char*> titles = {"free-space", "slice", "whole", "slice (OctoMap)",
                                           "whole (OctoMap)"};
    const PerMethod<const char*> looks = {"7 lc rgb '#0072b2'", "7 lc rgb '#e69f00'",
                                          "7 lc rgb '#777777'", "2 lc rgb '#e69f00'",
                                          "2 lc rgb '#777777'"};
    for (std::size_t method = 0; method < kMethods; ++method)
      script << (method ? ", " : "") << "$w" << i << " using 1:" << method + 2
             << " with points ps 0.4 pt " << looks[method] << " title '" << titles[method] << "'";
    script << "\n";
  }
  script << "unset multiplot\n";
  return script.str();
}
}  // namespace

void addSpeed(const Results& results, Report& report)
{
  report.addHeading("Speed");
  report.addTable(fullTable(results));
  report.addTable(updateTable(results));
  report.addPlot("updates",
                 "Update times in the exploration run: boxes hold the middle half, logarithmic "
                 "scale (as figure 2 of the paper)",
                 boxPlot(results));
  report.addTable(columnTable(results));
  report.addPlot("updates_by_columns", "Update time against the number of changed columns",
                 scatterPlot(results));
}

}  // namespace mapconv
