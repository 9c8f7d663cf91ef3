#include "LiftOracle.h"

#include <mrpt_mapconv/freespace/Evidence.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "Shares.h"

namespace mrpt_mapconv::oracle
{
namespace
{
using path::HeightRule;
using path::Infeasibility;

constexpr double kSlack = 1e-9;        // cells, for distances
constexpr double kHeightSlack = 1e-5;  // m
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/** Distance of a coordinate from the interval that cell `key` covers. */
double distanceTo(int key, double x, double res)
{
  if (x < key * res) return key * res - x;
  if (x > (key + 1) * res) return x - (key + 1) * res;
  return 0;
}

void fail(path::LiftedPoint& point, Infeasibility problem)
{
  point.problem = problem;
  point.rule = HeightRule::None;
  point.position.z = kNaN;
}

bool allSatisfied(const std::vector<CellDemand>& demands, double z)
{
  return std::all_of(demands.begin(), demands.end(),
                     [&](const CellDemand& demand) { return LiftOracle::satisfied(demand, z); });
}

/** Whether a cell's lowest floor (highest ceiling) is what the sphere touches at height z. */
bool touchesFloor(const std::vector<CellDemand>& demands, double z)
{
  return std::any_of(
      demands.begin(), demands.end(),
      [&](const CellDemand& demand)
      { return std::abs(demand.runs.front().begin + demand.halfHeight - z) <= kHeightSlack; });
}
bool touchesCeiling(const std::vector<CellDemand>& demands, double z)
{
  return std::any_of(
      demands.begin(), demands.end(),
      [&](const CellDemand& demand)
      { return std::abs(demand.runs.back().end - demand.halfHeight - z) <= kHeightSlack; });
}

/** Of all heights at which the sphere touches something, the allowed one nearest to `wanted`. */
double nearestTouching(const std::vector<CellDemand>& demands, double wanted)
{
  double best = kNaN;
  const auto consider = [&](double z)
  {
    if (!allSatisfied(demands, z)) return;
    const double gain = std::abs(best - wanted) - std::abs(z - wanted);
    if (std::isnan(best) || gain > kHeightSlack || (gain >= -kHeightSlack && z > best)) best = z;
  };
  for (const CellDemand& demand : demands)
    for (const KeptRun& run : demand.runs)
    {
      consider(run.begin + demand.halfHeight);
      consider(run.end - demand.halfHeight);
    }
  return best;
}
}  // namespace

LiftOracle::LiftOracle(const freespace::Layers& layers,
                       const freespace::ConversionParams& conversion,
                       const path::LiftParams& params, const DenseMap* voxels)
    : m_layers(layers), m_conversion(conversion), m_params(params), m_voxels(voxels)
{
}

bool LiftOracle::satisfied(const CellDemand& demand, double z)
{
  return std::any_of(demand.runs.begin(), demand.runs.end(),
                     [&](const KeptRun& run)
                     {
                       return run.begin + demand.halfHeight <= z + kHeightSlack &&
                              z - kHeightSlack <= run.end - demand.halfHeight;
                     });
}

/** The cell that holds a place; nothing off the map. */
std::optional<std::size_t> LiftOracle::cellAt(double x, double y) const
{
  const grid::GridFrame& frame = m_layers.frame();
  const double res = frame.resolution;
  for (int ky = frame.y0; ky < frame.yEnd(); ++ky)
    for (int kx = frame.x0; kx < frame.xEnd(); ++kx)
      if (kx * res <= x && x < (kx + 1) * res && ky * res <= y && y < (ky + 1) * res)
        return frame.indexOfKey(kx, ky);
  return std::nullopt;
}

/** What a path's heights are counted from: a flying robot's from the floor, that of one on the
 * ground from what it stands on. */
float LiftOracle::heightOf(std::size_t cell) const
{
  if (m_params.robot == freespace::Robot::Aerial) return m_layers.floor.cells()[cell];
  return m_layers.support.cells()[cell];
}

double LiftOracle::highestFloor(const std::vector<path::LiftedPoint>& dense,
                                std::size_t index) const
{
  const double reach = m_params.lookahead + kSlack * m_layers.frame().resolution;
  double highest = kNaN;
  const auto consider = [&](const path::LiftedPoint& point)
  {
    const auto cell = cellAt(point.position.x, point.position.y);
    if (cell && !std::isnan(heightOf(*cell)) && !(highest >= heightOf(*cell)))
      highest = heightOf(*cell);
  };
  const auto step = [&](std::size_t a, std::size_t b)
  {
    return std::hypot(dense[a].position.x - dense[b].position.x,
                      dense[a].position.y - dense[b].position.y);
  };
  consider(dense[index]);
  double way = 0;
  for (std::size_t i = index; i > 0 && (way += step(i, i - 1)) <= reach; --i)
    consider(dense[i - 1]);
  way = 0;
  for (std::size_t i = index + 1; i < dense.size() && (way += step(i - 1, i)) <= reach; ++i)
    consider(dense[i]);
  return highest;
}

double LiftOracle::inferredLength(const std::vector<path::LiftedPoint>& dense) const
{
  const grid::GridFrame& frame = m_layers.frame();
  const double res = frame.resolution;
  double sum = 0;
  for (int ky = frame.y0; ky < frame.yEnd(); ++ky)
    for (int kx = frame.x0; kx < frame.xEnd(); ++kx)
    {
      if (m_layers.evidence.cells()[frame.indexOfKey(kx, ky)] != freespace::evidence::kInferred)
        continue;
      for (std::size_t i = 1; i < dense.size(); ++i)
      {
        const auto &from = dense[i - 1].position, &to = dense[i].position;
        Shares inside;
        inside.cut(from.x, to.x, kx * res, (kx + 1) * res);
        inside.cut(from.y, to.y, ky * res, (ky + 1) * res);
        sum += std::max(0.0, inside.end - inside.begin) * std::hypot(to.x - from.x, to.y - from.y);
      }
    }
  return sum;
}

std::vector<KeptRun> LiftOracle::runsOf(int kx, int ky) const
{
  const grid::GridFrame& frame = m_layers.frame();
  if (!frame.containsKey(kx, ky)) return {};
  if (!m_voxels)
  {
    const std::size_t cell = frame.indexOfKey(kx, ky);
    const float floor = m_layers.floor.cells()[cell], ceiling = m_layers.ceiling.cells()[cell];
    if (std::isnan(floor)) return {};
    return {{floor, ceiling}};
  }
  const DenseMap& map = *m_voxels;
  const int ix = kx - map.x0, iy = ky - map.y0;
  const auto height = [&](int iz) { return static_cast<float>((map.z0 + iz) * map.resolution); };
  std::vector<KeptRun> runs;
  if (ix < 0 || iy < 0 || ix >= map.nx || iy >= map.ny) return runs;
  for (int begin = 0; begin < map.nz; ++begin)
  {
    int end = begin;
    while (end < map.nz && map.at(ix, iy, end) == Voxel::Free) ++end;
    if (end > begin && end - begin >= m_conversion.minClearance / map.resolution - 1e-6)
      runs.push_back({height(begin), height(end)});
    begin = end;
  }
  return runs;
}

std::vector<CellDemand> LiftOracle::demands(double x, double y) const
{
  const grid::GridFrame& frame = m_layers.frame();
  const double res = frame.resolution, radius = m_params.safetyRadius;
  const int reach = static_cast<int>(radius / res) + 2;
  std::vector<CellDemand> result;
  // the point lies on the map, so all cells in reach lie on it or in a margin around it
  for (int ky = frame.y0 - reach; ky < frame.yEnd() + reach; ++ky)
    for (int kx = frame.x0 - reach; kx < frame.xEnd() + reach; ++kx)
    {
      CellDemand demand;
      demand.distance = std::hypot(distanceTo(kx, x, res), distanceTo(ky, y, res));
      if (demand.distance > radius + kSlack * res) continue;
      demand.halfHeight =
          std::sqrt(std::max(0.0, radius * radius - demand.distance * demand.distance));
      demand.runs = runsOf(kx, ky);
      demand.occupied =
          frame.containsKey(kx, ky) && m_layers.aerial.cells()[frame.indexOfKey(kx, ky)] > 0;
      demand.centre = {(kx + 0.5) * res, (ky + 0.5) * res};
      result.push_back(demand);
    }
  return result;
}

void LiftOracle::fitSphere(path::LiftedPoint& point) const
{
  std::vector<CellDemand> fit;
  bool wall = false, unknown = false;
  for (const CellDemand& demand : demands(point.position.x, point.position.y))
    if (!demand.runs.empty())
      fit.push_back(demand);
    else if (demand.occupied)
      wall = true;
    else
      unknown = true;
  if (wall) return fail(point, Infeasibility::Wall);
  if (unknown && !m_params.unknownIsPassable) return fail(point, Infeasibility::Unknown);

  const double wanted = point.position.z;
  if (allSatisfied(fit, wanted)) return;
  const double z = nearestTouching(fit, wanted);
  if (std::isnan(z)) return fail(point, Infeasibility::NoHeight);
  point.position.z = z;
  point.rule = HeightRule::SphereSlab;
  if (z > wanted && touchesFloor(fit, z)) point.rule = HeightRule::SphereFloor;
  if (z < wanted && touchesCeiling(fit, z)) point.rule = HeightRule::SphereCeiling;
}

std::vector<path::LiftedPoint> LiftOracle::lift(const std::vector<path::LiftedPoint>& dense) const
{
  std::vector<path::LiftedPoint> lifted;
  for (std::size_t i = 0; i < dense.size(); ++i)
  {
    path::LiftedPoint point;
    point.position = dense[i].position;
    point.isInput = dense[i].isInput;
    const auto cell = cellAt(point.position.x, point.position.y);
    if (!cell)
      fail(point, Infeasibility::OffMap);
    else if (std::isnan(m_layers.floor.cells()[*cell]) && std::isnan(heightOf(*cell)))
      fail(point, Infeasibility::NoFloor);
    else if (std::isnan(heightOf(*cell)))
      fail(point, Infeasibility::UnseenGround);
    else
    {
      point.rule = HeightRule::FloorAhead;
      point.position.z = highestFloor(dense, i) + m_params.heightOffset;
      if (m_params.robot == freespace::Robot::Aerial) fitSphere(point);
    }
    lifted.push_back(point);
  }
  return lifted;
}

}  // namespace mrpt_mapconv::oracle
