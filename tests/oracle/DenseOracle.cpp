#include "DenseOracle.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "EvidenceOracle.h"
#include "ExactPlane.h"

namespace mrpt_mapconv::oracle
{
namespace
{
/** Overlap of a column's occupied voxels with a free neighbour's [floor, ceiling], in voxels. */
int overlapWith(const DenseMap& map, int ix, int iy, const Cell& neighbour)
{
  int overlap = 0;
  for (int kz = neighbour.floorKey; kz < neighbour.ceilingKey; ++kz)
    if (map.at(ix, iy, kz - map.z0) == Voxel::Occupied) ++overlap;
  return overlap;
}

}  // namespace

void findHeights(const DenseMap& map, double minClearance, DenseResult& result)
{
  int minRun = 1;
  while (minRun < minClearance / map.resolution - 1e-6) ++minRun;

  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      Cell& cell = result.at(ix, iy);
      int run = 0;
      for (int iz = 0; iz < map.nz; ++iz)
      {
        run = map.at(ix, iy, iz) == Voxel::Free ? run + 1 : 0;
        if (run < minRun) continue;
        // every voxel from the minRun-th on belongs to a kept run and is the highest one so far
        if (!cell.free) cell.floorKey = map.z0 + iz + 1 - run;
        cell.free = true;
        cell.ceilingKey = map.z0 + iz + 1;
      }
      constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
      cell.floor = cell.free ? static_cast<float>(cell.floorKey * map.resolution) : kNone;
      cell.ceiling = cell.free ? static_cast<float>(cell.ceilingKey * map.resolution) : kNone;
    }
}

void fitSlope(int slopeWindow, double maxSlope, int ix, int iy, DenseResult& result)
{
  const auto floorAt = [&](int dx, int dy) -> std::optional<std::int64_t>
  {
    if (!result.inside(ix + dx, iy + dy) || !result.at(ix + dx, iy + dy).free) return std::nullopt;
    return result.at(ix + dx, iy + dy).floorKey;
  };
  fitPlane(slopeWindow, floorAt, 1, maxSlope, result.at(ix, iy));
}

void fitSlopes(int slopeWindow, double maxSlope, DenseResult& result)
{
  for (int iy = 0; iy < result.ny; ++iy)
    for (int ix = 0; ix < result.nx; ++ix) fitSlope(slopeWindow, maxSlope, ix, iy, result);
}

void markAerial(const DenseMap& map, double minOccupancy, DenseResult& result)
{
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      Cell& cell = result.at(ix, iy);
      cell.aerial = cell.free ? 0 : -1;
      if (cell.free) continue;
      int bestOverlap = 0, bestHeight = 1;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
        {
          if (!result.inside(ix + dx, iy + dy) || !result.at(ix + dx, iy + dy).free) continue;
          const Cell& neighbour = result.at(ix + dx, iy + dy);
          const int height = neighbour.ceilingKey - neighbour.floorKey;
          const int overlap = overlapWith(map, ix, iy, neighbour);
          if (static_cast<long>(overlap) * bestHeight > static_cast<long>(bestOverlap) * height)
            bestOverlap = overlap, bestHeight = height;
        }
      if (bestOverlap > 0 && bestOverlap >= minOccupancy * bestHeight - 1e-9 * bestHeight)
        cell.aerial = static_cast<double>(bestOverlap) / bestHeight;
    }
}

void markGround(double resolution, double maxStep, DenseResult& result)
{
  for (int iy = 0; iy < result.ny; ++iy)
    for (int ix = 0; ix < result.nx; ++ix)
    {
      Cell& cell = result.at(ix, iy);
      cell.ground = cell.aerial;
      if (!cell.free) continue;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
        {
          if (!result.inside(ix + dx, iy + dy) || !result.at(ix + dx, iy + dy).free) continue;
          const int step = std::abs(result.at(ix + dx, iy + dy).floorKey - cell.floorKey);
          // a whole number of voxels written in metres is rarely exact in double
          if (maxStep > 0 && step > maxStep / resolution + 1e-6) cell.isStep = true;
        }
      if ((cell.hasSlope && cell.slopeTooHigh) || cell.isStep) cell.ground = 1;
    }
}

double maxStepOf(const freespace::ConversionParams& params, double resolution)
{
  return params.maxStep ? *params.maxStep : std::max(0.2, resolution);
}

DenseMap unknownAsFree(DenseMap map)
{
  int top = -1;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
      for (int iz = 0; iz < map.nz; ++iz)
        if (map.at(ix, iy, iz) != Voxel::Unknown) top = std::max(top, iz);
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      bool aboveOccupied = false;
      for (int iz = 0; iz <= top; ++iz)
      {
        Voxel& voxel = map.at(ix, iy, iz);
        if (voxel == Voxel::Occupied) aboveOccupied = true;
        if (voxel == Voxel::Unknown && aboveOccupied) voxel = Voxel::Free;
      }
    }
  return map;
}

DenseResult convert(const DenseMap& read, const freespace::ConversionParams& params)
{
  const DenseMap map = params.reading.unknown == voxel::Unknown::Free ? unknownAsFree(read) : read;
  DenseResult result;
  result.nx = map.nx, result.ny = map.ny;
  result.cells.resize(static_cast<std::size_t>(map.nx) * static_cast<std::size_t>(map.ny));
  findHeights(map, params.minClearance, result);
  markAerial(map, params.minOccupancy, result);
  markEvidence(map, result);
  if (params.floorFrom == freespace::FloorFrom::Seen)
  {
    judgeBySupport(map.resolution, params, result);
    return result;
  }
  supportIsFloor(map.resolution, result);
  fitSlopes(params.slopeWindow, params.maxSlope, result);
  markGround(map.resolution, maxStepOf(params, map.resolution), result);
  return result;
}

DenseStatistics statistics(const DenseResult& result)
{
  DenseStatistics count;
  for (const Cell& cell : result.cells)
  {
    if (cell.aerial == 0)
      ++count.free;
    else if (cell.aerial > 0)
      ++count.occupied;
    else
      ++count.unknown;
    if (cell.aerial == 0 && cell.ground > 0) ++count.steep;
    if (cell.aerial == 0 && cell.ground < 0) ++count.frontier;
    if (cell.evidence == Evidence::Inferred) ++count.inferred;
    if (cell.free && !cell.hasSlope) ++count.slopeUnknown;
  }
  return count;
}

std::vector<int> projectFixed(const DenseMap& map, double zMin, double zMax)
{
  std::vector<int> cells;
  for (int iy = 0; iy < map.ny; ++iy)
    for (int ix = 0; ix < map.nx; ++ix)
    {
      bool anyFree = false, anyOccupied = false;
      for (int iz = 0; iz < map.nz; ++iz)
      {
        const double bottom = map.z0 + iz, top = bottom + 1;  // in voxels
        const bool overlaps =
            top > zMin / map.resolution + 1e-6 && bottom < zMax / map.resolution - 1e-6;
        if (!overlaps) continue;
        anyFree = anyFree || map.at(ix, iy, iz) == Voxel::Free;
        anyOccupied = anyOccupied || map.at(ix, iy, iz) == Voxel::Occupied;
      }
      cells.push_back(anyOccupied ? 1 : anyFree ? 0 : -1);
    }
  return cells;
}

}  // namespace mrpt_mapconv::oracle
