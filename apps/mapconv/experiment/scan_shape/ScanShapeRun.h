#pragma once

#include <mrpt_mapconv/eval/ScanShapeRegions.h>
#include <mrpt_mapconv/eval/ScanShapeScores.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <vector>

#include "experiment/scan_shape/ScanShapeSettings.h"
#include "output/Progress.h"

namespace mapconv
{
/** Increments that the full method was tried with. */
struct UpdateTrial
{
  mrpt_mapconv::scan::UpdateParams params;
  mrpt_mapconv::eval::MapScore score;
  mrpt_mapconv::eval::PeopleTraces people;
};

/** Another value of a parameter that the full method was tried with. */
struct ProfileTrial
{
  std::string parameter, value;
  mrpt_mapconv::eval::MapScore score;
};

/** A drive through the office that all methods mapped, and how good their maps are. */
struct ScanShapeRun
{
  std::uint32_t seed = 0;
  std::size_t scans3D = 0, scans2D = 0, points = 0;
  std::size_t refused2D = 0;  //!< by MRPT's grid
  double shareWithWall = 0;   //!< of the azimuths, the mean of the scans
  PerScanMethod<mrpt_mapconv::grid::Layer<float>> maps;
  PerScanMethod<mrpt_mapconv::eval::MapScore> scores;
  std::vector<mrpt_mapconv::eval::RegionScore> uncutRegions,
      cutRegions;  //!< of the settings' regions
  /** Of each of the settings' margins: the same regions as seen from outside. */
  std::vector<std::vector<mrpt_mapconv::eval::OutsideScore>> outside;
  mrpt_mapconv::eval::FalseObstacles uncutFalse, cutFalse;
  mrpt_mapconv::eval::PeopleTraces people;  //!< of the full method
  std::vector<UpdateTrial> updateTrials;    //!< empty if it takes no part in the sweep
  std::vector<ProfileTrial> profileTrials;
};

/** Simulates one drive; each scan is put into all maps, at the same estimated pose.
 * \param withSweep also try what the settings' sweep names
 * \exception std::runtime_error in one line naming the world's file if an estimated pose lies
 * outside the world */
ScanShapeRun driveThrough(const mrpt_mapconv::sim::Scenario& scenario,
                          const mrpt_mapconv::eval::ScanShapeTruth& truth,
                          const ScanShapeSettings& settings, std::uint32_t seed, bool withSweep,
                          Progress& progress);

}  // namespace mapconv
