#include "output/StepReport.h"

#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>

namespace mapconv
{
using mrpt_mapconv::eval::StepMatch;

namespace
{
/** What the steps of a map are like beside the true ones. */
struct StepFigures
{
  std::size_t steps = 0, found = 0;
  double worstHeight = NAN, worstDepth = NAN;  //!< absolute errors [m]; NaN: none is known
};

StepFigures figuresOf(const std::vector<StepMatch>& steps)
{
  StepFigures figures;
  for (const StepMatch& step : steps)
  {
    ++figures.steps;
    figures.found += step.found.has_value();
    figures.worstHeight = std::fmax(figures.worstHeight, std::abs(step.heightError()));
    figures.worstDepth = std::fmax(figures.worstDepth, std::abs(step.depthError()));
  }
  return figures;
}

std::string number(double value, int digits)
{
  return std::isfinite(value) ? mrpt::format("%.*f", digits, value) : "";
}

/** A line of the table. \param unknown stands for what is not known */
std::string row(const StepMatch& step, const std::string& unknown)
{
  std::string text = mrpt::format("%7.2f %6.2f", step.truth.x, step.truth.y);
  for (const auto& [truth, found] :
       {std::pair(step.truth.height, step.found ? step.found->height : NAN),
        std::pair(step.truth.depth, step.found ? step.found->depth : NAN)})
    for (const double value : {truth, found})
      text +=
          mrpt::format(" %8s", std::isfinite(value) ? number(value, 3).c_str() : unknown.c_str());
  return text + (step.found ? "" : "  not found") + "\n";
}
}  // namespace

std::string stepMatchesCsv(const std::vector<StepMatch>& steps)
{
  std::string text = "x,y,directionX,directionY,trueHeight,height,trueDepth,depth\n";
  for (const StepMatch& step : steps)
  {
    text += mrpt::format("%.4f,%.4f,%.4f,%.4f,%.4f,", step.truth.x, step.truth.y,
                         step.truth.directionX, step.truth.directionY, step.truth.height);
    text += number(step.found ? step.found->height : NAN, 4) + "," + number(step.truth.depth, 4) +
            "," + number(step.found ? step.found->depth : NAN, 4) + "\n";
  }
  return text;
}

std::string stepMatchesText(const std::vector<StepMatch>& steps)
{
  const StepFigures figures = figuresOf(steps);
  std::string text =
      mrpt::format("true steps   %zu on the robot's way, %zu found", figures.steps, figures.found);
  if (std::isfinite(figures.worstHeight))
    text += mrpt::format("; largest error of heights %.1f mm", 1e3 * figures.worstHeight);
  if (std::isfinite(figures.worstDepth))
    text += mrpt::format(", of depths %.1f mm", 1e3 * figures.worstDepth);
  text += "\n";
  if (steps.empty()) return text;
  text += "  x [m]  y [m]   height  in map    depth  in map\n";
  for (const StepMatch& step : steps) text += row(step, "-");
  return text;
}

void addStepMatches(const std::vector<StepMatch>& steps, JsonObject& json)
{
  const StepFigures figures = figuresOf(steps);
  json.add("trueSteps", figures.steps).add("trueStepsFound", figures.found);
  json.add("worstStepHeightError", figures.worstHeight);
  json.add("worstStepDepthError", figures.worstDepth);
}

}  // namespace mapconv
