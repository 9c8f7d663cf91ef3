#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiment/report/Report.h"
#include "experiment/report/Spread.h"
#include "experiment/scan_shape/ScanShapeRun.h"

namespace mapconv
{
/** All drives of the experiment. */
struct ScanShapeResult
{
  ScanShapeSettings settings;
  mrpt_mapconv::eval::ScanShapeTruth truth;
  std::vector<ScanShapeRun> runs;       //!< one for each seed; only the first one keeps its maps
  std::vector<ScanShapeRun> sweepRuns;  //!< likewise of the sweep, without maps
};

/** How a method is called in the report. */
std::string methodName(ScanMethod method);

/** The mean of what `value` gives for each run; NaN for none. */
template <class Runs, class Value>
double meanOf(const Runs& runs, const Value& value)
{
  std::vector<double> values;
  for (const auto& run : runs) values.push_back(static_cast<double>(value(run)));
  return spreadOf(std::move(values)).mean;
}

/** The columns of a table that say how good a map is, and the means of some maps in them. @{ */
std::vector<std::string> scoreHeader();
std::vector<std::string> scoreCells(const std::vector<mrpt_mapconv::eval::MapScore>& scores,
                                    int decimals);
/** @} */

/** One row of two parts. */
std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b);

/** Each adds a part of the report. @{ */
/** Table I: precision, recall and F-score of the methods, beside the paper's; also seed by seed. */
void addScores(const ScanShapeResult& result, Report& report);

/** With the cut against without it: precision and false obstacles seed by seed, and what lies
 * behind lintels and glass up to the ceiling, on maps of all scans and as seen from outside. */
void addCut(const ScanShapeResult& result, Report& report);

/** What walking people leave on the map. */
void addPeople(const ScanShapeResult& result, Report& report);

/** The full method with other increments, tolerances and numbers of lines. */
void addSweep(const ScanShapeResult& result, Report& report);
/** @} */

}  // namespace mapconv
