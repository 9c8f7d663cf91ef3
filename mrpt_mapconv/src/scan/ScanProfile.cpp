#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "BitRow.h"
#include "CeilingCheck.h"
#include "LineFan.h"
#include "LineReach.h"
#include "LineWalk.h"
#include "Rasters.h"
#include "SensorPlace.h"
#include "Slices.h"

namespace mrpt_mapconv::scan
{
using mrpt::math::TPoint3Df;

namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr double kNoWall = std::numeric_limits<double>::infinity();

void checkResolution(double resolution, const ProfileParams& params)
{
  constexpr double kMostCells = 10000;  // of maxRange: rasters then have 50 MB each
  params::require(std::isfinite(resolution) && resolution > 0, "resolution", resolution,
                  "a cell size > 0 m");
  if (params.maxRange <= kMostCells * resolution) return;
  std::ostringstream message;
  message << "maxRange = " << params.maxRange << " is not valid: with resolution = " << resolution
          << " m it must be at most " << kMostCells * resolution << " m (" << kMostCells
          << " cells)";
  throw std::invalid_argument(message.str());
}

double gapOf(const ProfileParams& params, double azimuthStep)
{
  constexpr double kLeast = 0.5 * kPi / 180;
  return params.structureGap >= 0 ? params.structureGap : std::max(kLeast, azimuthStep / 2);
}

double toleranceInCells(const ProfileParams& params, double resolution)
{
  return params.structureTolerance >= 0 ? params.structureTolerance / resolution : 1.0;
}
}  // namespace

struct ScanProfile::Workspace
{
  void fillRasters();
  void findWallsByAzimuth(double gap);
  void lowerWalls(double fromAzimuth, double toAzimuth, double distanceSq);
  void lowerFarWalls(const StructurePoint& point, double azimuth);
  void measureReach();
  void walkLines(LineWalk& walk);
  void judgeUncrossed(const LineWalk& walk);
  void judge(std::int32_t ix, std::int32_t iy, const LineWalk& walk);
  bool isCrossed(std::int32_t ix, std::int32_t iy, double azimuth, const LineWalk& walk) const;
  double wallTowards(double azimuth);
  void sortByAzimuth();
  bool isInRasters(const CellOffset& cell) const
  {
    return std::max(std::abs(cell.x), std::abs(cell.y)) <= slices.reach;
  }
  void finish();
  void findBounds();

  SensorPlace place;
  Slices slices;
  Rasters rows, columns;  //!< for lines along x, and along y: with x and y exchanged
  LineFan fan;
  LineReach reach;
  double structureGap = 0;                           //!< [rad]
  std::vector<std::pair<double, double>> byAzimuth;  //!< [rad, cells²] of structure; made if needed
  std::vector<double> wallsSq;  //!< of each line: squared distance of its wall [cells²]
  std::vector<std::int32_t> runEnds;
  grid::GridFrame bounds;
  ProfileStatistics statistics;
};

ScanProfile::ScanProfile() : m_work(std::make_unique<Workspace>()) {}
ScanProfile::~ScanProfile() = default;
ScanProfile::ScanProfile(ScanProfile&&) noexcept = default;
ScanProfile& ScanProfile::operator=(ScanProfile&&) noexcept = default;

const CellBits& ScanProfile::occupied() const { return m_work->rows.occupied; }
const CellBits& ScanProfile::free() const { return m_work->rows.free; }
grid::GridFrame ScanProfile::bounds() const { return m_work->bounds; }
const ProfileStatistics& ScanProfile::statistics() const { return m_work->statistics; }

void ScanProfile::compute(const std::vector<TPoint3Df>& points, const Viewpoint& view,
                          double resolution, const ProfileParams& params)
{
  params.check();
  checkResolution(resolution, params);
  Workspace& work = *m_work;
  work.place = placeOf(view, resolution, params);
  work.slices.take(points, view, work.place, params);
  work.fillRasters();
  work.fan.setCount(params.sectors > 0 ? params.sectors : linesFor(params.maxRange, resolution));
  work.findWallsByAzimuth(gapOf(params, view.azimuthStep));
  work.measureReach();
  LineWalk walk(work.place, params.model, toleranceInCells(params, resolution), work.rows,
                work.columns, work.runEnds);
  work.walkLines(walk);
  work.rows.mergeTransposed(work.columns);
  if (params.model == Model::WholeShape) work.judgeUncrossed(walk);
  work.statistics.points = points.size();
  work.statistics.ceiling = std::nullopt;
  if (params.reflectionFilter)
    work.statistics.ceiling = ceilingIn(work.slices, work.place, work.rows.object, params);
  work.finish();
}

