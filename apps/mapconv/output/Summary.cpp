#include "output/Summary.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/grid/CoordinateSystem.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

namespace mapconv
{
namespace grid = mrpt_mapconv::grid;
using grid::GridFrame;
using mrpt_mapconv::params::placeText;

OccupancyCounts countsOf(const grid::Layer<float>& occupancy)
{
  OccupancyCounts counts;
  for (const float value : occupancy.cells())
    ++(grid::isFree(value)       ? counts.free
       : grid::isOccupied(value) ? counts.occupied
                                 : counts.unknown);
  return counts;
}

std::string headText(const SummaryHead& head)
{
  const GridFrame& frame = head.frame;
  const auto& origin = head.reference.origin;
  std::string text = fromTo(head.input + ", " + head.inputKind, head.outputDir);
  text += mrpt::format("cells        %zu (%d x %d) of %s m\n", frame.size(), frame.width,
                       frame.height, jsonNumber(frame.resolution).c_str());
  text += mrpt::format("size         %.2f x %.2f m: x %.2f to %.2f, y %.2f to %.2f\n",
                       frame.xMax() - frame.xMin(), frame.yMax() - frame.yMin(),
                       frame.xMin() + origin.x, frame.xMax() + origin.x, frame.yMin() + origin.y,
                       frame.yMax() + origin.y);
  if (!head.reference.isLocal())
    text += "origin       " + placeText(origin.x) + ", " + placeText(origin.y) + ", " +
            placeText(origin.z) + " m, taken off in " + head.localFiles + "\n";
  if (head.reference.unit != 1)
    text += "GeoTIFF      lies in " + grid::unitInWords(head.reference.unit) +
            "; all else, also its bands, is in m\n";
  return text;
}

std::string countsText(const std::string& label, const OccupancyCounts& counts)
{
  const auto all = static_cast<double>(counts.free + counts.occupied + counts.unknown);
  const auto percent = [all](std::size_t n) { return 100 * static_cast<double>(n) / all; };
  return mrpt::format("%-12s %zu free (%.1f %%), %zu occupied (%.1f %%), %zu unknown (%.1f %%)\n",
                      label.c_str(), counts.free, percent(counts.free), counts.occupied,
                      percent(counts.occupied), counts.unknown, percent(counts.unknown));
}

std::string fromTo(const std::string& from, const std::string& to)
{
  using mrpt_mapconv::params::printable;
  return printable(from) + " -> " + printable(to) + "\n";
}

std::string secondsText(const Seconds& seconds)
{
  std::string stages;
  for (const auto& [name, time] : seconds)
    stages += (stages.empty() ? "" : ", ") + mrpt::format("%s %.3f", name.c_str(), time);
  return "seconds      " + stages + "\n";
}

JsonObject headJson(const SummaryHead& head)
{
  const GridFrame& frame = head.frame;
  JsonObject json;
  json.add("input", head.input).add("inputKind", head.inputKind).add("output", head.outputDir);
  json.add("resolution", frame.resolution).add("width", frame.width).add("height", frame.height);
  const auto& origin = head.reference.origin;
  json.add("xMin", frame.xMin() + origin.x).add("xMax", frame.xMax() + origin.x);
  json.add("yMin", frame.yMin() + origin.y).add("yMax", frame.yMax() + origin.y);
  if (!head.reference.isLocal())
    json.add("originX", origin.x).add("originY", origin.y).add("originZ", origin.z);
  if (!head.reference.coordinateSystem.empty()) json.add("crs", head.reference.coordinateSystem);
  if (head.reference.unit != 1) json.add("metresPerUnit", head.reference.unit);
  return json.add("cells", frame.size());
}

JsonObject summaryJson(const SummaryHead& head, const OccupancyCounts& counts)
{
  JsonObject json = headJson(head);
  json.add("free", counts.free).add("occupied", counts.occupied).add("unknown", counts.unknown);
  return json;
}

JsonObject secondsJson(const Seconds& seconds)
{
  JsonObject json;
  for (const auto& [name, time] : seconds) json.add(name, time);
  return json;
}

}  // namespace mapconv
