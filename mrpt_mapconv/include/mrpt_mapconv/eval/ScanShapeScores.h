#pragma once

#include <mrpt_mapconv/eval/DriveHistory.h>
#include <mrpt_mapconv/eval/LabelScore.h>
#include <mrpt_mapconv/eval/MapRegion.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <vector>

namespace mrpt_mapconv::eval
{
/** The world that maps are judged by. */
struct ScanShapeTruth
{
  grid::Layer<float> obstacles;   //!< what a robot can hit
  CellMask should;                //!< cells that should be labelled
  CellMask shouldBeOccupied;      //!< the occupied ones of them
  std::vector<CellMask> regions;  //!< of the regions
};

/** Truth on cells of a size: all that stands in the profile's object slice, as seen from the start,
 * and the cells of each region's area. \param resolution [m] */
ScanShapeTruth truthOf(const sim::Scenario& scenario, double resolution,
                       const scan::ProfileParams& profile, const std::vector<MapRegion>& regions);

/** True for a rectangle within a world's bounds that has a truly free cell. */
bool isPlaceIn(const sim::Footprint& rectangle, const sim::World& world,
               const ScanShapeTruth& truth);

/** How good a map is. */
struct MapScore
{
  LabelScore labels;
  LabelScore occupied;                   //!< likewise, of nothing but that label
  std::size_t occupiedLabelledFree = 0;  //!< of all cells
};

MapScore scoreOf(const grid::Layer<float>& map, const ScanShapeTruth& truth);

/** What a map says of a region. */
struct RegionScore
{
  double trueFreeArea = 0;               //!< [m²]
  double shareFound = 0;                 //!< of the truly free cells, those labelled free
  std::size_t occupiedLabelledFree = 0;  //!< cells
};

RegionScore scoreRegion(const grid::Layer<float>& map, const ScanShapeTruth& truth,
                        std::size_t region);

/** Cells that a map has as occupied and that are not so in truth. */
struct FalseObstacles
{
  std::size_t cells = 0;
  std::size_t onlyGhosts = 0;  //!< of these, those in which no return really was
};

/** \param map on the history's frame */
FalseObstacles falseObstacles(const grid::Layer<float>& map, const ScanShapeTruth& truth,
                              const grid::Layer<CellHistory>& history);

/** After so many scans that say free no cell is to be occupied because of a person. */
constexpr int kScansToFade = 10;

/** What walking people have left on a map, as counts of cells. Each one is a part of the one
 * before, but the last. */
struct PeopleTraces
{
  std::size_t seen = 0;  //!< people were seen in them
  std::size_t freeInTruth = 0;
  std::size_t occupied = 0;     //!< at the end of the drive
  std::size_t hitByPerson = 0;  //!< no scan since has said that they are occupied
  std::size_t notFaded = 0;     //!< and at least ten scans since have said that they are free
  /** Occupied at the end, free in truth and at least ten times free since a person was there, but
   * something else has been seen there, too. */
  std::size_t hitByOthers = 0;

  PeopleTraces& operator+=(const PeopleTraces& o);
};

/** \param map on the history's frame */
PeopleTraces peopleTraces(const grid::Layer<float>& map, const ScanShapeTruth& truth,
                          const grid::Layer<CellHistory>& history);

}  // namespace mrpt_mapconv::eval
