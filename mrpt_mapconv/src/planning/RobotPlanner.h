#pragma once

#include <mrpt_mapconv/freespace/RobotLayers.h>
#include <mrpt_mapconv/planning/RobotPath.h>

#include <string>
#include <vector>

#include "GridSearch.h"
#include "WayFaults.h"

namespace mrpt_mapconv::planning
{
/** planRobotPath(): plans and lifts in turns; what does not fit narrows the next search. */
class RobotPlanner
{
 public:
  /** \param layers, conversion, query, voxels as for planRobotPath(); they must outlive this */
  RobotPlanner(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
               const RobotPathQuery& query, const voxel::VoxelSource* voxels);

  RobotPath plan();

 private:
  bool isGround() const { return m_query.lift.robot == freespace::Robot::Ground; }
  path::LiftedPath lift(const std::vector<mrpt::math::TPoint2D>& points) const;
  path::LiftedPath liftCentre(Cell cell) const;
  Cell cellOf(double x, double y) const;
  Cell cellOf(const path::LiftedPoint& point) const;

  // what is said where there is no path
  std::string problemOfEnds(const path::LiftedPath& path) const;
  std::string whyNoWay(const std::string& problem) const;
  std::string stepInTheWay() const;
  std::string blockedWay() const;

  // what a way that is bad teaches the search
  bool leadAround(const path::LiftedPath& path, const std::vector<WayFault>& faults);
  bool keepToCentres(const path::LiftedPath& path, const WayFault& fault);
  bool exclude(const path::LiftedPath& path, const WayFault& fault);
  void learnMisfits(const path::LiftedPath& path);
  void lookAt(Cell cell, std::vector<Cell>& misfits);
  void excludeAround(std::vector<Cell>& misfits);

  const freespace::Layers& m_layers;
  const freespace::ConversionParams& m_conversion;
  const RobotPathQuery& m_query;
  const voxel::VoxelSource* m_voxels;
  GridSearch m_search;
  WayFaults m_faults;
  CellMask m_looked;          //!< cells whose centre was tried
  std::string m_firstMisfit;  //!< place and reason
  bool m_ledAround = false;   //!< a fault between two points, which may depend on the way
};

}  // namespace mrpt_mapconv::planning