void ScanProfile::Workspace::fillRasters()
{
  const std::int32_t half = slices.reach, side = 2 * half + 1;
  rows.reset({place.resolution, place.kx - half, place.ky - half, side, side});
  columns.reset({place.resolution, place.ky - half, place.kx - half, side, side});
  const auto add = [half](const CellOffset& cell, CellBits& row, CellBits& column)
  {
    row.set(half + cell.x, half + cell.y);
    column.set(half + cell.y, half + cell.x);
  };
  for (const CellOffset& cell : slices.object) add(cell, rows.object, columns.object);
  for (const StructurePoint& point : slices.structure)
    if (isInRasters(point.cell)) add(point.cell, rows.wall, columns.wall);
  rows.findAny();
  columns.findAny();
}

/** Lines finer than the sensor's must not slip between its points: each point is a wall for all
 * lines nearby. */
void ScanProfile::Workspace::findWallsByAzimuth(double gap)
{
  wallsSq.assign(static_cast<std::size_t>(fan.count()), kNoWall);
  byAzimuth.clear();
  structureGap = gap;
  for (const StructurePoint& point : slices.structure)
  {
    if (point.x == 0 && point.y == 0) continue;  // right above: it has no azimuth
    const double azimuth = std::atan2(point.y, point.x);
    const double distanceSq = place.distanceSq(point.cell.x, point.cell.y);
    lowerWalls(azimuth - gap, azimuth + gap, distanceSq);
    if (!isInRasters(point.cell)) lowerFarWalls(point, azimuth);
  }
}

/** Lowers the walls of the lines within a range of azimuths [rad]. */
void ScanProfile::Workspace::lowerWalls(double fromAzimuth, double toAzimuth, double distanceSq)
{
  const std::int32_t lines = fan.count();
  const double step = fan.step();
  const auto first = static_cast<std::int32_t>(std::ceil(fromAzimuth / step));
  const auto last =
      std::min(static_cast<std::int32_t>(std::floor(toAzimuth / step)), first + lines - 1);
  auto line = static_cast<std::size_t>((first + lines) % lines);
  for (std::int32_t left = last - first + 1; left > 0; --left)
  {
    wallsSq[line] = std::min(wallsSq[line], distanceSq);
    if (++line == wallsSq.size()) line = 0;
  }
}

