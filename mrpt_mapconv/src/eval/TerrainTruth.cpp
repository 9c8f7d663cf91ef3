#include <mrpt_mapconv/eval/TerrainTruth.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <cmath>
#include <limits>

#include "TruePlanes.h"

namespace mrpt_mapconv::eval
{
using grid::GridFrame;
using grid::Layer;

namespace
{
/** What a vertical line meets within the world's bounds. */
struct Line
{
  SurfacePoint lowest;
  bool several = false;  //!< further surfaces are above
};

Line lineAt(const sim::World& world, double x, double y, std::vector<sim::Solid>& solids)
{
  Line line;
  if (x < world.min().x || x > world.max().x || y < world.min().y || y > world.max().y) return line;
  world.solidsAt(x, y, solids);
  for (const sim::Solid& solid : solids)
  {
    if (solid.top <= world.min().z || solid.bottom >= world.max().z) continue;
    if (std::isfinite(line.lowest.height))
      line.several = true;
    else
      line.lowest = {solid.top, solid.slope};
  }
  return line;
}

/** Cells that a jump goes through. */
CellMask cellsWithJumps(const sim::World& world, const GridFrame& frame, double jump, int threads)
{
  // a robot that nothing stops but jumps
  sim::TruthParams robot;
  robot.minClearance = robot.robotHeight = 1e-3;
  robot.maxSlope = 1e9;
  robot.maxStep = jump;
  return cellsFrom(sim::truthLayers(world, frame, robot, threads).ground, 1);
}
}  // namespace

TerrainTruth terrainTruth(const sim::World& world, const GridFrame& frame, double jump, int threads)
{
  params::require(std::isfinite(jump) && jump >= 0, "jump", jump, "a finite height >= 0 m");
  TerrainTruth truth{{frame, std::numeric_limits<float>::quiet_NaN()},
                     cellsWithJumps(world, frame, jump, threads),
                     {frame, -1},
                     {}};
  Layer<SurfacePoint> surface(frame, SurfacePoint());
  std::vector<sim::Solid> solids;
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
    {
      const Line line =
          lineAt(world, frame.centreOf(frame.x0 + ix), frame.centreOf(frame.y0 + iy), solids);
      truth.height.at(ix, iy) = static_cast<float>(line.lowest.height);
      if (line.several)
        truth.apart.at(ix, iy) = 1;
      else
        surface.at(ix, iy) = line.lowest;
    }
  truth.apart = around(truth.apart, 1);
  truth.planes = truePlanes(surface, truth.plane);
  return truth;
}

}  // namespace mrpt_mapconv::eval
