#include "RandomMap.h"

#include <algorithm>

namespace mrpt_mapconv::test
{
using oracle::DenseMap;
using oracle::Voxel;

namespace
{
int smallOrLarge(Rng& rng, int low, int middle, int high)
{
  return chance(rng, 55) ? pick(rng, low, middle) : pick(rng, middle, high);
}

/** A first key: around 0, on and beside block borders, far out on both sides, at the very ends. */
int randomOrigin(Rng& rng, int size)
{
  switch (pick(rng, 0, 5))
  {
    case 0:
      return pick(rng, -size - 3, 3);
    case 1:
      return 32 * pick(rng, -5, 5) + pick(rng, -1, 1);
    case 2:
      return pick(rng, -30050, -29950);
    case 3:
      return pick(rng, 29900, 30000);
    case 4:
      return chance(rng, 50) ? -32768 : 32768 - size;
    default:
      return pick(rng, -400, 400);
  }
}

void noise(Rng& rng, DenseMap& map)
{
  const int occupied = pick(rng, 0, 40), free = pick(rng, 10, 100 - occupied);
  for (Voxel& voxel : map.voxels)
  {
    const int dice = pick(rng, 1, 100);
    voxel = dice <= occupied          ? Voxel::Occupied
            : dice <= occupied + free ? Voxel::Free
                                      : Voxel::Unknown;
  }
}

void columns(Rng& rng, DenseMap& map)
{
  const int emptyColumns = pick(rng, 0, 50), longest = pick(rng, 2, 30);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      if (chance(rng, emptyColumns)) continue;
      for (int iz = 0; iz < map.nz;)
      {
        const auto state = static_cast<Voxel>(pick(rng, 0, 2));
        const int end = std::min(map.nz, iz + pick(rng, 1, longest));
        for (; iz < end; ++iz) map.at(ix, iy, iz) = state;
      }
    }
}

/** Sets part of a column, as far as it lies inside. */
void setRun(DenseMap& map, int ix, int iy, int begin, int end, Voxel state)
{
  for (int iz = std::max(0, begin); iz < std::min(map.nz, end); ++iz) map.at(ix, iy, iz) = state;
}

void building(Rng& rng, DenseMap& map)
{
  const int sightHeight = pick(rng, 5, 60), slopeX = pick(rng, -3, 3), slopeY = pick(rng, -3, 3);
  const int base = map.nz / 3;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      const int step = ix / 8 % 2 * pick(rng, 1, 3);
      const int ground = base + slopeX * ix / 4 + slopeY * iy / 4 + step;
      setRun(map, ix, iy, ground, ground + 1, Voxel::Occupied);
      setRun(map, ix, iy, ground + 1, ground + 1 + sightHeight, Voxel::Free);
    }
  for (int i = pick(rng, 0, 4); i > 0; --i)  // walls, some of them low
  {
    const bool alongX = chance(rng, 50);
    const int at = pick(rng, 0, (alongX ? map.ny : map.nx) - 1), top = pick(rng, 1, map.nz);
    for (int k = 0; k < (alongX ? map.nx : map.ny); ++k)
      setRun(map, alongX ? k : at, alongX ? at : k, 0, top, Voxel::Occupied);
  }
  for (int i = pick(rng, 0, 3); i > 0; --i)  // slabs: tables, bridges, holes of the unknown
  {
    const int x = pick(rng, 0, map.nx - 1), y = pick(rng, 0, map.ny - 1);
    const int z = pick(rng, 0, map.nz - 1), thickness = pick(rng, 1, 4);
    const Voxel state = chance(rng, 75) ? Voxel::Occupied : Voxel::Unknown;
    for (int iy = y; iy < std::min(map.ny, y + 9); ++iy)
      for (int ix = x; ix < std::min(map.nx, x + 9); ++ix)
        setRun(map, ix, iy, z, z + thickness, state);
  }
}