/** A wall beyond all objects cuts nothing, but the lines that cross its cell have one. */
void ScanProfile::Workspace::lowerFarWalls(const StructurePoint& point, double azimuth)
{
  const double distanceSq = place.distanceSq(point.cell.x, point.cell.y);
  constexpr double kNarrow = 4;  // cells; enough for lines through any of the cell's corners
  if (structureGap * structureGap * distanceSq >= kNarrow * kNarrow) return;  // near the point
  constexpr double kInside = 1 - 1e-9;  // a cell's upper borders belong to the next one
  double low = 0, high = 0;             // of the cell's corners, from the point's azimuth
  for (int corner = 0; corner < 4; ++corner)
  {
    const double dx = point.cell.x + kInside * (corner % 2) - place.fx,
                 dy = point.cell.y + kInside * (corner / 2) - place.fy;
    const double turn = std::remainder(std::atan2(dy, dx) - azimuth, 2 * kPi);
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  lowerWalls(azimuth + low, azimuth + high, distanceSq);
}

void ScanProfile::Workspace::measureReach()
{
  reach.clear();
  const std::int32_t half = slices.reach;
  for (std::int32_t iy = 0; iy <= 2 * half; ++iy)
    for (std::int32_t word = 0; word < static_cast<std::int32_t>(rows.any.wordsPerRow()); ++word)
      forEachBit(rows.any.row(iy)[word], word,
                 [&](std::int32_t ix) { reach.add(place, ix - half, iy - half); });
}

void ScanProfile::Workspace::walkLines(LineWalk& walk)
{
  for (std::int32_t i = 0; i < fan.count(); ++i)
  {
    const Line& line = fan.line(i);
    const double farthest = reach.of(line);
    if (farthest >= 0) walk.walk(line, farthest, wallsSq[static_cast<std::size_t>(i)]);
  }
}

/** Every valid object cell is occupied, also one that all lines pass by. */
void ScanProfile::Workspace::judgeUncrossed(const LineWalk& walk)
{
  const std::int32_t half = slices.reach;
  for (std::int32_t iy = 0; iy <= 2 * half; ++iy)
    for (std::int32_t word = 0; word < static_cast<std::int32_t>(rows.object.wordsPerRow()); ++word)
      forEachBit(rows.object.row(iy)[word] & ~rows.occupied.row(iy)[word], word,
                 [&](std::int32_t ix) { judge(ix - half, iy - half, walk); });
}

void ScanProfile::Workspace::judge(std::int32_t ix, std::int32_t iy, const LineWalk& walk)
{
  const double dx = ix + 0.5 - place.fx, dy = iy + 0.5 - place.fy;
  const double azimuth = std::atan2(dy, dx), distanceSq = place.distanceSq(ix, iy);
  if (isCrossed(ix, iy, azimuth, walk)) return;  // those lines have said all
  const double wallSq = std::min(wallTowards(azimuth),
                                 walk.crossedWallSq(lineTowards(dx, dy), std::sqrt(distanceSq)));
  if (walk.isValid(distanceSq, wallSq)) rows.occupied.set(ix + slices.reach, iy + slices.reach);
}

/** If any line crosses a cell, one of the two beside its centre does. */
bool ScanProfile::Workspace::isCrossed(std::int32_t ix, std::int32_t iy, double azimuth,
                                       const LineWalk& walk) const
{
  const std::int32_t lines = fan.count();
  const auto below = static_cast<std::int32_t>(std::floor(azimuth / fan.step())) + lines;
  return walk.crosses(fan.line(below % lines), ix, iy) ||
         walk.crosses(fan.line((below + 1) % lines), ix, iy);
}

/** Few scans have cells that no line crosses, so only they pay for this. */
void ScanProfile::Workspace::sortByAzimuth()
{
  for (const StructurePoint& point : slices.structure)
    if (point.x != 0 || point.y != 0)
      byAzimuth.emplace_back(std::atan2(point.y, point.x),
                             place.distanceSq(point.cell.x, point.cell.y));
  std::sort(byAzimuth.begin(), byAzimuth.end());
}

/** Square of the distance of the nearest W-cell with a point near an azimuth [cells²]. */
double ScanProfile::Workspace::wallTowards(double azimuth)
{
  if (byAzimuth.empty()) sortByAzimuth();
  double wallSq = kNoWall;
  for (const double turn : {-2 * kPi, 0.0, 2 * kPi})
  {
    const auto from = std::make_pair(azimuth + turn - structureGap, 0.0);
    auto point = std::lower_bound(byAzimuth.begin(), byAzimuth.end(), from);
    for (; point != byAzimuth.end() && point->first <= azimuth + turn + structureGap; ++point)
      wallSq = std::min(wallSq, point->second);
  }
  return wallSq;
}

/** Occupied wins over free; then the cells are counted. */
void ScanProfile::Workspace::finish()
{
  const std::int32_t side = 2 * slices.reach + 1;
  for (std::int32_t iy = 0; iy < side; ++iy)
    for (std::size_t word = 0; word < rows.free.wordsPerRow(); ++word)
      rows.free.row(iy)[word] &= ~rows.object.row(iy)[word];
  findBounds();
  statistics.objectPoints = slices.object.size();
  statistics.structurePoints = slices.structure.size();
  statistics.lines = fan.count();
  statistics.linesWithWall = static_cast<std::int32_t>(
      std::count_if(wallsSq.begin(), wallsSq.end(), [](double wall) { return wall < kNoWall; }));
  statistics.occupiedCells = rows.occupied.count();
  statistics.freeCells = rows.free.count();
}

void ScanProfile::Workspace::findBounds()
{
  const grid::GridFrame& square = rows.occupied.frame();
  std::int32_t xLow = square.width, xHigh = -1, yLow = square.height, yHigh = -1;
  for (std::int32_t iy = 0; iy < square.height; ++iy)
    for (const CellBits* bits : {&rows.occupied, &rows.free})
    {
      const std::int32_t low = lowestSet(bits->row(iy), 0, square.width - 1);
      if (low < 0) continue;
      xLow = std::min(xLow, low);
      xHigh = std::max(xHigh, highestSet(bits->row(iy), 0, square.width - 1));
      yLow = std::min(yLow, iy);
      yHigh = iy;
    }
  bounds = {square.resolution, square.x0 + xLow, square.y0 + yLow, xHigh - xLow + 1,
            yHigh - yLow + 1};
  if (xHigh < 0) bounds = {square.resolution, square.x0, square.y0, 0, 0};
}

}  // namespace mrpt_mapconv::scan
