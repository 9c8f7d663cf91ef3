#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "../freespace/Parallel.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSlack = 1e-9;    // a value that is exactly a limit keeps it after roundings [m]
constexpr std::size_t kSteps = 8;  // of the lattice that jumps are looked for on, to a cell

void requireParameter(bool ok, const char* name, double value, const char* right)
{
  if (ok) return;
  std::ostringstream message;
  message << name << " = " << value << " is not valid: it must be " << right;
  throw std::invalid_argument(message.str());
}

/** Where one could be on a vertical line. */
struct Gap
{
  double floor, ceiling;  // [m]
  double slope;           // of the floor
  double height() const { return ceiling - floor; }
};

/** What the truth says of one vertical line. */
struct Line
{
  bool solid = false;     // there is something within the bounds
  bool gapAbove = false;  // whether gaps.front() is the one above the lowest solid
  std::vector<Gap> gaps;  // from the lowest up
};

/** Vertical lines through a world; holds its scratch memory, so each thread needs its own. */
class Probe
{
 public:
  explicit Probe(const World& world) : m_world(world) {}

  const Line& lineAt(double x, double y)
  {
    const double zMin = m_world.min().z, zMax = m_world.max().z;
    m_world.solidsAt(x, y, m_solids);
    m_line.solid = m_line.gapAbove = false;
    m_line.gaps.clear();
    for (std::size_t i = 0; i < m_solids.size(); ++i)
    {
      const Solid& solid = m_solids[i];
      if (solid.top <= zMin || solid.bottom >= zMax) continue;
      const bool lowest = !m_line.solid;
      m_line.solid = true;
      if (solid.top >= zMax - kSlack) continue;
      m_line.gapAbove = m_line.gapAbove || lowest;
      const double ceiling =
          i + 1 < m_solids.size() ? std::min(m_solids[i + 1].bottom, zMax) : kInfinity;
      m_line.gaps.push_back({solid.top, ceiling, solid.slope});
    }
    return m_line;
  }

  /** Top of the lowest solid within the bounds [m]; NaN: there is none. */
  double lowestTop(double x, double y)
  {
    m_world.solidsAt(x, y, m_solids);
    for (const Solid& solid : m_solids)
      if (solid.top > m_world.min().z && solid.bottom < m_world.max().z)
        return std::min(solid.top, m_world.max().z);
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const World& m_world;
  std::vector<Solid> m_solids;
  Line m_line;
};

/** Whether two neighbouring tops are a jump; a hole in the ground is one, too. */
bool jumps(double a, double b, double maxStep)
{
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) != std::isnan(b);
  return std::abs(a - b) > maxStep + kSlack;
}

/** Whether the lowest solid's top jumps in or on the border of the cell with this lower corner. */
bool jumpsIn(const World& world, double xLow, double yLow, double size, double maxStep,
             Probe& probe)
{
  // The outermost points lie a hair beyond the border, so that a face right on it, which is common
  // in worlds written by hand, counts for the cells on both sides whatever the rounding.
  constexpr double kHair = 1e-6;
  const auto place = [size](double low, std::size_t step, double min, double max)
  {
    const double aside = step == 0 ? -kHair : step == kSteps ? kHair : 0;
    return std::clamp(low + size * static_cast<double>(step) / kSteps + aside, min, max);
  };
  std::array<double, kSteps + 1> below{};
  for (std::size_t j = 0; j <= kSteps; ++j)
  {
    double left = 0;
    for (std::size_t i = 0; i <= kSteps; ++i)
    {
      const double top = probe.lowestTop(place(xLow, i, world.min().x, world.max().x),
                                         place(yLow, j, world.min().y, world.max().y));
      if (i > 0 && jumps(left, top, maxStep)) return true;
      if (j > 0 && jumps(below[i], top, maxStep)) return true;
      left = below[i] = top;
    }
  }
  return false;
}

