#pragma once

#include <mrpt_mapconv/params/Fields.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::aerial
{
/** What finds the ground below a cloud. */
enum class GroundFilter
{
  Csf,  //!< a cloth pressed against the cloud from below (Zhang et al. 2016): follows slopes and
        //!< hollows, also where few beams reach the ground; cuts ridges steeper than about 40
        //!< degrees
  Smrf  //!< openings of the lowest surface (Pingel et al. 2013): fewer errors among buildings;
        //!< takes crowns for ground where few beams come through, and loses ground at a map's upper
        //!< end
};
const std::vector<std::string>& namesOf(GroundFilter);  //!< "csf", "smrf"

/** Which point of a cloth cell stops the cloth. */
enum class CollisionRule
{
  Lowest,
  Nearest  //!< to the cell's centre, as the published code has it; among leaves that is a leaf
};
const std::vector<std::string>& namesOf(CollisionRule);  //!< "lowest", "nearest"

/** How the ground below a cloud is found, and the map of it. */
struct GroundParams
{
  GroundFilter groundFilter = GroundFilter::Csf;
  double cellSize = 0.25;  //!< [m]

  double lowPointRadius = 8;     //!< [m]; 0: no point is too low
  double lowPointDepth = 0.5;    //!< [m]
  double lowPointShare = 0.002;  //!< of the points within the radius

  double clothResolution = 0.5;  //!< [m]
  std::int32_t rigidness = 3;
  double heightThreshold = 0.2;  //!< [m]
  double heightScale = 0.25;     //!< [m]
  double timeStep = 0.65;
  double gravity = 0.2;
  double damping = 0.01;
  std::int32_t maxIterations = 500;
  double restMove = 0.005;  //!< [m]
  bool slopeSmoothing = true;
  double smoothingSlope = 0.15;  //!< [m/m]
  double smoothingReach = 2;     //!< [m]
  CollisionRule collision = CollisionRule::Lowest;

  double smrfCell = 1;         //!< [m]
  double smrfSlope = 0.15;     //!< [m/m]
  double smrfWindow = 18;      //!< [m]
  double smrfThreshold = 0.5;  //!< [m]
  double smrfScale = 1.25;     //!< [m]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    using params::flag;
    v("groundFilter", p.groundFilter, "",
      "what finds the ground: csf (a cloth) or smrf (morphology; for towns, and fast)",
      flag("FILTER"));
    v("cellSize", p.cellSize, "m", "cells of the maps that are made", flag("M"));
    v("lowPointRadius", p.lowPointRadius, "m",
      "points that lie alone below all others within this radius, or four distances of points, are "
      "left out; 0: none",
      flag("M"));
    v("lowPointDepth", p.lowPointDepth, "m", "others up to so much higher count as company",
      flag("M"));
    v("lowPointShare", p.lowPointShare, "", "share of the points around that company must exceed",
      flag("SHARE"));
    v("clothResolution", p.clothResolution, "m", "between the cloth's particles", flag("M"));
    v("rigidness", p.rigidness, "", "passes of the cloth's inner constraints: 1 soft, 3 stiff",
      flag("N"));
    v("heightThreshold", p.heightThreshold, "m",
      "points at most this high above the cloth are ground", flag("M"));
    v("heightScale", p.heightScale, "m",
      "is added to heightThreshold times the cloth's slope; 0: as published", flag("M"));
    v("timeStep", p.timeStep, "", "of the cloth's simulation", flag("T"));
    v("gravity", p.gravity, "", "that presses the cloth against the cloud", flag("G"));
    v("damping", p.damping, "", "share of its velocity that a particle loses in a step",
      flag("SHARE"));
    v("maxIterations", p.maxIterations, "", "steps after which the cloth is taken as it is",
      flag("N"));
    v("restMove", p.restMove, "m", "the cloth rests if no particle moves farther in a step",
      flag("M"));
    v("slopeSmoothing", p.slopeSmoothing, "",
      "whether the cloth is drawn on to ground that it is too stiff to reach", flag("BOOL"));
    v("smoothingSlope", p.smoothingSlope, "m/m",
      "slope, as seen from the cloth, up to which it is drawn on", flag("SLOPE"));
    v("smoothingReach", p.smoothingReach, "m",
      "distance over which it is drawn on, at least to the next particle", flag("M"));
    v("collision", p.collision, "",
      "point of a cloth cell that stops the cloth: lowest or nearest (as published)", flag("RULE"));
    v("smrfCell", p.smrfCell, "m", "cells of smrf's surfaces", flag("M"));
    v("smrfSlope", p.smrfSlope, "m/m", "an object rises more steeply than this", flag("SLOPE"));
    v("smrfWindow", p.smrfWindow, "m", "radius of the largest object that is looked for",
      flag("M"));
    v("smrfThreshold", p.smrfThreshold, "m", "points at most this far from flat ground are ground",
      flag("M"));
    v("smrfScale", p.smrfScale, "m", "is added to smrfThreshold times the ground's slope",
      flag("M"));
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;

  /** How far gravity moves a resting particle in a step, as the published code has it [m]. */
  double firstMove() const;
};

}  // namespace mrpt_mapconv::aerial
