#include "EvidenceOracle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "ExactPlane.h"

namespace mrpt_mapconv::oracle
{
namespace
{
using Length = std::int64_t;
constexpr int kFine = 64;  // support is counted in such parts of a voxel

struct Step
{
  int dx, dy;
};
constexpr Step kAxes[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}};

/** h: so many whole voxels up or down are no step. */
int stepVoxels(double resolution, const freespace::ConversionParams& params)
{
  const double step = maxStepOf(params, resolution);
  const double metres = step > 0 ? step : std::max(0.2, resolution);
  int voxels = 0;
  while (voxels + 1 <= metres / resolution + 1e-6) ++voxels;
  return voxels;
}

/** Whether `cells` steps along a direction lead at most so many metres away. */
bool within(Length cells, Step direction, double metres, double resolution)
{
  const Length squared = cells * cells * (direction.dx != 0 && direction.dy != 0 ? 2 : 1);
  const double limit = metres / resolution + 1e-6;
  return static_cast<double>(squared) <= limit * limit;
}

/** Greatest whole number that is not above numerator/denominator. */
Length floorOf(Length numerator, Length denominator)
{
  const Length quotient = numerator / denominator;
  return quotient * denominator > numerator ? quotient - 1 : quotient;
}

bool isOpen(const Cell& cell)
{
  return cell.evidence == Evidence::Open || cell.evidence == Evidence::Inferred;
}

/** How many steps lead to the nearest seen cell; 0 if there is none before a wall or the end. */
int stepsToSeen(const DenseResult& cells, int ix, int iy, Step step)
{
  for (int k = 1; cells.inside(ix + k * step.dx, iy + k * step.dy); ++k)
  {
    const Evidence evidence = cells.at(ix + k * step.dx, iy + k * step.dy).evidence;
    if (evidence == Evidence::Seen) return k;
    if (evidence == Evidence::Wall) return 0;
  }
  return 0;
}

/** The straight line between two seen cells, `gap` steps from each other. */
struct Line
{
  int x, y;  //!< where it begins
  Step step;
  int gap;
  Length begin, end;  //!< supports of the two [voxels]

