#include "WayFaults.h"

#include <cstdio>

namespace mrpt_mapconv::planning
{
namespace
{
WayFault::Kind kindOf(path::PieceProblem::Kind kind)
{
  using From = path::PieceProblem::Kind;
  return kind == From::FloorStep    ? WayFault::Kind::FloorStep
         : kind == From::HeightStep ? WayFault::Kind::HeightStep
                                    : WayFault::Kind::InTheWay;
}

WayFault climbFault(const path::LiftedPath& path, std::size_t index)
{
  const auto &from = path.points[index - 1].position, &to = path.points[index].position;
  char text[160];
  std::snprintf(text, sizeof(text),
                "at (%.2f, %.2f): something is in the way between the heights of %.2f m and "
                "%.2f m",
                to.x, to.y, from.z, to.z);
  return {WayFault::Kind::InTheWay, index, text};
}

}  // namespace

WayFaults::WayFaults(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
                     const path::LiftParams& params, const voxel::VoxelSource* voxels)
    : m_aerial(params.robot == freespace::Robot::Aerial),
      m_pieces(layers, conversion, params, voxels),
      m_climbs(layers, conversion, params, voxels)
{
}

std::vector<WayFault> WayFaults::of(const path::LiftedPath& path) const
{
  const std::size_t climb = m_aerial ? m_climbs.firstBlocked(path) : 0;
  std::vector<WayFault> faults;
  if (climb > 0) faults.push_back(climbFault(path, climb));
  for (const path::PieceProblem& problem : m_pieces.problems(path))
  {
    if (m_aerial && climb > 0 && problem.index >= climb) break;
    if (m_aerial) return {{kindOf(problem.kind), problem.index, problem.inWords()}};
    faults.push_back({kindOf(problem.kind), problem.index, problem.inWords()});
  }
  return faults;
}

}  // namespace mrpt_mapconv::planning
