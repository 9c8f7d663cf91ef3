// Does inserting a scan get slower as the map grows? A robot drives 110 m along a hall that looks
// the same everywhere, so that each scan changes about as many columns; the figure is the median
// time per insertion over the last tenth of them, as the ratio to that over the first tenth, both
// of insertions that changed a usual number of columns (within a tenth of the median), re-layouts
// apart.
//
//   bench_insertion              drives five times and takes each insertion's best time, since
//                                other programs' share of a machine changes from tenth to tenth
//   bench_insertion TIMES.csv    takes the times that a map has saved (PREFIX_times.csv)
#include <mrpt/system/CTimeLogger.h>
#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <mrpt_mapconv/sim/Simulator.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/TempDir.h"

using namespace mrpt_mapconv;

namespace
{
constexpr double kLength = 130,
                 kMargin = 10;  // of the hall, and what is left of it at both ends [m]

/** A body of 0.4 × 0.4 m. */
std::string post(const std::string& name, double x, double y, double height)
{
  std::ostringstream ini;
  ini << "[box." << name << "]\nmin = " << x << ' ' << y << " 0\nmax = " << x + 0.4 << ' '
      << y + 0.4 << ' ' << height << '\n';
  return ini.str();
}

std::string hall()
{
  std::ostringstream ini;
  ini << "[world]\nbounds = -1 -5 -1 " << kLength + 1 << " 5 4\n"
      << "[box.floor]\nmin = 0 -4 -0.2\nmax = " << kLength << " 4 0\n"
      << "[box.left]\nmin = 0 3.7 0\nmax = " << kLength << " 4 3\n"
      << "[box.right]\nmin = 0 -4 0\nmax = " << kLength << " -3.7 3\n";
  for (int i = 1; i < kLength / 2; ++i)
  {
    const auto number = std::to_string(i);
    ini << post("pillar" + number, 2 * i, 1.5, 2.5) << post("crate" + number, 2 * i, -2.6, 0.7);
  }
  ini << "[sensor.lidar]\nkind = lidar\npose = 0 0 0.9 0 0 0\nbeams = 32\nelevationMin = -50\n"
         "elevationMax = 30\nazimuthSteps = 120\nrate = 2\nmaxRange = 8\nrangeNoise = 0.01\n"
      << "[trajectory]\nwaypoints = [" << kMargin << " 0 0] [" << kLength - kMargin << " 0 0]\n"
      << "speed = 0.5\nturnRate = 45\n";
  return ini.str();
}

using Series = std::map<std::string, std::vector<double>>;

/** The history of every quantity in a file of MRPT's CTimeLogger. */
Series readTimes(const std::string& csv)
{
  constexpr int summary = 7;  // a name, six numbers, and then the history
  std::ifstream file(csv);
  Series series;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line))
  {
    std::istringstream fields(line);
    std::string name, field;
    for (int i = 0; i < summary && std::getline(fields, field, ','); ++i)
      if (i == 0) name = field.substr(1, field.size() - 2);
    while (std::getline(fields, field, ',')) series[name].push_back(std::stod(field));
  }
  if (series["insert"].empty()) throw std::runtime_error(csv + ": no history of insertions");
  return series;
}

std::vector<sim::Moment> drive(const std::string& dir)
{
  std::ofstream(dir + "/hall.ini") << hall();
  const auto scenario = sim::Scenario::load(dir + "/hall.ini");
  sim::Simulator simulator(scenario, 1);
  std::vector<sim::Moment> moments;
  while (auto moment = simulator.next()) moments.push_back(std::move(*moment));
  return moments;
}

Series mapOnce(const std::vector<sim::Moment>& moments, const std::string& csv)
{
  CFreeSpaceGridMap2D map(0.1);
  for (const auto& moment : moments)
    map.insertObservation(*moment.scans.front().observation, moment.pose);
  map.insertionTimes().saveToCSVFile(csv);
  return readTimes(csv);
}

Series measure()
{
  const mrpt_mapconv::testing::TempDir dir;
  const auto moments = drive(dir.path());
  Series best = mapOnce(moments, dir.path("times.csv"));
  for (int run = 1; run < 5; ++run)
  {
    auto& times = best["insert"];
    const auto again = mapOnce(moments, dir.path("times.csv"))["insert"];
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = std::min(times[i], again[i]);
  }
  return best;
}

double median(std::vector<double> values)
{
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void report(const Series& series)
{
  const auto &times = series.at("insert"), &columns = series.at("insert.columns"),
             &laidOut = series.at("insert.laidOut");
  const double usual = median(columns);
  const std::size_t tenth = std::max<std::size_t>(1, times.size() / 10);
  std::vector<double> first, last;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    if (laidOut[i] != 0 || std::abs(columns[i] - usual) > 0.1 * usual) continue;
    if (i < tenth) first.push_back(times[i]);
    if (i >= times.size() - tenth) last.push_back(times[i]);
  }
  if (first.empty() || last.empty())
    throw std::runtime_error(
        "no insertion of a usual number of columns in the first or last tenth");
  std::printf(
      "%zu insertions of %.0f changed columns; first tenth %.2f ms (%zu of %zu), "
      "last tenth %.2f ms (%zu); ratio %.2f\n",
      times.size(), usual, 1e3 * median(first), first.size(), tenth, 1e3 * median(last),
      last.size(), median(last) / median(first));
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    report(argc > 1 ? readTimes(argv[1]) : measure());
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_insertion: error: %s\n", error.what());
    return 1;
  }
  return 0;
}
