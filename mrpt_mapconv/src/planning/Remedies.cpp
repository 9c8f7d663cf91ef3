#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/planning/Remedies.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::planning
{
namespace
{
using freespace::Robot;

/** Of the whole numbers from `near` to `far` the one nearest to `near` for which works() holds, if
 * it holds from some number on; nothing if it does not hold for `far`. */
template <class Works>
std::optional<int> nearestWorking(int near, int far, const Works& works)
{
  if (!works(far)) return std::nullopt;
  int failing = near < far ? near - 1 : near + 1, working = far;
  while (std::abs(working - failing) > 1)
  {
    const int middle = failing + (working - failing) / 2;
    (works(middle) ? working : failing) = middle;
  }
  return working;
}

/** Tries one change after the other. */
class Trials
{
 public:
  Trials(const freespace::Layers& layers, const freespace::ConversionParams& conversion,
         const RobotPathQuery& query, const voxel::VoxelSource* voxels)
      : m_layers(layers), m_conversion(conversion), m_query(query), m_voxels(voxels)
  {
    constexpr int kAttempts = 10;
    m_query.mostAttempts = std::min(query.mostAttempts, kAttempts);
  }

  std::optional<double> robotRadius() const
  {
    constexpr double kStep = 0.01;
    const bool aerial = m_query.lift.robot == Robot::Aerial;
    const int first = static_cast<int>(std::ceil(m_query.robotRadius / kStep - 1e-6)) - 1;
    const int last = aerial ? 1 : 0;  // a sphere needs a radius
    if (first < last) return std::nullopt;
    const auto found = nearestWorking(first, last,
                                      [&](int steps)
                                      {
                                        RobotPathQuery query = m_query;
                                        query.robotRadius = steps * kStep;
                                        if (m_query.lift.safetyRadius == m_query.robotRadius)
                                          query.lift.safetyRadius = query.robotRadius;
                                        return finds(query);
                                      });
    return found ? std::optional(*found * kStep) : std::nullopt;
  }

  std::optional<double> heightOffset() const
  {
    if (m_query.lift.robot == Robot::Ground) return std::nullopt;
    const double cell = m_layers.frame().resolution;
    for (const int cells : {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25, 30, 40})
      for (const int sign : {-1, 1})
      {
        RobotPathQuery query = m_query;
        query.lift.heightOffset += sign * cells * cell;
        if (query.lift.heightOffset >= 0 && finds(query)) return query.lift.heightOffset;
      }
    return std::nullopt;
  }

  std::optional<double> maxStep() const
  {
    if (m_query.lift.robot == Robot::Aerial || !m_voxels) return std::nullopt;
    const double voxel = m_layers.frame().resolution;
    const int first = m_conversion.maxStepVoxels(voxel) + 1;
    const int last = static_cast<int>(std::min(m_conversion.minClearance / voxel, 1e6));
    if (first > last) return std::nullopt;
    const auto found =
        nearestWorking(first, last,
                       [&](int voxels)
                       {
                         freespace::ConversionParams params = m_conversion;
                         params.maxStep = voxels * voxel;
                         const auto layers = freespace::convert(*m_voxels, params);
                         return planRobotPath(layers, params, m_query, m_voxels).found();
                       });
    return found ? std::optional(*found * voxel) : std::nullopt;
  }

 private:
  bool finds(const RobotPathQuery& query) const
  {
    return planRobotPath(m_layers, m_conversion, query, m_voxels).found();
  }

  const freespace::Layers& m_layers;
  const freespace::ConversionParams& m_conversion;
  RobotPathQuery m_query;
  const voxel::VoxelSource* m_voxels;
};

bool contains(const grid::GridFrame& frame, const mrpt::math::TPoint2D& p)
{
  return p.x >= frame.xMin() && p.x < frame.xMax() && p.y >= frame.yMin() && p.y < frame.yMax();
}
}  // namespace

Remedies findRemedies(const freespace::Layers& layers,
                      const freespace::ConversionParams& conversion, const RobotPathQuery& query,
                      const voxel::VoxelSource* voxels)
{
  if (!contains(layers.frame(), query.start) || !contains(layers.frame(), query.goal)) return {};
  const Trials trials(layers, conversion, query, voxels);
  return {trials.robotRadius(), trials.heightOffset(), trials.maxStep()};
}

}  // namespace mrpt_mapconv::planning
