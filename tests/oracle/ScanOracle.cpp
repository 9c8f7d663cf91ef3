#include "ScanOracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mrpt_mapconv::oracle
{
namespace
{
using Key = std::pair<int, int>;

constexpr long double kPi = 3.141592653589793238462643383279502884L;
constexpr long double kInfinity = std::numeric_limits<long double>::infinity();
constexpr long double kSlack = 1e-9L;        // cells, for "at most structureTolerance farther"
constexpr long double kDistanceTie = 1e-8L;  // cells
constexpr long double kCornerTie = 1e-6L;    // cells between a line and a corner
constexpr long double kAzimuthTie = 1e-6L;   // rad

int floorOf(long double x) { return static_cast<int>(std::floor(x)); }

/** Of two azimuths within [−π, π]. */
long double angleBetween(long double a, long double b)
{
  const long double angle = std::abs(a - b);
  return std::min(angle, 2 * kPi - angle);
}

/** The last row of cells that a line visits in a column that it leaves at height y. Where that is a
 * corner exactly, it goes on along the axis that it is more along: if that is x, it is not yet in
 * the row beyond. */
int lastRow(long double y, bool upwards, bool alongX)
{
  return upwards == alongX ? static_cast<int>(std::ceil(y)) - 1 : floorOf(y);
}
}  // namespace

int ScanOracle::lineCount(double resolution, const scan::ProfileParams& params)
{
  if (params.sectors > 0) return params.sectors;
  int lines = 4;
  while (lines * static_cast<long double>(resolution) < 2 * kPi * params.maxRange) lines += 4;
  return lines;
}

double ScanOracle::structureGap(const scan::Viewpoint& view, const scan::ProfileParams& params)
{
  if (params.structureGap != -1) return params.structureGap;
  return std::max(view.azimuthStep / 2, static_cast<double>(kPi) / 360);
}

ScanOracle::ScanOracle(const std::vector<mrpt::math::TPoint3Df>& points,
                       const scan::Viewpoint& view, double resolution,
                       const scan::ProfileParams& params)
    : m_resolution(resolution),
      m_sensorX(view.sensorPose.x() / m_resolution),
      m_sensorY(view.sensorPose.y() / m_resolution),
      m_tolerance(params.structureTolerance == -1 ? 1 : params.structureTolerance / m_resolution),
      m_params(params),
      m_lines(lineCount(resolution, params)),
      m_gap(structureGap(view, params))
{
  for (const auto& point : points)
    if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z))
      addPoint(point, view);
  for (const CellKeys* cells : {&m_object, &m_wall})
    for (const Key& cell : *cells) m_reach = std::max(m_reach, distance(cell) + 2);
}

void ScanOracle::addPoint(const mrpt::math::TPoint3Df& point, const scan::Viewpoint& view)
{
  const mrpt::math::TPoint3D inMap = view.sensorPose.composePoint(mrpt::math::TPoint3D(point));
  const long double x = inMap.x / m_resolution, y = inMap.y / m_resolution;
  const Key cell(floorOf(x), floorOf(y));
  const double height = inMap.z - view.baseZ;
  const long double range = std::hypot(x - m_sensorX, y - m_sensorY) * m_resolution;
  if (height >= m_params.objectMinZ && height <= m_params.objectMaxZ &&
      range >= m_params.minRange && range <= m_params.maxRange)
    m_object.insert(cell);
  if (m_params.reflectionFilter && height >= m_params.structureMinZ &&
      height <= m_params.structureMaxZ)
  {
    m_wall.insert(cell);
    if (range > 0) m_structure.push_back({cell, std::atan2(y - m_sensorY, x - m_sensorX)});
  }
}

long double ScanOracle::distance(const Key& cell) const
{
  return std::hypot(cell.first + 0.5L - m_sensorX, cell.second + 0.5L - m_sensorY);
}

bool ScanOracle::inReach(long double x, long double y) const
{
  return std::hypot(x - m_sensorX, y - m_sensorY) <= m_reach;
}

std::vector<Key> ScanOracle::walk(long double dx, long double dy, ScanCells& result) const
{
  std::vector<Key> cells;
  const int stepX = dx < 0 ? -1 : 1, stepY = dy < 0 ? -1 : 1;
  int kx = floorOf(m_sensorX), ky = floorOf(m_sensorY);
  while (true)
  {
    const int borderX = dx < 0 ? kx : kx + 1;
    // where the line leaves the column; far away if it is (nearly) vertical
    const long double far = stepY * 1e8L;
    const long double leavesAt =
        dx == 0 ? far : std::clamp(m_sensorY + (borderX - m_sensorX) * dy / dx, -1e8L, 1e8L);
    const bool leavesInReach = inReach(borderX, leavesAt);
    if (leavesInReach &&
        std::abs(leavesAt - std::round(leavesAt)) * std::abs(dx) < kCornerTie * std::hypot(dx, dy))
      result.tie = true;
    const int last = lastRow(leavesAt, dy >= 0, std::abs(dx) > std::abs(dy));
    for (cells.emplace_back(kx, ky); (last - ky) * stepY > 0 && distance({kx, ky}) <= m_reach;)
      cells.emplace_back(kx, ky += stepY);
    if (!leavesInReach) return cells;
    kx += stepX;
  }
}