/** Fills all layers of a cell but the jumps. \return whether a ground robot could be there */
bool judge(const Line& line, const TruthParams& params, freespace::Layers& layers, std::size_t cell)
{
  if (!line.solid) return false;
  const auto flies = [&](const Gap& gap) { return gap.height() >= params.minClearance - kSlack; };
  const auto lowest = std::find_if(line.gaps.begin(), line.gaps.end(), flies);
  layers.aerial.cells()[cell] = lowest == line.gaps.end() ? 1.0f : grid::kFree;
  if (lowest != line.gaps.end())
  {
    const auto highest = std::find_if(line.gaps.rbegin(), line.gaps.rend(), flies);
    layers.floor.cells()[cell] = static_cast<float>(lowest->floor);
    layers.slope.cells()[cell] = static_cast<float>(lowest->slope);
    layers.ceiling.cells()[cell] = static_cast<float>(highest->ceiling);
  }
  layers.ground.cells()[cell] = 1.0f;
  return line.gapAbove && line.gaps.front().height() >= params.robotHeight - kSlack &&
         line.gaps.front().slope <= params.maxSlope + kSlack;
}

void fillRow(const grid::GridFrame& frame, std::int32_t iy, const TruthParams& params,
             const World& world, Probe& probe, freespace::Layers& layers)
{
  const double size = frame.resolution;
  const double y = (frame.y0 + iy + 0.5) * size;
  if (y < world.min().y || y > world.max().y) return;
  for (std::int32_t ix = 0; ix < frame.width; ++ix)
  {
    const double x = (frame.x0 + ix + 0.5) * size;
    if (x < world.min().x || x > world.max().x) continue;
    const std::size_t cell = frame.indexOfKey(frame.x0 + ix, frame.y0 + iy);
    if (judge(probe.lineAt(x, y), params, layers, cell) &&
        !jumpsIn(world, (frame.x0 + ix) * size, (frame.y0 + iy) * size, size, params.maxStep,
                 probe))
      layers.ground.cells()[cell] = grid::kFree;
  }
}
}  // namespace

void TruthParams::check() const
{
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  requireParameter(positive(minClearance), "minClearance", minClearance, "a finite height > 0 m");
  requireParameter(positive(robotHeight), "robotHeight", robotHeight, "a finite height > 0 m");
  requireParameter(std::isfinite(maxSlope) && maxSlope >= 0, "maxSlope", maxSlope,
                   "a finite slope >= 0");
  requireParameter(std::isfinite(maxStep) && maxStep >= 0, "maxStep", maxStep,
                   "a finite height >= 0 m");
}

grid::GridFrame frameOf(const World& world, double resolution)
{
  constexpr double kMostCells = 4e7, kMostOnASide = 1e5, kFarthest = 1e9;
  const double across = (world.max().x - world.min().x) / resolution;
  const double along = (world.max().y - world.min().y) / resolution;
  const double farthest = std::max({std::abs(world.min().x), std::abs(world.min().y),
                                    std::abs(world.max().x), std::abs(world.max().y)});
  requireParameter(resolution > 0 && std::max(across, along) < kMostOnASide &&
                       (across + 2) * (along + 2) <= kMostCells &&
                       farthest / resolution < kFarthest,
                   "resolution", resolution,
                   "> 0 m, and so large that the world's bounds have at most 4e7 cells, 1e5 on a "
                   "side");
  // of a cell: bounds on a cell's border do not touch the cell beyond
  constexpr double kBorder = 1e-6;
  const auto key = [](double v) { return static_cast<std::int32_t>(v); };
  grid::GridFrame frame;
  frame.resolution = resolution;
  frame.x0 = key(std::floor(world.min().x / resolution + kBorder));
  frame.y0 = key(std::floor(world.min().y / resolution + kBorder));
  frame.width = key(std::ceil(world.max().x / resolution - kBorder)) - frame.x0;
  frame.height = key(std::ceil(world.max().y / resolution - kBorder)) - frame.y0;
  return frame;
}

freespace::Layers truthLayers(const World& world, const grid::GridFrame& frame,
                              const TruthParams& params, int threads)
{
  params.check();
  freespace::Layers layers(frame);
  freespace::inParallel(static_cast<std::size_t>(std::max(0, frame.height)), threads,
                        [&](std::size_t begin, std::size_t end)
                        {
                          Probe probe(world);
                          for (std::size_t iy = begin; iy < end; ++iy)
                            fillRow(frame, static_cast<std::int32_t>(iy), params, world, probe,
                                    layers);
                        });
  return layers;
}

}  // namespace mrpt_mapconv::sim