void plane(Rng& rng, DenseMap& map)
{
  const int a = pick(rng, -3, 3), b = chance(rng, 50) ? 0 : pick(rng, -3, 3);
  const int missing = chance(rng, 50) ? 0 : pick(rng, 1, 60), height = pick(rng, 4, 40);
  const int lowest = std::min(0, a * (map.nx - 1)) + std::min(0, b * (map.ny - 1));
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      if (chance(rng, missing)) continue;
      const int floor = a * ix + b * iy - lowest;
      setRun(map, ix, iy, floor, floor + height, Voxel::Free);
    }
}

void sparse(Rng& rng, DenseMap& map)
{
  const int x = pick(rng, 0, map.nx - 1), y = pick(rng, 0, map.ny - 1);
  const int dx = pick(rng, -2, 2), dy = pick(rng, -2, 2), others = pick(rng, 0, 4);
  const auto put = [&](int ix, int iy)
  {
    if (ix < 0 || iy < 0 || ix >= map.nx || iy >= map.ny) return;
    const int floor = pick(rng, 0, map.nz - 1);
    setRun(map, ix, iy, floor, map.nz, chance(rng, 80) ? Voxel::Free : Voxel::Occupied);
  };
  for (int i = 0; i < 12; ++i) put(x + i * dx, y + i * dy);
  for (int i = 0; i < others; ++i) put(pick(rng, 0, map.nx - 1), pick(rng, 0, map.ny - 1));
}

void cubes(Rng& rng, const MapShape& shape, DenseMap& map)
{
  const auto firstAligned = [](int key, int side)
  { return (side - (key & (side - 1))) & (side - 1); };
  for (int i = pick(rng, 1, 40); i > 0; --i)
  {
    const int side = 1 << pick(rng, 0, 5);
    const auto state = static_cast<Voxel>(pick(rng, 0, 2));
    const int x = firstAligned(shape.x0, side) + side * pick(rng, 0, map.nx / side);
    const int y = firstAligned(shape.y0, side) + side * pick(rng, 0, map.ny / side);
    const int z = firstAligned(shape.z0, side) + side * pick(rng, 0, map.nz / side);
    for (int iy = y; iy < std::min(map.ny, y + side); ++iy)
      for (int ix = x; ix < std::min(map.nx, x + side); ++ix)
        setRun(map, ix, iy, z, z + side, state);
  }
}

}  // namespace

std::string MapShape::text() const
{
  return "kind " + std::to_string(static_cast<int>(kind)) + ", first voxel (" + std::to_string(x0) +
         ", " + std::to_string(y0) + ", " + std::to_string(z0) + "), " + std::to_string(nx) + "x" +
         std::to_string(ny) + "x" + std::to_string(nz) + " voxels";
}

MapShape randomShape(Rng& rng)
{
  MapShape shape;
  shape.kind = static_cast<MapKind>(pick(rng, 0, kMapKinds - 1));
  shape.nx = smallOrLarge(rng, 1, 16, 45);
  shape.ny = smallOrLarge(rng, 1, 16, 45);
  shape.nz = smallOrLarge(rng, 1, 70, 150);
  shape.x0 = randomOrigin(rng, shape.nx);
  shape.y0 = randomOrigin(rng, shape.ny);
  shape.z0 = randomOrigin(rng, shape.nz);
  return shape;
}

DenseMap randomVoxels(Rng& rng, const MapShape& shape)
{
  DenseMap map;
  map.x0 = shape.x0, map.y0 = shape.y0, map.z0 = shape.z0;
  map.nx = shape.nx, map.ny = shape.ny, map.nz = shape.nz;
  map.voxels.assign(static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny) *
                        static_cast<std::size_t>(map.nz),
                    Voxel::Unknown);
  switch (shape.kind)
  {
    case MapKind::Noise:
      noise(rng, map);
      break;
    case MapKind::Columns:
      columns(rng, map);
      break;
    case MapKind::Building:
      building(rng, map);
      break;
    case MapKind::Plane:
      plane(rng, map);
      break;
    case MapKind::Sparse:
      sparse(rng, map);
      break;
    case MapKind::Cubes:
      cubes(rng, shape, map);
      break;
  }
  return map;
}

}  // namespace mrpt_mapconv::test