  /** Height after t steps, in parts of a voxel of which `gap` make a whole one. */
  Length at(int t) const { return begin * (gap - t) + end * t; }
  Length squaredGap() const { return Length{gap} * gap * (step.dx * step.dx + step.dy * step.dy); }
};

std::optional<Line> lineThrough(const DenseResult& cells, int ix, int iy, Step step)
{
  const int forth = stepsToSeen(cells, ix, iy, step);
  const int back = stepsToSeen(cells, ix, iy, {-step.dx, -step.dy});
  if (forth == 0 || back == 0) return std::nullopt;
  const int x = ix - back * step.dx, y = iy - back * step.dy;
  return Line{x,
              y,
              step,
              back + forth,
              cells.at(x, y).floorKey,
              cells.at(ix + forth * step.dx, iy + forth * step.dy).floorKey};
}

/** What the clauses (a) to (e) are asked with. */
struct Rules
{
  double resolution;
  const freespace::ConversionParams& params;
  int h;
};

/** (d): of all open cells that the line leads over, the one that it is asked for, too. */
bool leadsOverADeepCell(const DenseResult& cells, const Line& line, const Rules& rules)
{
  for (int t = 1; t < line.gap; ++t)
  {
    const Cell& cell = cells.at(line.x + t * line.step.dx, line.y + t * line.step.dy);
    if (isOpen(cell) &&
        Length{cell.floorKey} * line.gap < line.at(t) - Length{std::max(rules.h, 2)} * line.gap)
      return true;
  }
  return false;
}

/** (e): something known stands on the line, or hangs over it too low.
 * \param height of the line, in parts of which `one` make a voxel */
bool isInTheWay(const Cell& cell, Length height, Length one, const Rules& rules)
{
  const double step = maxStepOf(rules.params, rules.resolution);
  const int drivenOver = step > 0 ? rules.h : 1;
  int needed = 1;
  while (needed < rules.params.minClearance / rules.resolution - 1e-6) ++needed;
  const std::optional<int>&top = cell.occupiedTopUnderFloor,
        &bottom = cell.occupiedBottomAboveFloor;
  return (top && *top * one > height + drivenOver * one) ||
         (bottom && *bottom * one < height + needed * one);
}

/** Whether the line counts for the cell that it meets after t steps. */
bool counts(const DenseResult& cells, const Line& line, int t, const Rules& rules)
{
  const Length one = line.gap;  // a voxel in the line's parts
  const Length height = line.at(t);
  const Cell& here = cells.at(line.x + t * line.step.dx, line.y + t * line.step.dy);
  const Length floor = here.floorKey * one;
  const auto gapWithin = [&](double metres)
  { return within(line.gap, line.step, metres, rules.resolution); };
  const bool shortGap = gapWithin(rules.params.maxHiddenGap);

  const bool a = std::abs(line.begin - line.end) <= rules.h;
  const bool b = height <= floor + (shortGap ? std::max(rules.h, 1) : 1) * one;
  const bool nothingHides = floor <= height + rules.h * one;
  const bool c = gapWithin(rules.params.maxGap) && (nothingHides || shortGap);
  const bool d = !leadsOverADeepCell(cells, line, rules);
  return a && b && c && d && !isInTheWay(here, height, one, rules);
}

void setSupport(double resolution, std::int64_t support64, Cell& cell)
{
  cell.hasSupport = true;
  cell.support64 = support64;
  cell.support = static_cast<float>(static_cast<double>(support64) / kFine * resolution);
}

/** The support of an open cell, in 64ths of voxels. */
std::optional<Length> inferredSupport(const DenseResult& cells, int ix, int iy, const Rules& rules)
{
  std::optional<Line> best;
  Length bestHeight = 0;
  for (const Step step : kAxes)
  {
    const std::optional<Line> line = lineThrough(cells, ix, iy, step);
    if (!line) continue;
    const int t = std::max(std::abs(ix - line->x), std::abs(iy - line->y));
    if (!counts(cells, *line, t, rules)) continue;
    // gaps are of one length only if both run along rows and columns or both diagonally, so both
    // heights are in the same parts
    const bool better = !best || line->squaredGap() < best->squaredGap() ||
                        (line->squaredGap() == best->squaredGap() && line->at(t) < bestHeight);
    if (better) best = line, bestHeight = line->at(t);
  }
  if (!best) return std::nullopt;
  // round(64·height/gap), halves up, is the floor of (2·64·height + gap)/(2·gap)
  return floorOf(2 * kFine * bestHeight + best->gap, 2 * Length{best->gap});
}

void findSupports(const Rules& rules, DenseResult& result)
{
  const DenseResult cells = result;  // as they are before any is inferred
  for (int iy = 0; iy < result.ny; ++iy)
    for (int ix = 0; ix < result.nx; ++ix)
    {
      Cell& cell = result.at(ix, iy);
      cell.support = std::numeric_limits<float>::quiet_NaN();
      if (cell.evidence == Evidence::Seen)
        setSupport(rules.resolution, Length{cell.floorKey} * kFine, cell);
      if (cell.evidence != Evidence::Open) continue;
      const std::optional<Length> support = inferredSupport(cells, ix, iy, rules);
      if (!support) continue;
      setSupport(rules.resolution, *support, cell);
      cell.evidence = Evidence::Inferred;
    }
}

void fitSlopeOfSupports(const Rules& rules, int ix, int iy, DenseResult& result)
{
  const auto supportAt = [&](int dx, int dy) -> std::optional<std::int64_t>
  {
    if (!result.inside(ix + dx, iy + dy)) return std::nullopt;
    const Cell& cell = result.at(ix + dx, iy + dy);
    return cell.hasSupport ? std::optional<std::int64_t>(cell.support64) : std::nullopt;
  };
  fitPlane(rules.params.slopeWindow, supportAt, kFine, rules.params.maxSlope, result.at(ix, iy));
}

bool isStep(const DenseResult& cells, int ix, int iy, int h)
{
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
    {
      if (!cells.inside(ix + dx, iy + dy) || !cells.at(ix + dx, iy + dy).hasSupport) continue;
      const Length difference = cells.at(ix + dx, iy + dy).support64 - cells.at(ix, iy).support64;
      if (std::abs(difference) > kFine * h) return true;
    }
  return false;
}

/** Whether one comes upon a deep floor in a direction: in an open cell without support, or in the
 * first cell that is no such one. */
bool goesDown(const DenseResult& cells, int ix, int iy, Step step, const Rules& rules)
{
  const Length deep = cells.at(ix, iy).support64 - kFine * (rules.h + 1);
  for (int k = 1; within(k, step, 1.0, rules.resolution); ++k)
  {
    if (!cells.inside(ix + k * step.dx, iy + k * step.dy)) return false;
    const Cell& cell = cells.at(ix + k * step.dx, iy + k * step.dy);
    if (cell.free && Length{cell.floorKey} * kFine < deep) return true;
    if (cell.evidence != Evidence::Open) return false;
  }
  return false;
}

bool isDropEdge(const DenseResult& cells, int ix, int iy, const Rules& rules)
{
  for (const Step axis : kAxes)
    if (goesDown(cells, ix, iy, axis, rules) ||
        goesDown(cells, ix, iy, {-axis.dx, -axis.dy}, rules))
      return true;
  return false;
}

}  // namespace

