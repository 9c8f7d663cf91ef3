#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>

#include <string>
#include <vector>

#include "experiment/Experiments.h"

namespace mapconv
{
/** What is printed beside our figures for a world, from the paper's tables. */
struct PaperFigures
{
  double fullRatio = 0, partialRatio = 0;  //!< of the time to that of the fixed projection
  std::vector<double> sizes;               //!< of 2D map, + floor, + ceiling, in % of the octree
};

/** A world of the experiment: one section of the ini file. */
struct FreespaceWorld
{
  std::string name;                           //!< the section
  std::string file;                           //!< the simulator's world file
  double resolution = 0.1;                    //!< of voxels and cells [m]
  double sliceBelow = 0.3, sliceAbove = 0.7;  //!< the fixed projection's slice around the start [m]
  double robotRadius = 0.3;                   //!< of either robot [m]
  double safetyRadius = 0.4;                  //!< that aerial paths are planned and lifted with [m]
  std::vector<std::string> lowWalls, objects;  //!< how the names of such bodies begin
  PaperFigures paper;
};

struct FreespaceSettings
{
  std::vector<FreespaceWorld> worlds;
  mrpt_mapconv::freespace::ConversionParams conversion;        //!< Table I of the paper
  mrpt_mapconv::freespace::ConversionParams strictConversion;  //!< for robots that climb no steps
  int repetitions = 9;                                         //!< of a full conversion
  int pairs = 100;   //!< start–goal pairs per world and robot
  int maxScans = 0;  //!< of a run; 0: all
};

/** \exception std::exception in one line naming file, section, key and value */
FreespaceSettings readFreespaceSettings(const ExperimentJob& job);

}  // namespace mapconv