long double ScanOracle::findWall(const Line& line, long double azimuth, ScanCells& result) const
{
  long double nearest = kInfinity;
  for (const Key& cell : line.cells)
    if (m_wall.count(cell) != 0) nearest = std::min(nearest, distance(cell));
  for (const StructurePoint& point : m_structure)
  {
    const long double angle = angleBetween(point.azimuth, azimuth);
    const long double far = distance(point.cell);
    if (std::abs(angle - m_gap) < kAzimuthTie && far < nearest) result.tie = true;
    if (angle <= m_gap) nearest = std::min(nearest, far);
  }
  return nearest;
}

ScanOracle::Line ScanOracle::line(long double dx, long double dy, ScanCells& result) const
{
  Line found;
  found.cells = walk(dx, dy, result);
  found.wall = findWall(found, std::atan2(dy, dx), result);
  return found;
}

bool ScanOracle::isValid(const Key& cell, long double wall, ScanCells& result) const
{
  const long double beyond = distance(cell) - (wall + m_tolerance);
  // the wall's own cell has the same distance however it is rounded
  if (distance(cell) != wall && std::abs(beyond - kSlack) < kDistanceTie) result.tie = true;
  return beyond <= kSlack;
}

bool ScanOracle::isBeforeWall(const Key& cell, long double wall, ScanCells& result) const
{
  if (distance(cell) != wall && std::abs(distance(cell) - wall) < kDistanceTie) result.tie = true;
  return distance(cell) < wall;
}

void ScanOracle::addWholeShape(const Line& line, ScanCells& result) const
{
  std::size_t end = 0;  // one past the last valid O-cell
  for (std::size_t i = 0; i < line.cells.size(); ++i)
    if (m_object.count(line.cells[i]) != 0 && isValid(line.cells[i], line.wall, result))
    {
      result.occupied.insert(line.cells[i]);
      end = i + 1;
    }
  for (std::size_t i = 0; i < end; ++i)
    if (m_object.count(line.cells[i]) == 0 && isBeforeWall(line.cells[i], line.wall, result))
      result.free.insert(line.cells[i]);
}

void ScanOracle::addClosestPoint(const Line& line, ScanCells& result) const
{
  const auto hit =
      std::find_if(line.cells.begin(), line.cells.end(),
                   [&](const Key& cell)
                   { return m_object.count(cell) != 0 && isValid(cell, line.wall, result); });
  if (hit == line.cells.end()) return;
  result.occupied.insert(*hit);
  for (auto cell = line.cells.begin(); cell != hit; ++cell)
    if (isBeforeWall(*cell, line.wall, result)) result.free.insert(*cell);
}

void ScanOracle::addCellsOffTheLines(const CellKeys& crossed, ScanCells& result) const
{
  for (const Key& cell : m_object)
  {
    if (crossed.count(cell) != 0) continue;
    const Line own = line(cell.first + 0.5L - m_sensorX, cell.second + 0.5L - m_sensorY, result);
    if (isValid(cell, own.wall, result)) result.occupied.insert(cell);
  }
}

/** A cosine or sine that is 0 where the azimuth, rounded, is a right angle. */
static long double exactly(long double ratio) { return std::abs(ratio) < 1e-15L ? 0 : ratio; }

ScanCells ScanOracle::profile() const
{
  ScanCells result;
  CellKeys crossed;
  result.lines = m_lines;
  for (int i = 0; i < m_lines; ++i)
  {
    const long double azimuth = 2 * kPi * i / m_lines;
    const Line found = line(exactly(std::cos(azimuth)), exactly(std::sin(azimuth)), result);
    result.linesWithWall += std::isfinite(found.wall) ? 1 : 0;
    crossed.insert(found.cells.begin(), found.cells.end());
    if (m_params.model == scan::Model::WholeShape)
      addWholeShape(found, result);
    else
      addClosestPoint(found, result);
  }
  if (m_params.model == scan::Model::WholeShape) addCellsOffTheLines(crossed, result);
  for (const Key& cell : result.occupied) result.free.erase(cell);
  return result;
}

}  // namespace mrpt_mapconv::oracle
