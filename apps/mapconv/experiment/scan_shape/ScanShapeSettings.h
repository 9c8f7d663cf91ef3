#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/eval/MapRegion.h>
#include <mrpt_mapconv/scan/LogOddsUpdate.h>
#include <mrpt_mapconv/scan/ProfileParams.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "experiment/Experiments.h"

namespace mapconv
{
/** The ways to map the scans of a drive that are compared. */
enum class ScanMethod
{
  Scanner2D,     //!< the 2D scanner's scans in MRPT's own grid
  ClosestPoint,  //!< the nearest object of each azimuth of the 3D scans
  Counts,        //!< whole shapes, uncut, and what was once seen occupied stays so
  WholeShape,    //!< whole shapes, uncut
  WholeShapeCut  //!< whole shapes, cut at structural elements
};
constexpr std::size_t kScanMethods = 5;

/** A value for each method. */
template <class Value>
using PerScanMethod = std::array<Value, kScanMethods>;

/** A row of the paper's table I; NaN: it has none. */
struct PaperScore
{
  double precision = NAN, recall = NAN, fScore = NAN;
};

/** What the full method is tried with besides its settings. */
struct ScanShapeSweep
{
  std::vector<std::uint32_t> seeds;        //!< one run for each, none of which is reported
  std::vector<double> pHit, pMiss;         //!< all pairs of them
  std::vector<double> structureTolerance;  //!< [m]
  std::vector<std::int32_t> sectors;
};

struct ScanShapeSettings
{
  std::string world;                          //!< the simulator's world file
  std::vector<std::uint32_t> seeds;           //!< one reported run for each
  double resolution = 0.05;                   //!< of all maps [m]
  int maxScans = 0;                           //!< 3D ones of a run; 0: all
  mrpt_mapconv::scan::ProfileParams profile;  //!< of the full method
  mrpt_mapconv::scan::UpdateParams update;    //!< of all that are updated with 3D scans
  mrpt::maps::COccupancyGridMap2D::TInsertionOptions scanner;  //!< of the 2D scans
  PerScanMethod<PaperScore> paper;
  ScanShapeSweep sweep;
  std::vector<mrpt_mapconv::eval::MapRegion> regions;
  /** How far beyond the walls of a region's room scans from outside begin [m]. */
  std::vector<double> margins = {0};
};

/** \exception std::exception in one line naming section, key and value */
ScanShapeSettings readScanShapeSettings(const ExperimentJob& job);

/** Complains about one of the rectangles of a region.
 * \param key of the rectangle \param right what it must be
 * \exception std::runtime_error in one line naming section, key and value */
[[noreturn]] void failRegion(const ExperimentJob& job, const mrpt_mapconv::eval::MapRegion& region,
                             const std::string& key, const std::string& right);

}  // namespace mapconv
