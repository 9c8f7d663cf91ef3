#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "DenseMap.h"

namespace mrpt_mapconv::oracle
{
/** What is known of the ground, numbered as in the layer. */
enum class Evidence
{
  None,
  Seen,
  Inferred,
  Open,
  Wall
};

/** All that the conversion says about one cell, before rounding to float where that matters. */
struct Cell
{
  bool free = false;             //!< a run is kept
  int floorKey = 0;              //!< z key of the lowest kept run's first voxel
  int ceilingKey = 0;            //!< z key one past the highest kept run's last voxel
  float floor = 0, ceiling = 0;  //!< [m]; NaN where not free

  Evidence evidence = Evidence::None;
  bool hasSupport = false;
  std::int64_t support64 = 0;  //!< in 64ths of voxels
  float support = 0;           //!< [m]; NaN without support

  bool hasSlope = false;      //!< at least three cells with a floor, not all on one line
  long double slope = 0;      //!< [m/m]
  bool slopeTooHigh = false;  //!< slope > maxSlope
  bool slopeTie = false;      //!< so close to maxSlope that rounding in double may decide otherwise
  std::optional<int> occupiedTopUnderFloor;     //!< z key of the top face of the highest one
  std::optional<int> occupiedBottomAboveFloor;  //!< z key of the bottom face of the lowest one
  bool isStep = false;  //!< maxStep is on and the floor differs by more from a neighbour's
  bool isDrop = false;  //!< likewise, and it goes down beside it

  double aerial = -1, ground = -1;  //!< 0 free, (0, 1] occupied, -1 unknown
};

/** One Cell per column of the map's bounding box, row by row from the lowest y. */
struct DenseResult
{
  int nx = 0, ny = 0;
  std::vector<Cell> cells;

  bool inside(int ix, int iy) const { return ix >= 0 && iy >= 0 && ix < nx && iy < ny; }
  Cell& at(int ix, int iy) { return cells[index(ix, iy)]; }
  const Cell& at(int ix, int iy) const { return cells[index(ix, iy)]; }

 private:
  std::size_t index(int ix, int iy) const
  {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) +
           static_cast<std::size_t>(ix);
  }
};

struct DenseStatistics
{
  std::size_t free = 0, occupied = 0, unknown = 0, steep = 0, slopeUnknown = 0;
  std::size_t frontier = 0, inferred = 0;
};

/** maxStep in metres, what auto stands for included; 0 if steps are not looked for. */
double maxStepOf(const freespace::ConversionParams& params, double resolution);

/** The map as it is read with unknown = free: in each column that has an occupied voxel, unknown
 * voxels above the lowest of them, up to the map's highest known voxel, are free. */
DenseMap unknownAsFree(DenseMap map);

/** The conversion of the section 2, by plain loops over the dense array. */
DenseResult convert(const DenseMap& map, const freespace::ConversionParams& params);

// Its steps, in order; each fills its part of the cells.
void findHeights(const DenseMap& map, double minClearance, DenseResult& result);
void fitSlope(int slopeWindow, double maxSlope, int ix, int iy, DenseResult& result);  // one cell
void fitSlopes(int slopeWindow, double maxSlope, DenseResult& result);
void markAerial(const DenseMap& map, double minOccupancy, DenseResult& result);
void markGround(double resolution, double maxStep, DenseResult& result);

DenseStatistics statistics(const DenseResult& result);

/** The fixed projection: 1, 0 or -1 per cell. zMin and zMax [m] may be infinite; an end within a
 * millionth of a voxel of a face lies on that face. */
std::vector<int> projectFixed(const DenseMap& map, double zMin, double zMax);

}  // namespace mrpt_mapconv::oracle
