#include <mrpt_mapconv/eval/LayerErrors.h>
#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/terrain/TerrainFiles.h>

#include <cmath>
#include <map>
#include <sstream>

#include "experiment/terrain/TerrainReport.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
bool isPictured(const TerrainRun& run) { return !run.layers.height.frame().empty(); }

const PerTerrainHeights<const char*> kLooks = {"lw 2.5 lc rgb '#0072b2'", "lw 1.5 lc rgb '#56b4e9'",
                                               "lw 2 lc rgb '#d55e00'", "lw 1 lc rgb '#e69f00'"};

void addMaps(const TerrainWorldResult& result, const TerrainRun& run, Report& report)
{
  const std::string at = " of " + result.world.name + ", L = " + metres(run.resolution) + " m";
  const auto all = terrain::styled(run.layers);
  const auto shown = grid::shownFrame(all);
  const auto add = [&](const grid::StyledLayer& layer)
  {
    grid::writeLayerPng(report.addPicture(result.world.name + "_" + layer.name, layer.title + at),
                        layer, {}, shown);
  };
  add(grid::findLayer(all, "height"));
  add(grid::findLayer(all, "plane"));
  add(terrain::styledLeaves(run.layers));
}

/** Share of the cells by their errors, in gnuplot's data: millimetres, per cent. */
std::string histogram(const std::vector<double>& errors)
{
  constexpr double kBin = 0.5;   // [mm]
  constexpr double kReach = 40;  // [mm]
  std::map<long, std::size_t> bins;
  for (const double error : errors)
    if (std::abs(1e3 * error) <= kReach) ++bins[std::lround(1e3 * error / kBin)];
  std::ostringstream data;
  for (const auto& [bin, cells] : bins)
    data << kBin * static_cast<double>(bin) << ' '
         << 100 * static_cast<double>(cells) / static_cast<double>(errors.size()) << '\n';
  return data.str();
}

/** A curve for each of the maps' heights. \param dataOf each, as lines of x and y */
template <class DataOf>
std::string curves(const std::string& block, const std::string& first, const DataOf& dataOf)
{
  std::ostringstream data, plot;
  plot << "plot " << first;
  for (std::size_t i = 0; i < kTerrainHeights; ++i)
  {
    data << "$" << block << i << " << EOD\n" << dataOf(i) << "EOD\n";
    plot << (i || !first.empty() ? ", " : "") << "$" << block << i << " using 1:2 with lines "
         << kLooks[i] << " title '" << heightsNames()[i] << "'";
  }
  return data.str() + plot.str() + "\n";
}

void addHistograms(const TerrainResults& results, Report& report)
{
  std::ostringstream script;
  script << "set grid\nset xlabel 'map minus truth [mm]'\nset ylabel 'cells [%]'\n"
         << "set xrange [-40:40]\nset logscale y\nset key outside bottom center vertical\nset "
            "multiplot layout 1,"
         << results.size() << "\n";
  for (std::size_t w = 0; w < results.size(); ++w)
    for (const TerrainRun& run : results[w].runs)
    {
      if (!isPictured(run)) continue;
      const auto clear = eval::without({run.truth.height.frame(), 1}, run.truth.apart);
      script << "set title '" << results[w].world.name << "' noenhanced\n"
             << curves("w" + std::to_string(w) + "_", "",
                       [&](std::size_t i) {
                         return histogram(eval::errorsOf(run.heights[i], run.truth.height, clear));
                       });
    }
  script << "unset multiplot\n";
  report.addPlot("height_errors", "Errors of heights away from jumps, logarithmic scale",
                 script.str(), 1500, 600);
}

/** Along a line, what a layer has in the cells under it: way and value, by gnuplot's `times`. */
std::string profile(const StairsLine& line, const grid::Layer<float>& layer)
{
  const grid::GridFrame& frame = layer.frame();
  const auto along = line.to - line.from;
  const int pieces = static_cast<int>(2 * along.norm() / frame.resolution);
  std::ostringstream data;
  for (int i = 0; i <= pieces; ++i)
  {
    const double share = static_cast<double>(i) / pieces;
    const auto place = line.from + along * share;
    const auto key = [&](double metre)
    { return static_cast<std::int32_t>(std::floor(metre / frame.resolution - frame.shift)); };
    const std::int32_t kx = key(place.x), ky = key(place.y);
    if (frame.containsKey(kx, ky))
      data << share * along.norm() << ' ' << layer.cells()[frame.indexOfKey(kx, ky)] << '\n';
  }
  return data.str();
}

grid::Layer<float> difference(const grid::Layer<float>& map, const grid::Layer<float>& truth)
{
  grid::Layer<float> layer = map.onFrame(truth.frame(), NAN);
  for (std::size_t i = 0; i < layer.cells().size(); ++i)
    layer.cells()[i] = 1e3F * (layer.cells()[i] - truth.cells()[i]);
  return layer;
}

void addProfile(const TerrainWorldResult& result, const TerrainRun& run, const StairsLine& flight,
                Report& report)
{
  std::ostringstream script;
  script << "set grid\nset key left top\nset multiplot layout 2,1\nset ylabel 'height [m]'\n$t << "
            "EOD\n"
         << profile(flight, run.truth.height) << "EOD\n"
         << curves("h", "$t using 1:2 with steps lw 1 lc rgb 'black' title 'truth'",
                   [&](std::size_t i) { return profile(flight, run.heights[i]); })
         << "unset key\nset xlabel 'along the line [m]'\nset ylabel 'map minus truth [mm]'\n"
         << "set yrange [-30:30]\n"
         << curves("d", "0 lw 1 lc rgb 'black'",
                   [&](std::size_t i)
                   { return profile(flight, difference(run.heights[i], run.truth.height)); })
         << "unset multiplot\n";
  const std::string name = result.world.name + "_flight_" + flight.name;
  report.addPlot(name,
                 "Flight " + flight.name + " of " + result.world.name + ", L = " +
                     metres(run.resolution) + " m: heights along a line, and their errors",
                 script.str(), 1100, 800);
}
}  // namespace

void addPictures(const TerrainResults& results, Report& report)
{
  report.addHeading("Pictures");
  addHistograms(results, report);
  for (const TerrainWorldResult& result : results)
    for (const TerrainRun& run : result.runs)
    {
      if (!isPictured(run)) continue;
      addMaps(result, run, report);
      if (!result.world.flights.empty())
        addProfile(result, run, result.world.flights.front(), report);
    }
}

}  // namespace mapconv
