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
    const int first = static_cast<int>(std::ceil(m_query.robotRadius / kStep - 1e-6)) - 1;
    const int last = static_cast<int>(std::ceil(m_layers.frame().resolution / 2 / kStep - 1e-6));
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
        query.lift.heightOffset =
            std::round((query.lift.heightOffset + sign * cells * cell) / kMm) * kMm;
        if (query.lift.heightOffset >= 0 && finds(query)) return query.lift.heightOffset;
      }
    return std::nullopt;
  }

  /** Whether there is a higher step that a ground robot may be asked to climb. */
  bool mayClimbMore() const
  {
    return m_query.lift.robot == Robot::Ground && lowestStep() <= highestStep();
  }

  std::optional<double> maxStep() const
  {
    if (!m_voxels || !mayClimbMore()) return std::nullopt;
    const auto found =
        nearestWorking(lowestStep(), highestStep(),
                       [&](int voxels)
                       {
                         freespace::ConversionParams params = m_conversion;
                         params.maxStep = stepOf(voxels);
                         const auto layers = freespace::convert(*m_voxels, params);
                         return planRobotPath(layers, params, m_query, m_voxels).found();
                       });
    return found ? std::optional(stepOf(*found)) : std::nullopt;
  }

 private:
  static constexpr double kMm = 0.001;

  // of steps to try, in voxels
  int lowestStep() const
  {
    if (!m_conversion.looksForSteps()) return 1;
    return m_conversion.maxStepVoxels(m_layers.frame().resolution) + 1;
  }
  int highestStep() const
  {
    return static_cast<int>(std::min(m_conversion.minClearance / m_layers.frame().resolution, 1e6));
  }
  double stepOf(int voxels) const
  {
    return std::ceil(voxels * m_layers.frame().resolution / kMm - 1e-6) * kMm;
  }
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
  return {trials.robotRadius(), trials.heightOffset(), trials.maxStep(),
          !voxels && trials.mayClimbMore()};
}

}  // namespace mrpt_mapconv::planning