void markEvidence(const DenseMap& map, DenseResult& result)
{
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      Cell& cell = result.at(ix, iy);
      bool anyOccupied = false;
      for (int iz = 0; iz < map.nz; ++iz)
        anyOccupied = anyOccupied || map.at(ix, iy, iz) == Voxel::Occupied;
      const int under = cell.floorKey - 1 - map.z0;
      for (int iz = 0; cell.free && iz <= under; ++iz)
        if (map.at(ix, iy, iz) == Voxel::Occupied) cell.occupiedTopUnderFloor = map.z0 + iz + 1;
      for (int iz = map.nz - 1; cell.free && iz > under; --iz)
        if (map.at(ix, iy, iz) == Voxel::Occupied) cell.occupiedBottomAboveFloor = map.z0 + iz;
      const bool seen = cell.free && under >= 0 && map.at(ix, iy, under) == Voxel::Occupied;
      cell.evidence = seen          ? Evidence::Seen
                      : cell.free   ? Evidence::Open
                      : anyOccupied ? Evidence::Wall
                                    : Evidence::None;
    }
}

void supportIsFloor(double resolution, DenseResult& result)
{
  for (Cell& cell : result.cells)
  {
    cell.support = std::numeric_limits<float>::quiet_NaN();
    if (cell.free) setSupport(resolution, Length{cell.floorKey} * kFine, cell);
  }
}

void judgeBySupport(double resolution, const freespace::ConversionParams& params,
                    DenseResult& result)
{
  const Rules rules{resolution, params, stepVoxels(resolution, params)};
  const bool looksForSteps = maxStepOf(params, resolution) > 0;
  findSupports(rules, result);
  for (int iy = 0; iy < result.ny; ++iy)
    for (int ix = 0; ix < result.nx; ++ix)
    {
      Cell& cell = result.at(ix, iy);
      cell.ground = cell.free && !cell.hasSupport ? -1 : cell.aerial;
      if (!cell.hasSupport) continue;
      fitSlopeOfSupports(rules, ix, iy, result);
      cell.isStep = looksForSteps && isStep(result, ix, iy, rules.h);
      cell.isDrop = looksForSteps && isDropEdge(result, ix, iy, rules);
      if ((cell.hasSlope && cell.slopeTooHigh) || cell.isStep || cell.isDrop) cell.ground = 1;
    }
}

}  // namespace mrpt_mapconv::oracle
