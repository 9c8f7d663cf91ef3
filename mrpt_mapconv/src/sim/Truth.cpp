#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "../grid/Parallel.h"

namespace mrpt_mapconv::sim
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSlack = 1e-9;    // a value that is exactly a limit keeps it after roundings [m]
constexpr std::size_t kSteps = 8;  // of the lattice that is laid over a cell
constexpr double kHair = 1e-6;     // from a cell's border to the lattice's outermost points [m]

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

  /** Whether a solid reaches into zMin … zMax [m]. */
  bool isHitBetween(double x, double y, double zMin, double zMax)
  {
    m_world.solidsAt(x, y, m_solids);
    return std::any_of(m_solids.begin(), m_solids.end(),
                       [&](const Solid& solid)
                       { return solid.bottom < zMax - kSlack && solid.top > zMin + kSlack; });
  }

  /** Whether there is a solid at z [m] or below. */
  bool hasGround(double x, double y, double z)
  {
    m_world.solidsAt(x, y, m_solids);
    return !m_solids.empty() && m_solids.front().bottom < z + kSlack;
  }

 private:
  const World& m_world;
  std::vector<Solid> m_solids;
  Line m_line;
};

/** Where a line of the lattice over a cell lies on one axis [m]; within the world's bounds.
 * \param low lower border of the cell \param aside how far the outermost lines lie beyond the
 * cell's borders */
double latticePlace(double low, double size, std::size_t step, double aside, double min, double max)
{
  const double hair = step == 0 ? -aside : step == kSteps ? aside : 0;
  return std::clamp(low + size * static_cast<double>(step) / kSteps + hair, min, max);
}

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
  const auto place = [size](double low, std::size_t step, double min, double max)
  { return latticePlace(low, size, step, kHair, min, max); };
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

/** A cell of a layer. */
struct Cell
{
  std::size_t index;        // in the layer
  double xLow, yLow;        // lower corner [m]
  double xCentre, yCentre;  // [m]
};

/** Calls see(probe, cell) for the cells whose centre is within the bounds; several threads do.
 * \param threads 0 = all cores */
template <class See>
void forEachCellWithin(const World& world, const grid::GridFrame& frame, int threads,
                       const See& see)
{
  const auto seeRow = [&](Probe& probe, std::int32_t ky)
  {
    const double y = frame.centreOf(ky);
    if (y < world.min().y || y > world.max().y) return;
    for (std::int32_t kx = frame.x0; kx < frame.xEnd(); ++kx)
    {
      const double x = frame.centreOf(kx);
      if (x < world.min().x || x > world.max().x) continue;
      see(probe, Cell{frame.indexOfKey(kx, ky), frame.edgeOf(kx), frame.edgeOf(ky), x, y});
    }
  };
  grid::inParallel(static_cast<std::size_t>(std::max(0, frame.height)), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     Probe probe(world);
                     for (std::size_t iy = begin; iy < end; ++iy)
                       seeRow(probe, frame.y0 + static_cast<std::int32_t>(iy));
                   });
}

/** Whether a solid reaches into zMin … zMax [m] on a line of the lattice. */
bool isHitIn(const World& world, const Cell& cell, double size, double zMin, double zMax,
             Probe& probe)
{
  // a hair within the border: what ends right there is not in the cell
  const auto place = [size](double low, std::size_t step, double min, double max)
  { return latticePlace(low, size, step, -kHair, min, max); };
  for (std::size_t j = 0; j <= kSteps; ++j)
    for (std::size_t i = 0; i <= kSteps; ++i)
      if (probe.isHitBetween(place(cell.xLow, i, world.min().x, world.max().x),
                             place(cell.yLow, j, world.min().y, world.max().y), zMin, zMax))
        return true;
  return false;
}
}  // namespace

void TruthParams::check() const
{
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  params::require(positive(minClearance), "minClearance", minClearance, "a finite height > 0 m");
  params::require(positive(robotHeight), "robotHeight", robotHeight, "a finite height > 0 m");
  params::require(std::isfinite(maxSlope) && maxSlope >= 0, "maxSlope", maxSlope,
                  "a finite slope >= 0");
  params::require(std::isfinite(maxStep) && maxStep >= 0, "maxStep", maxStep,
                  "a finite height >= 0 m");
}

grid::GridFrame frameOf(const World& world, double resolution)
{
  constexpr double kMostCells = 4e7, kMostOnASide = 1e5, kFarthest = 1e9;
  const double across = (world.max().x - world.min().x) / resolution;
  const double along = (world.max().y - world.min().y) / resolution;
  const double farthest = std::max({std::abs(world.min().x), std::abs(world.min().y),
                                    std::abs(world.max().x), std::abs(world.max().y)});
  params::require(resolution > 0 && std::max(across, along) < kMostOnASide &&
                      (across + 2) * (along + 2) <= kMostCells && farthest / resolution < kFarthest,
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
  forEachCellWithin(
      world, frame, threads,
      [&](Probe& probe, const Cell& cell)
      {
        if (judge(probe.lineAt(cell.xCentre, cell.yCentre), params, layers, cell.index) &&
            !jumpsIn(world, cell.xLow, cell.yLow, frame.resolution, params.maxStep, probe))
          layers.ground.cells()[cell.index] = grid::kFree;
      });
  return layers;
}

grid::Layer<float> obstacleLayer(const World& world, const grid::GridFrame& frame, double zMin,
                                 double zMax, int threads)
{
  params::require(std::isfinite(zMin), "zMin", zMin, "a finite height [m]");
  params::require(std::isfinite(zMax) && zMax > zMin, "zMax", zMax, "a finite height > zMin [m]");
  grid::Layer<float> layer(frame, grid::kUnknown);
  forEachCellWithin(world, frame, threads,
                    [&](Probe& probe, const Cell& cell)
                    {
                      if (isHitIn(world, cell, frame.resolution, zMin, zMax, probe))
                        layer.cells()[cell.index] = 1.0f;
                      else if (probe.hasGround(cell.xCentre, cell.yCentre, zMin))
                        layer.cells()[cell.index] = grid::kFree;
                    });
  return layer;
}

}  // namespace mrpt_mapconv::sim
