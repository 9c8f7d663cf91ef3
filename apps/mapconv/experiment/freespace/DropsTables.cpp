#include <mrpt_mapconv/eval/DropDistance.h>
#include <mrpt_mapconv/eval/LayerErrors.h>
#include <mrpt_mapconv/eval/OccupancyScore.h>
#include <mrpt_mapconv/eval/UpperEdges.h>
#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>

#include <algorithm>
#include <limits>

#include "experiment/freespace/FreespaceResult.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
constexpr double kFloats = 0.2;  // higher over the true floor than this, inferred ground floats [m]

/** What of a world's drops is judged, and along which way down one may go. */
struct Drops
{
  double height;         //!< what is higher is a drop [m]
  eval::CellMask edges;  //!< upper ones, in view
  eval::CellMask below;  //!< the cells beside them that lie lower
  eval::CellMask ramp;
};

Drops dropsOf(const FreespaceResult& result)
{
  const FreespaceWorld& world = result.world;
  const sim::World& bodies = result.scenario->world;
  const auto& truth = result.maps.truth;
  const double height = (world.strict.maxStepVoxels(world.resolution) + 1) * world.resolution;
  // what stands about has edges as well, but nobody drives up there
  auto standing = world.objects;
  standing.insert(standing.end(), world.lowWalls.begin(), world.lowWalls.end());
  const auto edges = eval::without(eval::upperEdges(truth.floor, height),
                                   eval::cellsOf(bodies, standing, truth.frame()));
  const auto inView = eval::both(edges, result.maps.inView);
  return {height, inView,
          eval::both(eval::lowerEdges(truth.floor, height), eval::around(inView, 1)),
          eval::cellsOf(bodies, {world.drops->ramp}, truth.frame())};
}

/** How near a way comes to drops [m]. */
double leastDistance(const Way& way, const eval::DropDistance& distance)
{
  constexpr double kStep = 0.05;  // [m]
  double least = std::numeric_limits<double>::infinity();
  anyAlong(way, kStep,
           [&](const auto& at)
           {
             least = std::min(least, distance.to({at.x, at.y}));
             return false;
           });
  return least;
}

/** How near a map's ways come to drops. */
struct Nearness
{
  double least = std::numeric_limits<double>::infinity();  //!< of all ways [m]
  std::size_t tooNear = 0;                                 //!< ways nearer than the robot's radius
};

Nearness nearness(const std::vector<Way>& ways, const eval::DropDistance& distance, double radius)
{
  Nearness result;
  for (const Way& way : ways)
  {
    const double least = leastDistance(way, distance);
    result.least = std::min(result.least, least);
    result.tooNear += least < radius;
  }
  return result;
}

void addEdges(const FreespaceResult& result, const Drops& drops, Table& table)
{
  const auto& target = result.world.drops->edgesFound;
  const eval::DropDistance distance(result.maps.truth.floor, drops.below, drops.height);
  for (std::size_t i = 0; i < kGroundMaps; ++i)
  {
    const GroundMap& map = result.maps.ground[i];
    const bool judges = target && map.params.floorFrom == freespace::FloorFrom::Seen;
    const double found =
        eval::scoreWithinOneCell(map.layers.ground, result.maps.truth.ground, drops.edges)
            .occupied.recall();
    const auto& ways = result.groundRuns.onMap[i].ways;
    const Nearness near = nearness(ways, distance, result.world.robotRadius);
    table.addRow({result.world.name, map.name, fixed(drops.height, 2),
                  std::to_string(eval::count(drops.edges)), percent(found),
                  judges ? judged(fixed(*target, 0) + " %", 100 * found >= *target) : "",
                  std::to_string(ways.size()), fixed(near.least, 2), std::to_string(near.tooNear),
                  judges ? judged("none", near.tooNear == 0) : ""});
  }
}

/** Cells whose inferred ground is too high over the true one. */
std::ptrdiff_t floatingCells(const freespace::Layers& layers, const grid::Layer<float>& truth)
{
  const auto& evidence = layers.evidence;
  const auto inferred = eval::without(eval::cellsFrom(evidence, freespace::evidence::kInferred),
                                      eval::cellsFrom(evidence, freespace::evidence::kOpen));
  const auto errors = eval::errorsOf(layers.support, truth, inferred);
  return std::count_if(errors.begin(), errors.end(), [](double error) { return error > kFloats; });
}

/** "63.2 % of 1830". */
std::string shareOf(const eval::CellMask& all, const eval::CellMask& part)
{
  const std::size_t cells = eval::count(all);
  return percent(static_cast<double>(eval::count(eval::both(all, part))) /
                 static_cast<double>(cells)) +
         " of " + std::to_string(cells);
}

void addRamp(const FreespaceResult& result, const Drops& drops, Table& table)
{
  const voxel::OctreeSource<octomap::OcTree> voxels(*result.run.tree);
  const auto& truth = result.maps.truth;
  const DropsWorld& world = *result.world.drops;
  for (const GroundMap& map : result.maps.ground)
  {
    const auto path = planGround(map, result.world, {world.from, world.to}, voxels);
    const auto free = eval::freeCells(map.layers.ground);
    const bool infers = map.params.floorFrom == freespace::FloorFrom::Seen;
    const auto floating = infers ? floatingCells(map.layers, truth.floor) : 0;
    table.addRow({result.world.name, map.name, infers ? std::to_string(floating) : "-",
                  infers && world.floating ? judged("at most " + std::to_string(*world.floating),
                                                    floating <= *world.floating)
                                           : "",
                  path.found() ? fixed(path.path.length(), 1) + " m" : "none: " + path.problem,
                  shareOf(drops.ramp, free),
                  shareOf(eval::both(drops.ramp, eval::freeCells(truth.ground)), free)});
  }
}
}  // namespace

void addDrops(const Results& results, Report& report)
{
  Table edges{
      "drop_edges",
      "Edges of drops: the upper cells in view beside what lies lower by more than a step "
      "and a voxel",
      {"world", "map", "drop [m]", "edge cells", "with an occupied cell within one cell", "target",
       "paths", "nearest to a drop [m]", "paths nearer than the robot's radius", "target"},
      {}};
  Table ramps{"drops_and_ramp",
              "Ground over drops, and the ramp down beside them",
              {"world", "map", "inferred cells that float", "target", "path down the ramp",
               "its cells that are free", "its truly free cells that are free"},
              {}};
  for (const FreespaceResult& result : results)
  {
    const Drops drops = dropsOf(result);
    addEdges(result, drops, edges);
    addRamp(result, drops, ramps);
  }
  edges.note =
      "Paths are those of the pairs above. How near they come to a drop is taken where they are "
      "above it, to the squares of the lower cells beside the edge, over which the robot's disc "
      "must not hang.";
  ramps.note =
      "Inferred ground floats if it is more than " + fixed(kFloats, 1) + " m over the true floor.";
  report.addHeading("Drops");
  report.addTable(edges);
  report.addTable(ramps);
}

}  // namespace mapconv
