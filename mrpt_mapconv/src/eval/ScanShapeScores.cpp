#include <mrpt_mapconv/eval/OccupancyScore.h>
#include <mrpt_mapconv/eval/ScanShapeScores.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/sim/Truth.h>

#include <cmath>

namespace mrpt_mapconv::eval
{
namespace
{
/** The cells whose centre lies within a rectangle. */
CellMask cellsIn(const sim::Footprint& rectangle, const grid::GridFrame& frame)
{
  CellMask mask(frame, 0);
  for (std::int32_t iy = 0; iy < frame.height; ++iy)
    for (std::int32_t ix = 0; ix < frame.width; ++ix)
      mask.at(ix, iy) =
          holds(rectangle, frame.centreOf(frame.x0 + ix), frame.centreOf(frame.y0 + iy));
  return mask;
}

/** A map of which only the occupied cells are left. */
grid::Layer<float> onlyOccupied(grid::Layer<float> map)
{
  for (float& cell : map.cells())
    if (!grid::isOccupied(cell)) cell = grid::kUnknown;
  return map;
}

bool isWithin(const sim::Footprint& rectangle, const sim::World& world)
{
  return rectangle.xMin >= world.min().x && rectangle.xMax <= world.max().x &&
         rectangle.yMin >= world.min().y && rectangle.yMax <= world.max().y;
}

bool anyFree(const CellMask& cells, const grid::Layer<float>& obstacles)
{
  for (std::size_t i = 0; i < cells.cells().size(); ++i)
    if (cells.cells()[i] && grid::isFree(obstacles.cells()[i])) return true;
  return false;
}

/** The truth laid on a map's frame. */
grid::Layer<float> truthOn(const grid::GridFrame& frame, const ScanShapeTruth& truth)
{
  return truth.obstacles.onFrame(frame, grid::kUnknown);
}
}  // namespace

ScanShapeTruth truthOf(const sim::Scenario& scenario, double resolution,
                       const scan::ProfileParams& profile, const std::vector<MapRegion>& regions)
{
  const auto start = scenario.trajectory.poseAt(0);
  const grid::GridFrame frame = sim::frameOf(scenario.world, resolution);
  ScanShapeTruth truth;
  truth.obstacles = sim::obstacleLayer(scenario.world, frame, start.z() + profile.objectMinZ,
                                       start.z() + profile.objectMaxZ);
  truth.should = cellsToLabel(truth.obstacles, start.x(), start.y());
  truth.shouldBeOccupied = both(truth.should, cellsFrom(truth.obstacles, 0.5f));
  for (const MapRegion& region : regions) truth.regions.push_back(cellsIn(region.area, frame));
  return truth;
}

bool isPlaceIn(const sim::Footprint& rectangle, const sim::World& world,
               const ScanShapeTruth& truth)
{
  return isWithin(rectangle, world) &&
         anyFree(cellsIn(rectangle, truth.obstacles.frame()), truth.obstacles);
}

MapScore scoreOf(const grid::Layer<float>& map, const ScanShapeTruth& truth)
{
  const CellMask everywhere(truth.obstacles.frame(), 1);
  return {scoreLabels(map, truth.obstacles, truth.should),
          scoreLabels(onlyOccupied(map), truth.obstacles, truth.shouldBeOccupied),
          occupiedLabelledFree(map, truth.obstacles, everywhere)};
}

RegionScore scoreRegion(const grid::Layer<float>& map, const ScanShapeTruth& truth,
                        std::size_t region)
{
  const CellMask& cells = truth.regions.at(region);
  const auto free = scoreOccupancy(map, truth.obstacles, cells).free;
  const double cellArea = map.frame().resolution * map.frame().resolution;
  return {static_cast<double>(free.found + free.missed) * cellArea, free.recall(),
          occupiedLabelledFree(map, truth.obstacles, cells)};
}

FalseObstacles falseObstacles(const grid::Layer<float>& map, const ScanShapeTruth& truth,
                              const grid::Layer<CellHistory>& history)
{
  const auto obstacles = truthOn(map.frame(), truth);
  FalseObstacles found;
  for (std::size_t i = 0; i < map.cells().size(); ++i)
  {
    if (!grid::isOccupied(map.cells()[i]) || grid::isOccupied(obstacles.cells()[i])) continue;
    ++found.cells;
    found.onlyGhosts += history.cells()[i].ghost && !history.cells()[i].real;
  }
  return found;
}

PeopleTraces& PeopleTraces::operator+=(const PeopleTraces& o)
{
  seen += o.seen;
  freeInTruth += o.freeInTruth;
  occupied += o.occupied;
  hitByPerson += o.hitByPerson;
  notFaded += o.notFaded;
  hitByOthers += o.hitByOthers;
  return *this;
}

PeopleTraces peopleTraces(const grid::Layer<float>& map, const ScanShapeTruth& truth,
                          const grid::Layer<CellHistory>& history)
{
  const auto obstacles = truthOn(map.frame(), truth);
  PeopleTraces traces;
  for (std::size_t i = 0; i < map.cells().size(); ++i)
  {
    const CellHistory& cell = history.cells()[i];
    if (!cell.person) continue;
    ++traces.seen;
    if (!grid::isFree(obstacles.cells()[i])) continue;
    ++traces.freeInTruth;
    if (!grid::isOccupied(map.cells()[i])) continue;
    ++traces.occupied;
    const bool faded = cell.freeSincePerson >= kScansToFade;
    traces.hitByPerson += cell.hitByPerson;
    traces.notFaded += cell.hitByPerson && faded;
    traces.hitByOthers += !cell.hitByPerson && faded;
  }
  return traces;
}

}  // namespace mrpt_mapconv::eval
