#include <mrpt/core/format.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "FreespaceResult.h"
#include "Spread.h"

namespace mapconv
{
namespace
{
struct Method
{
  std::string name;
  std::function<std::vector<double>(const FullCosts&)> full;
  std::function<double(const UpdateCost&)> update;
};

const std::vector<Method>& methods()
{
  static const std::vector<Method> all = {
      {"free-space projection, all layers", [](const FullCosts& c) { return c.full; },
       [](const UpdateCost& c) { return c.full; }},
      {"fixed projection of the slice", [](const FullCosts& c) { return c.slice; },
       [](const UpdateCost& c) { return c.slice; }},
      {"fixed projection of the whole height", [](const FullCosts& c) { return c.wholeHeight; },
       [](const UpdateCost& c) { return c.wholeHeight; }}};
  return all;
}

std::vector<double> updatesOf(const FreespaceResult& result, const Method& method)
{
  std::vector<double> values;
  for (const UpdateCost& cost : result.run.updates) values.push_back(method.update(cost));
  return values;
}

/** "1.25 (paper 2.4)" for free-space against the slice. */
std::string ratioText(double ours, double theirs, double paper)
{
  const std::string text = fixed(ours / theirs, 2);
  return paper > 0 ? text + " (paper " + fixed(paper, 1) + ")" : text;
}

Table fullTable(const std::vector<FreespaceResult>& results)
{
  Table table{"table2_full",
              "Table II: conversion of the whole map, milliseconds, one thread",
              {"world", "method", "median", "mean", "worst", "free-space / this method"},
              {}};
  for (const auto& result : results)
  {
    const double ours = spreadOf(result.maps.costs.full).median;
    for (const Method& method : methods())
    {
      const Spread spread = spreadOf(method.full(result.maps.costs));
      const bool isSlice = &method == &methods()[1];
      const double paper = isSlice ? result.world.paper.fullRatio : 0;
      table.addRow({result.world.name, method.name, fixed(spread.median, 2), fixed(spread.mean, 2),
                    fixed(spread.most, 2),
                    &method == &methods()[0] ? "1" : ratioText(ours, spread.median, paper)});
    }
  }
  table.note =
      "The paper: 0.23 s (cave) and 6.07 s (outdoor) against 0.094 s and 2.84 s. Target: "
      "free-space "
      "projection faster than the fixed projection of the whole height (ratio < 1).";
  return table;
}

Table updateTable(const std::vector<FreespaceResult>& results)
{
  Table table{"table2_updates",
              "Table II: updates while the voxel map grows scan by scan, milliseconds, one thread",
              {"world", "method", "updates", "median", "mean", "quartiles", "worst",
               "free-space / this method"},
              {}};
  for (const auto& result : results)
  {
    const double ours = spreadOf(updatesOf(result, methods()[0])).median;
    for (const Method& method : methods())
    {
      const auto values = updatesOf(result, method);
      const Spread spread = spreadOf(values);
      const double paper = &method == &methods()[1] ? result.world.paper.partialRatio : 0;
      table.addRow({result.world.name, method.name, std::to_string(values.size()),
                    fixed(spread.median, 2), fixed(spread.mean, 2),
                    fixed(spread.lowerQuartile, 2) + " to " + fixed(spread.upperQuartile, 2),
                    fixed(spread.most, 2),
                    &method == &methods()[0] ? "1" : ratioText(ours, spread.median, paper)});
    }
  }
  table.note =
      "The paper: 0.10 s (cave) and 0.83 s (outdoor) against 0.042 s and 0.38 s. Inserting the "
      "scans is not part of these times.";
  return table;
}

Table columnTable(const std::vector<FreespaceResult>& results)
{
  Table table{"update_cost_per_column",
              "Cost of an update for each changed column, after a fixed millisecond",
              {"world", "full conversion, µs per column", "update, µs per changed column: median",
               "95 % of updates", "median / full", "updates with ratio > 2"},
              {}};
  for (const auto& result : results)
  {
    const auto columns = static_cast<double>(result.maps.layers.frame().size());
    const double full = 1e3 * spreadOf(result.maps.costs.full).median / columns;
    std::vector<double> perColumn;
    for (const UpdateCost& cost : result.run.updates)
      perColumn.push_back(1e3 * std::max(0.0, cost.full - 1.0) /
                          static_cast<double>(cost.changedColumns));
    std::sort(perColumn.begin(), perColumn.end());
    const auto over = std::count_if(perColumn.begin(), perColumn.end(),
                                    [&](double value) { return value > 2 * full; });
    const double median = spreadOf(perColumn).median;
    const double high = perColumn.empty() ? median : perColumn[perColumn.size() * 95 / 100];
    table.addRow({result.world.name, fixed(full, 4), fixed(median, 4), fixed(high, 4),
                  fixed(median / full, 2),
                  std::to_string(over) + " of " + std::to_string(perColumn.size())});
  }
  table.note = "Target: at most 2 times the full conversion's cost per column.";
  return table;
}

/** One line of gnuplot's data per update: changed columns, then the methods' milliseconds. */
std::string updateData(const std::vector<FreespaceResult>& results)
{
  std::ostringstream data;
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    data << "$w" << i << " << EOD\n";
    for (const UpdateCost& cost : results[i].run.updates)
      data << cost.changedColumns << ' ' << cost.full << ' ' << cost.slice << ' '
           << cost.wholeHeight << '\n';
    data << "EOD\n";
  }
  return data.str();
}

std::string boxPlot(const std::vector<FreespaceResult>& results)
{
  std::ostringstream script;
  script << updateData(results)
         << "set style fill solid 0.35 border -1\nset style boxplot outliers pointtype 7\n"
         << "set logscale y\nset ylabel 'update [ms]'\nset grid ytics\nunset key\n"
         << "set pointsize 0.3\nset multiplot layout 1," << results.size() << "\n";
  for (std::size_t i = 0; i < results.size(); ++i)
    script << "set title '" << results[i].world.name
           << "'\nset xtics ('free-space' 1, 'slice' 2, 'whole height' 3) scale 0\n"
           << "plot $w" << i << " using (1):2 with boxplot lc rgb '#0072b2', $w" << i
           << " using (2):3 with boxplot lc rgb '#e69f00', $w" << i
           << " using (3):4 with boxplot lc rgb '#999999'\n";
  script << "unset multiplot\n";
  return script.str();
}

std::string scatterPlot(const std::vector<FreespaceResult>& results)
{
  std::ostringstream script;
  script << updateData(results)
         << "set xlabel 'changed columns'\nset ylabel 'update [ms]'\nset grid\nset key left top\n"
         << "set xtics rotate by -30\nset multiplot layout 1," << results.size() << "\n";
  for (std::size_t i = 0; i < results.size(); ++i)
    script << "set title '" << results[i].world.name << "'\nplot $w" << i
           << " using 1:2 with points pt 7 ps 0.5 lc rgb '#0072b2' title 'free-space', $w" << i
           << " using 1:3 with points pt 7 ps 0.5 lc rgb '#e69f00' title 'slice', $w" << i
           << " using 1:4 with points pt 7 ps 0.5 lc rgb '#999999' title 'whole height'\n";
  script << "unset multiplot\n";
  return script.str();
}
}  // namespace

void addSpeed(const std::vector<FreespaceResult>& results, Report& report)
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
