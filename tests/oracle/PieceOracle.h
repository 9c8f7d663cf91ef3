#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/freespace/Robot.h>

#include "DenseMap.h"

namespace mrpt_mapconv::oracle
{
/** What a robot cannot do between two points of a path, by definition: every voxel of the map is
 * cut with the straight piece. */
class PieceOracle
{
 public:
  PieceOracle(const DenseMap& map, const freespace::ConversionParams& conversion,
              freespace::Robot robot, double heightOffset);

  /** Whether the piece (of a ground robot: what the robot sweeps) goes through a voxel that is
   * occupied, by more than a touch. */
  bool crossesOccupied(const mrpt::math::TPoint3D& from, const mrpt::math::TPoint3D& to) const;

  /** Whether the piece goes through a cell, by more than a touch, that has a floor but no support.
   */
  bool crossesUnseenGround(const freespace::Layers& layers, const mrpt::math::TPoint3D& from,
                           const mrpt::math::TPoint3D& to) const;

  /** Whether heights differ by more than max(maxStep, one voxel, maxSlope · distance). */
  bool stepTooHigh(double fromZ, double toZ, double distance) const;

 private:
  const DenseMap& m_map;
  const freespace::ConversionParams& m_conversion;
  double m_bodyLow, m_bodyHigh;  //!< over the path [m]
};

}  // namespace mrpt_mapconv::oracle
