#pragma once

#include <mrpt/math/CMatrixFixed.h>
#include <mrpt_mapconv/params/Fields.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mrpt_mapconv::terrain
{
/** How the points of a cell become its height. */
enum class HeightRule
{
  Fused,   //!< Σ(z/σ²) / Σ(1/σ²)
  Maximum  //!< the highest point, the rule of Zhou et al. 2023; of n noisy points it is biased
           //!< upward
};
const std::vector<std::string>& namesOf(HeightRule);  //!< "fused", "maximum"

/** Most hypotheses that are tried for a cell. */
constexpr std::int32_t kMostHypotheses = 64;

/** How heights become planes, and planes what a robot can walk on. Cells are 2D voxels of a
 * TerrainMap. */
struct TerrainParams
{
  HeightRule heightRule = HeightRule::Fused;
  double planeTolerance = 0.02;  //!< d [m]
  double planeWindow = 0.2;      //!< half its side [m]
  std::int32_t hypotheses = 12;  //!< K
  std::int32_t blockCells = 8;   //!< B
  std::int32_t minPlaneCells = 12;
  double minPlaneWidth = 0.15;  //!< [m]
  double maxPlaneSlope = 1.0;   //!< [m/m]
  double maxSlope = 0.5;        //!< [m/m]
  double maxStep = 0.2;         //!< [m]
  double localWindow = 0;       //!< [m]; 0: none

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    using params::flag;
    v("heightRule", p.heightRule, "",
      "height of a cell: fused (weighted by variance) or maximum (its highest point)",
      flag("RULE"));
    v("planeTolerance", p.planeTolerance, "m",
      "a cell of a plane is at most this far above or below it", flag("M"));
    v("planeWindow", p.planeWindow, "m",
      "half the side of the window around a cell in which its plane is looked for", flag("M"));
    v("hypotheses", p.hypotheses, "", "planes that are tried for a cell", flag("N"));
    v("blockCells", p.blockCells, "cells",
      "after so many cells half of the hypotheses are given up", flag("N"));
    v("minPlaneCells", p.minPlaneCells, "cells", "a plane has at least so many", flag("N"));
    v("minPlaneWidth", p.minPlaneWidth, "m",
      "a plane fills most of a square of this side; what lies between two planes, at an edge, does "
      "not",
      flag("M"));
    v("maxPlaneSlope", p.maxPlaneSlope, "m/m", "steepest plane; what is steeper stays single cells",
      flag("SLOPE"));
    v("maxSlope", p.maxSlope, "m/m", "steepest ground that counts as traversable", flag("SLOPE"));
    v("maxStep", p.maxStep, "m",
      "largest difference to the height of a neighbouring cell that counts as traversable",
      flag("M"));
    v("localWindow", p.localWindow, "m",
      "side of the square around the robot that is kept; 0: everything is", flag("M"));
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
};

/** What points are uncertain by, as standard deviations.
 *
 * The variance of a point's height is σ_h² = J_S Σ_S J_Sᵀ + J_P Σ_P J_Pᵀ (Fankhauser et al. 2018),
 * with Σ_S of a range along the beam and two angles across it, and Σ_P of the robot's height, roll
 * and pitch. */
struct PointSigmas
{
  double range = 0.02;    //!< along the beam [m]
  double beam = 0.001;    //!< of its direction [rad]
  double height = 0.005;  //!< of the robot's z [m]
  double roll = 0.1;      //!< [degrees]
  double pitch = 0.1;     //!< [degrees]

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    using params::flag;
    v("rangeSigma", p.range, "m", "standard deviation of a point along its beam", flag("M"));
    v("beamSigma", p.beam, "rad", "standard deviation of a beam's direction", flag("RAD"));
    v("heightSigma", p.height, "m", "standard deviation of the robot's z, where a log has none",
      flag("M"));
    v("rollSigma", p.roll, "degrees", "likewise of its roll", flag("DEG"));
    v("pitchSigma", p.pitch, "degrees", "likewise of its pitch", flag("DEG"));
  }
  /** Of z [m], roll and pitch [rad], in this order; they are independent. */
  mrpt::math::CMatrixDouble33 poseCovariance() const;
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
};

}  // namespace mrpt_mapconv::terrain
