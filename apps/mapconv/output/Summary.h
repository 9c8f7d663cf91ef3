#pragma once

#include <mrpt_mapconv/grid/GeoReference.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>

#include "output/Job.h"
#include "output/Json.h"

namespace mapconv
{
/** How many cells of an occupancy layer are what. */
struct OccupancyCounts
{
  std::size_t free = 0, occupied = 0, unknown = 0;
};

OccupancyCounts countsOf(const mrpt_mapconv::grid::Layer<float>& occupancy);

/** What a summary begins with: what was read, where the results are, and how large they are. */
struct SummaryHead
{
  std::string input, inputKind, outputDir;
  mrpt_mapconv::grid::GridFrame frame;
  mrpt_mapconv::grid::GeoReference reference;
  std::string localFiles;  //!< those without the origin, in words
};

/** The first lines of a summary. */
std::string headText(const SummaryHead& head);
/** The line with the counts, in cells and as shares of all cells. `label` is up to 11 characters.
 */
std::string countsText(const std::string& label, const OccupancyCounts& counts);
/** "FROM -> TO": one line, whatever the names of files hold. */
std::string fromTo(const std::string& from, const std::string& to);
/** The last line: the stages and how long they took. */
std::string secondsText(const Seconds& seconds);

/** The JSON object with what every summary begins with. */
JsonObject headJson(const SummaryHead& head);
/** The same, and how many cells of an occupancy layer are what. */
JsonObject summaryJson(const SummaryHead& head, const OccupancyCounts& counts);
JsonObject secondsJson(const Seconds& seconds);

}  // namespace mapconv
