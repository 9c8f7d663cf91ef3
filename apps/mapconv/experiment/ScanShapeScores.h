#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/MapScore.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <vector>

#include "ScanShapeHistory.h"
#include "ScanShapeSettings.h"

namespace mapconv
{
/** The world that maps are judged by. */
struct ScanShapeTruth
{
  mrpt_mapconv::grid::Layer<float> obstacles;        //!< what a robot can hit
  mrpt_mapconv::sim::CellMask should;                //!< cells that should be labelled
  mrpt_mapconv::sim::CellMask shouldBeOccupied;      //!< the occupied ones of them
  std::vector<mrpt_mapconv::sim::CellMask> regions;  //!< of the settings' regions
};

/** Truth on the settings' cells: all that stands in the object slice, as seen from the start. */
ScanShapeTruth truthOf(const mrpt_mapconv::sim::Scenario& scenario,
                       const ScanShapeSettings& settings);

/** True for a rectangle within a world's bounds that has a truly free cell. */
bool isPlaceIn(const mrpt_mapconv::sim::Footprint& rectangle, const mrpt_mapconv::sim::World& world,
               const ScanShapeTruth& truth);

/** How good a map is. */
struct MapScore
{
  mrpt_mapconv::sim::LabelScore labels;
  mrpt_mapconv::sim::LabelScore occupied;  //!< likewise, of nothing but that label
  std::size_t occupiedLabelledFree = 0;    //!< of all cells
};

MapScore scoreOf(const mrpt_mapconv::grid::Layer<float>& map, const ScanShapeTruth& truth);

/** What a map says of a region. */
struct RegionScore
{
  double trueFreeArea = 0;               //!< [m²]
  double shareFound = 0;                 //!< of the truly free cells, those labelled free
  std::size_t occupiedLabelledFree = 0;  //!< cells
};

RegionScore scoreRegion(const mrpt_mapconv::grid::Layer<float>& map, const ScanShapeTruth& truth,
                        std::size_t region);

/** Cells that a map has as occupied and that are not so in truth. */
struct FalseObstacles
{
  std::size_t cells = 0;
  std::size_t onlyGhosts = 0;  //!< of these, those in which no return really was
};

/** \param map on the history's frame */
FalseObstacles falseObstacles(const mrpt_mapconv::grid::Layer<float>& map,
                              const ScanShapeTruth& truth,
                              const mrpt_mapconv::grid::Layer<CellHistory>& history);

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
PeopleTraces peopleTraces(const mrpt_mapconv::grid::Layer<float>& map, const ScanShapeTruth& truth,
                          const mrpt_mapconv::grid::Layer<CellHistory>& history);

}  // namespace mapconv
