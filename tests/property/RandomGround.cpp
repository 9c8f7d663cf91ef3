#include "RandomGround.h"

#include <algorithm>

namespace mrpt_mapconv::test
{
using oracle::DenseMap;
using oracle::Voxel;

namespace
{
constexpr int kHeight = 44, kGround = 18;

/** Height of the true ground, as voxel of the array. */
struct Ground
{
  int riseX, riseY, per;       //!< slopes, in voxels per so many cells
  int stepAt, step;            //!< a step along a line
  int rough;                   //!< at most so many voxels up and down
  int holeX, holeY, holeSide;  //!< a square that is deeper
  int depth;

  int at(Rng& rng, int ix, int iy) const
  {
    int z = kGround + riseX * ix / per + riseY * iy / per + (ix > stepAt ? step : 0);
    const bool hole = ix >= holeX && ix < holeX + holeSide && iy >= holeY && iy < holeY + holeSide;
    if (hole) z -= depth;
    if (rough > 0) z += pick(rng, -rough, rough);
    return std::clamp(z, 1, kHeight - 8);
  }
};

Ground randomRelief(Rng& rng, int side)
{
  Ground ground{};
  const bool tilted = chance(rng, 40);
  ground.riseX = tilted ? pick(rng, -2, 2) : 0, ground.riseY = tilted ? pick(rng, -2, 2) : 0;
  ground.per = pick(rng, 1, 12);
  ground.stepAt = pick(rng, 0, side), ground.step = chance(rng, 50) ? pick(rng, -12, 6) : 0;
  ground.rough = chance(rng, 30) ? pick(rng, 1, 2) : 0;
  ground.holeX = pick(rng, 0, side), ground.holeY = pick(rng, 0, side);
  ground.holeSide = pick(rng, 0, 20), ground.depth = pick(rng, 1, 15);
  return ground;
}

/** Which columns of a region were not seen, and how far over the ground their free space ends. */
struct Unseen
{
  int x, y, xEnd, yEnd;
  int above;    //!< voxels; negative: the free space is deeper than the ground around
  int percent;  //!< share of its columns
  ColumnKind kind;
};

Unseen randomUnseen(Rng& rng, int nx, int ny)
{
  Unseen region{};
  region.x = pick(rng, -5, nx - 1), region.y = pick(rng, -5, ny - 1);
  const int longSide = pick(rng, 1, 60), shortSide = pick(rng, 1, chance(rng, 70) ? 6 : 30);
  const bool alongX = chance(rng, 50);
  region.xEnd = region.x + (alongX ? longSide : shortSide);
  region.yEnd = region.y + (alongX ? shortSide : longSide);
  region.above = chance(rng, 60) ? pick(rng, -1, 2) : pick(rng, -10, 10);
  region.percent = chance(rng, 50) ? 100 : pick(rng, 20, 95);
  region.kind = chance(rng, 75)   ? ColumnKind::Open
                : chance(rng, 80) ? ColumnKind::None
                                  : ColumnKind::Wall;
  return region;
}

void addWalls(Rng& rng, DenseMap& map)
{
  for (int i = pick(rng, 0, 3); i > 0; --i)
  {
    const bool alongX = chance(rng, 50);
    const int at = pick(rng, 0, (alongX ? map.ny : map.nx) - 1);
    const int end = alongX ? map.nx : map.ny, begin = pick(rng, 0, end - 1);
    for (int k = begin; k < std::min(end, begin + pick(rng, 1, 40)); ++k)
      setColumn(rng, map, alongX ? k : at, alongX ? at : k, ColumnKind::Wall, kGround);
  }
}

double randomLength(Rng& rng, double resolution)
{
  switch (pick(rng, 0, 3))
  {
    case 0:
      return 0;
    case 1:
      return pick(rng, 1, 8) * resolution;
    case 2:
      return uniform(rng, 0, 20 * resolution);
    default:
      return pick(rng, 1, 80) * resolution;
  }
}

}  // namespace

void setColumn(Rng& rng, DenseMap& map, int ix, int iy, ColumnKind kind, int floor)
{
  for (int iz = 0; iz < map.nz; ++iz) map.at(ix, iy, iz) = Voxel::Unknown;
  const auto set = [&](int begin, int end, Voxel state)
  {
    for (int iz = std::max(0, begin); iz < std::min(map.nz, end); ++iz) map.at(ix, iy, iz) = state;
  };
  if (kind == ColumnKind::None) return;
  const int top = floor + pick(rng, 6, 20);
  if (kind == ColumnKind::Wall)
    set(floor - 1, top, Voxel::Occupied);
  else
    set(floor, top, Voxel::Free);
  if (kind == ColumnKind::Seen) set(floor - pick(rng, 1, 2), floor, Voxel::Occupied);
  // under an open column there may be something that is not right under its free space
  if (kind == ColumnKind::Open && chance(rng, 20)) set(0, floor - pick(rng, 1, 4), Voxel::Occupied);
  if (chance(rng, 10)) set(top, top + 1, Voxel::Occupied);
}

DenseMap randomGround(Rng& rng, double resolution)
{
  DenseMap map;
  map.resolution = resolution;
  map.x0 = 32 * pick(rng, -3, 2) + pick(rng, -9, 9), map.y0 = 32 * pick(rng, -3, 2);
  map.z0 = chance(rng, 80) ? pick(rng, -60, 20) : chance(rng, 50) ? -32768 : 32768 - kHeight;
  map.nx = pick(rng, 1, 75), map.ny = chance(rng, 70) ? pick(rng, 1, 75) : pick(rng, 1, 4);
  map.nz = kHeight;
  map.voxels.assign(static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny) * kHeight,
                    Voxel::Unknown);
  const Ground ground = randomRelief(rng, std::max(map.nx, map.ny));
  std::vector<int> heights;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      heights.push_back(ground.at(rng, ix, iy));
      setColumn(rng, map, ix, iy, ColumnKind::Seen, heights.back());
    }
  for (int i = pick(rng, 1, 14); i > 0; --i)
  {
    const Unseen region = randomUnseen(rng, map.nx, map.ny);
    for (int iy = std::max(0, region.y); iy < std::min(map.ny, region.yEnd); ++iy)
      for (int ix = std::max(0, region.x); ix < std::min(map.nx, region.xEnd); ++ix)
        if (chance(rng, region.percent))
          setColumn(rng, map, ix, iy, region.kind,
                    region.above + heights[static_cast<std::size_t>(iy * map.nx + ix)]);
  }
  addWalls(rng, map);
  setColumn(rng, map, 0, 0, ColumnKind::Seen, kGround);  // never empty
  return map;
}

freespace::ConversionParams randomGroundParams(Rng& rng, double resolution)
{
  auto params = freespace::ConversionParams::paper();
  params.floorFrom = freespace::FloorFrom::Seen;
  params.minClearance = pick(rng, 1, 8) * resolution;
  params.minOccupancy = 0.25 * pick(rng, 0, 4);
  params.slopeWindow = chance(rng, 95) ? pick(rng, 1, 4) : 21;
  params.maxSlope = chance(rng, 40)   ? 1000
                    : chance(rng, 50) ? 0.25 * pick(rng, 0, 8)
                                      : uniform(rng, 0, 3);
  params.maxStep = chance(rng, 30)   ? 0
                   : chance(rng, 70) ? pick(rng, 1, 5) * resolution
                                     : uniform(rng, 0, 5 * resolution);
  if (chance(rng, 15)) params.maxStep.reset();
  params.maxGap = chance(rng, 40) ? 6 : randomLength(rng, resolution);
  const double hidden = chance(rng, 40) ? 1 : randomLength(rng, resolution);
  params.maxHiddenGap = hidden;
  if (chance(rng, 15)) params.reading.unknown = voxel::Unknown::Free;
  return params;
}

}  // namespace mrpt_mapconv::test
