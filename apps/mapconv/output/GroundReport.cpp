#include "output/GroundReport.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** What the layers of a ground hold, in numbers. */
struct GroundCounts
{
  std::size_t cells = 0;
  std::size_t measured = 0;  //!< cells with a ground point
  std::size_t covered = 0;   //!< cells with any point
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();  //!< of the ground [m]
  double mostAbove = 0;                                       //!< ground [m]
};

GroundCounts countsOf(const aerial::GroundLayers& layers)
{
  GroundCounts counts;
  counts.cells = layers.ground.cells().size();
  for (std::size_t i = 0; i < counts.cells; ++i)
  {
    counts.measured += layers.groundPoints.cells()[i] > 0;
    counts.covered += layers.allPoints.cells()[i] > 0;
    const auto ground = static_cast<double>(layers.ground.cells()[i]);
    counts.lowest = std::min(counts.lowest, ground);
    counts.highest = std::max(counts.highest, ground);
    if (const float above = layers.aboveGround.cells()[i]; above > 0)
      counts.mostAbove = std::max(counts.mostAbove, static_cast<double>(above));
  }
  return counts;
}

double percent(std::size_t part, std::size_t all)
{
  return 100 * static_cast<double>(part) / static_cast<double>(all);
}

std::string measuredText(const GroundCounts& counts)
{
  const auto cells = [&counts](std::size_t some) {
    return params::counted(some, "cell") + mrpt::format(" (%.1f %%)", percent(some, counts.cells));
  };
  std::string text = "measured     " + cells(counts.measured) + " with ground points";
  if (counts.measured < counts.cells)
    text += "; in the others the ground is inferred, below other points in " +
            cells(counts.covered - counts.measured);
  return text + "\n";
}

std::string changedText(const aerial::GroundParams& params)
{
  std::vector<std::string> defaults;
  params::forEachText(aerial::GroundParams(),
                      [&](const char*, const std::string& text) { defaults.push_back(text); });
  std::string changed;
  std::size_t index = 0;
  params::forEachText(params,
                      [&](const char* key, const std::string& text)
                      {
                        if (text != defaults[index++])
                          changed +=
                              (changed.empty() ? "" : ", ") + std::string(key) + " = " + text;
                      });
  return changed;
}
}  // namespace

std::string groundText(const SummaryHead& head, const GroundResult& result, const Seconds& seconds)
{
  const aerial::Ground& ground = result.ground;
  const GroundCounts counts = countsOf(ground.layers);
  const std::size_t points = ground.classification.size();
  const double z = head.reference.origin.z;
  std::string text = headText(head);
  text += mrpt::format("ground       %zu of %s (%.1f %%), by %s on cells of %.3g m\n",
                       ground.groundPoints, params::counted(points, "point").c_str(),
                       percent(ground.groundPoints, points),
                       params::textOf(result.params.groundFilter).c_str(), ground.filterResolution);
  text += measuredText(counts);
  text += mrpt::format("height       ground %.2f to %.2f m, the highest point %.2f m above it\n",
                       counts.lowest + z, counts.highest + z, counts.mostAbove);
  if (const std::string changed = changedText(result.params); !changed.empty())
    text += "not default  " + changed + "\n";
  if (ground.lowPoints > 0)
    text += "left out     " + params::counted(ground.lowPoints, "point") +
            " below the ground, as lone low points (lowPointRadius)\n";
  if (ground.unusedPoints > 0)
    text += "left out     " + params::counted(ground.unusedPoints, "point") +
            " that the file marks as withheld or noise\n";
  if (!result.pointsFile.empty()) text += "points       -> " + result.pointsFile + "\n";
  return text + secondsText(seconds);
}

std::string groundJson(const SummaryHead& head, const GroundResult& result, const Seconds& seconds)
{
  const aerial::Ground& ground = result.ground;
  const GroundCounts counts = countsOf(ground.layers);
  const double z = head.reference.origin.z;
  JsonObject json = headJson(head);
  json.add("points", ground.classification.size()).add("groundPoints", ground.groundPoints);
  json.add("lowPoints", ground.lowPoints).add("withheldPoints", ground.unusedPoints);
  json.add("cellsWithGroundPoints", counts.measured).add("cellsWithPoints", counts.covered);
  json.add("groundMin", counts.lowest + z).add("groundMax", counts.highest + z);
  json.add("aboveGroundMax", counts.mostAbove).add("filterResolution", ground.filterResolution);
  if (!result.pointsFile.empty()) json.add("pointsFile", result.pointsFile);
  JsonObject parameters;
  addFields(result.params, parameters);
  return json.add("parameters", parameters).add("seconds", secondsJson(seconds)).text() + "\n";
}

void warnAboutGround(const GroundResult& result)
{
  const aerial::Ground& ground = result.ground;
  if (!ground.hasSettled)
    printWarning("the cloth did not come to rest in maxIterations = " +
                 std::to_string(result.params.maxIterations) +
                 " steps, so it may hang below the ground");
  constexpr double kFewGroundPoints = 0.003;  // of all points
  if (static_cast<double>(ground.groundPoints) <
      kFewGroundPoints * static_cast<double>(ground.classification.size()))
    printWarning(
        mrpt::format("only %.2g %% of the points are ground, so nearly all of it is inferred",
                     percent(ground.groundPoints, ground.classification.size())));
  constexpr double kManyParticles = 8;  // between two points
  if (result.params.groundFilter == aerial::GroundFilter::Csf &&
      ground.pointDistance > kManyParticles * ground.filterResolution)
  {
    printWarning(mrpt::format(
        "the points are %.3g m apart, the cloth's particles %.3g m: it comes up into what is wider "
        "than some gaps between points, houses say; --cloth-resolution %.2g is stiffer and faster, "
        "but cuts steep hills",
        ground.pointDistance, ground.filterResolution, ground.pointDistance / 3));
    return;
  }
  const GroundCounts counts = countsOf(ground.layers);
  constexpr double kFewPoints = 0.2;  // a cell
  const double perCell =
      static_cast<double>(ground.classification.size()) / static_cast<double>(counts.cells);
  if (perCell < kFewPoints)
    printWarning(
        mrpt::format("there are %.2g points a cell, and the ground between them is "
                     "inferred; --cell-size %.2g would give each cell about one",
                     perCell, result.params.cellSize / std::sqrt(perCell)));
}

}  // namespace mapconv
