#include "experiment/freespace/GroundFigures.h"

#include <mrpt_mapconv/eval/LabelScore.h>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** Where a flying robot may be, but nothing is known of the ground. */
eval::CellMask frontierOf(const freespace::Layers& layers)
{
  return eval::without(eval::freeCells(layers.aerial), eval::cellsFrom(layers.ground, 0));
}

double shareWithinOneCell(const std::vector<std::string>& bodies, const FreespaceResult& result,
                          const GroundMap& map)
{
  const auto& truth = result.maps.truth.ground;
  const auto cells = eval::cellsOf(result.scenario->world, bodies, truth.frame());
  return eval::scoreWithinOneCell(map.layers.ground, truth, eval::both(cells, result.maps.inView))
      .occupied.recall();
}
}  // namespace

GroundFigures groundFigures(const FreespaceResult& result, const GroundMap& map)
{
  const auto& truth = result.maps.truth.ground;
  const auto& said = map.layers.ground;
  const auto& inView = result.maps.inView;
  const auto free = eval::freeCells(truth);
  const auto away = eval::both(inView, eval::inside(free, map.params.slopeWindow));
  const auto frontier = frontierOf(map.layers);
  GroundFigures figures;
  figures.score = eval::scoreOccupancy(said, truth, inView);
  figures.falseAwayFromAll = eval::scoreOccupancy(said, truth, away).occupied.wrong;
  figures.occupiedLabelledFree = eval::occupiedLabelledFree(said, truth, inView);
  figures.frontier = eval::count(frontier);
  figures.frontierTrulyFree = eval::count(eval::both(frontier, free));
  figures.lowWalls = shareWithinOneCell(result.world.lowWalls, result, map);
  figures.objects = shareWithinOneCell(result.world.objects, result, map);
  return figures;
}

}  // namespace mapconv
