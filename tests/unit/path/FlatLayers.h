#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/path/LiftPath.h>

namespace mrpt_mapconv::test
{
/** Free cells of 0.25 m, x 0 … 5 m and y 0 … 3 m, all with the floor at 0 m and the ceiling at 3 m:
 * numbers that are exact in binary. */
inline freespace::Layers flatLayers(double resolution = 0.25)
{
  freespace::Layers layers(grid::GridFrame{resolution, 0, 0, 20, 12});
  for (auto& floor : layers.floor.cells()) floor = 0;
  for (auto& ceiling : layers.ceiling.cells()) ceiling = 3;
  for (auto& aerial : layers.aerial.cells()) aerial = grid::kFree;
  return layers;
}

/** Takes a cell's free range away; `aerial` says whether it is a wall or unknown. */
inline void block(freespace::Layers& layers, int ix, int iy, float aerial)
{
  layers.floor.at(ix, iy) = layers.ceiling.at(ix, iy) = freespace::Layers::kNone;
  layers.aerial.at(ix, iy) = aerial;
}

/** A sphere of 0.5 m, which ranges of 1 m always hold. */
inline path::LiftParams sphere(double heightOffset, double lookahead = 0)
{
  path::LiftParams params;
  params.lookahead = lookahead;
  params.heightOffset = heightOffset;
  params.safetyRadius = 0.5;
  return params;
}

inline path::LiftParams ground(double heightOffset, double lookahead)
{
  path::LiftParams params = sphere(heightOffset, lookahead);
  params.robot = freespace::Robot::Ground;
  return params;
}

}  // namespace mrpt_mapconv::test
