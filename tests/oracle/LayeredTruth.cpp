#include "LayeredTruth.h"

#include <cmath>
#include <limits>
#include <vector>

namespace mrpt_mapconv::oracle
{
namespace
{
constexpr double kSlack = 1e-9;

/** One vertical line as steps that are solid or not, from the lower bound up. */
std::vector<bool> stepsAt(const LayeredWorld& world, double x, double y)
{
  std::vector<bool> steps;
  const auto count = std::lround((world.max.z - world.min.z) / world.step);
  for (long i = 0; i < count; ++i)
    steps.push_back(world.isSolid(x, y, world.min.z + (double(i) + 0.5) * world.step));
  return steps;
}

/** Number of the step above the lowest solid; -1 if there is none. */
int topOfLowest(const std::vector<bool>& steps)
{
  std::size_t i = 0;
  while (i < steps.size() && !steps[i]) ++i;
  if (i == steps.size()) return -1;
  while (i < steps.size() && steps[i]) ++i;
  return int(i);
}

/** Number of the next solid step; one past the last if there is none within the bounds. */
std::size_t nextSolid(const std::vector<bool>& steps, std::size_t i)
{
  while (i < steps.size() && !steps[i]) ++i;
  return i;
}

bool solidBeyond(const LayeredWorld& world, double x, double y)
{
  for (int i = 0; i < 1000; ++i)
    if (world.isSolid(x, y, world.max.z + (i + 0.5) * world.step)) return true;
  return false;
}

struct Cell
{
  bool any = false, flies = false, stands = false;
  double floor = 0, ceiling = 0;
};

Cell cellAt(const LayeredWorld& world, double x, double y, const sim::TruthParams& params)
{
  const auto steps = stepsAt(world, x, y);
  const auto z = [&](std::size_t i) { return world.min.z + double(i) * world.step; };
  Cell cell;
  cell.any = topOfLowest(steps) >= 0;
  for (std::size_t i = 1; i < steps.size(); ++i)
  {
    if (!steps[i - 1] || steps[i]) continue;  // not the top of a solid
    const std::size_t end = nextSolid(steps, i);
    double ceiling = z(end);
    if (end == steps.size() && !solidBeyond(world, x, y))
      ceiling = std::numeric_limits<double>::infinity();
    const double height = ceiling - z(i);
    if (int(i) == topOfLowest(steps)) cell.stands = height >= params.robotHeight - kSlack;
    if (height < params.minClearance - kSlack) continue;
    if (!cell.flies) cell.floor = z(i);
    cell.flies = true;
    cell.ceiling = ceiling;
  }
  return cell;
}

bool jumpsIn(const LayeredWorld& world, double x0, double y0, double cell, double maxStep)
{
  int top[9][9];
  const auto at = [cell](double low, int i, double min, double max)
  {
    const double outwards = i == 0 ? -1e-6 : i == 8 ? 1e-6 : 0;
    return std::max(min, std::min(max, low + cell * i / 8 + outwards));
  };
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i)
      top[j][i] = topOfLowest(
          stepsAt(world, at(x0, i, world.min.x, world.max.x), at(y0, j, world.min.y, world.max.y)));
  const auto jumps = [&](int a, int b)
  {
    if (a < 0 || b < 0) return (a < 0) != (b < 0);
    return std::abs(a - b) * world.step > maxStep + kSlack;
  };
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i)
    {
      if (i < 8 && jumps(top[j][i], top[j][i + 1])) return true;
      if (j < 8 && jumps(top[j][i], top[j + 1][i])) return true;
    }
  return false;
}
}  // namespace

freespace::Layers truthOf(const LayeredWorld& world, const grid::GridFrame& frame,
                          const sim::TruthParams& params)
{
  freespace::Layers layers(frame);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
    {
      const double size = frame.resolution;
      const double x0 = (frame.x0 + ix) * size, y0 = (frame.y0 + iy) * size;
      const Cell cell = cellAt(world, x0 + size / 2, y0 + size / 2, params);
      if (!cell.any) continue;
      layers.aerial.at(ix, iy) = cell.flies ? 0.0f : 1.0f;
      layers.ground.at(ix, iy) =
          cell.stands && !jumpsIn(world, x0, y0, size, params.maxStep) ? 0.0f : 1.0f;
      if (!cell.flies) continue;
      layers.floor.at(ix, iy) = float(cell.floor);
      layers.ceiling.at(ix, iy) = float(cell.ceiling);
      layers.slope.at(ix, iy) = 0;
    }
  return layers;
}
}  // namespace mrpt_mapconv::oracle
