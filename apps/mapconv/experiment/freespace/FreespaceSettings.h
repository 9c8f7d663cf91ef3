#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/freespace/ConversionParams.h>

#include <optional>
#include <string>
#include <vector>

#include "experiment/Experiments.h"

namespace mapconv
{
/** What is printed beside our figures for a world of the paper, from its tables. */
struct PaperFigures
{
  double fullRatio = 0, partialRatio = 0;  //!< of the time to that of the fixed projection
  std::vector<double> sizes;               //!< of 2D map, + floor, + ceiling, in % of the octree
};

/** What is asked of a world with places to fall down from. */
struct DropsWorld
{
  std::string ramp;                  //!< a way down that is none of these: how its name begins
  mrpt::math::TPoint2D from, to;     //!< where a ground robot is to go along it [m]
  std::optional<double> edgesFound;  //!< target: least share of the edges' cells [%]
  std::optional<int> floating;       //!< target: most inferred cells above the true floor
};

/** A world of the experiment: one section of the ini file. */
struct FreespaceWorld
{
  std::string name;                           //!< the section
  std::string file;                           //!< the simulator's world file
  std::vector<std::string> sensors;           //!< that the robot has; empty: all but the spare ones
  double resolution = 0.1;                    //!< of voxels and cells [m]
  double sliceBelow = 0.3, sliceAbove = 0.7;  //!< the fixed projection's slice around the start [m]
  double robotRadius = 0.3;                   //!< of either robot [m]
  double safetyRadius = 0.4;                  //!< that aerial paths are planned and lifted with [m]
  std::vector<std::string> lowWalls, objects;        //!< how the names of such bodies begin
  mrpt_mapconv::freespace::ConversionParams strict;  //!< for ground robots that climb no steps
  bool isJudged = true;               //!< whether targets for ground that was seen hold in it
  std::optional<DropsWorld> drops;    //!< of a world whose drops are looked at
  std::optional<PaperFigures> paper;  //!< of a world for the paper's tables
};

struct FreespaceSettings
{
  std::vector<FreespaceWorld> worlds;
  mrpt_mapconv::freespace::ConversionParams conversion;  //!< Table I of the paper
  int repetitions = 9;                                   //!< of a full conversion
  int pairs = 100;                                       //!< start–goal pairs per world and robot
  int maxScans = 0;                                      //!< of a run; 0: all
};

/** \exception std::exception in one line naming file, section, key and value */
FreespaceSettings readFreespaceSettings(const ExperimentJob& job);

}  // namespace mapconv
