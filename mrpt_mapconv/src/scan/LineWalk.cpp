#include "LineWalk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "BitRow.h"

namespace mrpt_mapconv::scan
{
/** A line's way, in cells along its axes: cell `major` of row `minor` is so many cells from the
 * sensor's in the line's own directions. */
class LineWalk::Path
{
 public:
  Path(const Line& line, const SensorPlace& place, Rasters& rasters)
      : m_line(line),
        m_major(line.alongY ? place.fy : place.fx),
        m_minor(line.alongY ? place.fx : place.fy),
        m_rasters(rasters),
        m_edge(rasters.object.frame().width / 2)
  {
    if (line.majorSign < 0) m_major = 1 - m_major;
    if (line.minorSign < 0) m_minor = 1 - m_minor;
  }

  /** Of the rasters' outermost cells and rows. */
  std::int32_t edge() const { return m_edge; }

  /** The last cell of its run in a row; edge() + 1 if it leaves the rasters before. */
  std::int32_t runEnd(std::int32_t minor) const
  {
    const double leaves = m_major + (minor + 1 - m_minor) * m_line.majorPerMinor;
    return leaves < m_edge + 1 ? static_cast<std::int32_t>(leaves) : m_edge + 1;  // NaN: 0·infinity
  }

  double distanceSq(std::int32_t major, std::int32_t minor) const
  {
    const double a = major + 0.5 - m_major, b = minor + 0.5 - m_minor;
    return a * a + b * b;
  }

  /** The last row that it may be in before it is farther than that from the sensor [cells]. */
  std::int32_t rowsWithin(double distance) const
  {
    const double farthest = m_minor + distance * m_line.minorShare + 1;
    return farthest < m_edge ? static_cast<std::int32_t>(farthest) : m_edge;
  }

  /** The last cell from `first` to `last` of a row for which a condition on the squared distance
   * holds, given that it holds for all nearer ones; first − 1: none. */
  template <class Condition>
  std::int32_t lastWhere(std::int32_t first, std::int32_t last, std::int32_t minor,
                         const Condition& holds) const
  {
    if (holds(distanceSq(last, minor))) return last;
    std::int32_t none = last;
    last = first - 1;
    while (none - last > 1)
    {
      const std::int32_t middle = last + (none - last) / 2;
      (holds(distanceSq(middle, minor)) ? last : none) = middle;
    }
    return last;
  }

  /** A run of cells as columns of a raster. */
  struct Columns
  {
    std::int32_t low, high;
  };
  Columns columns(std::int32_t first, std::int32_t last) const
  {
    return m_line.majorSign > 0 ? Columns{m_edge + first, m_edge + last}
                                : Columns{m_edge - last, m_edge - first};
  }
  std::int32_t row(std::int32_t minor) const { return m_edge + m_line.minorSign * minor; }
  /** Nearest and farthest set cell of a run; −1: none. */
  std::int32_t nearest(const std::uint64_t* bits, const Columns& run) const
  {
    return cellOf(m_line.majorSign > 0 ? lowestSet(bits, run.low, run.high)
                                       : highestSet(bits, run.low, run.high));
  }
  std::int32_t farthest(const std::uint64_t* bits, const Columns& run) const
  {
    return cellOf(m_line.majorSign > 0 ? highestSet(bits, run.low, run.high)
                                       : lowestSet(bits, run.low, run.high));
  }
  Rasters& rasters() const { return m_rasters; }

 private:
  std::int32_t cellOf(std::int32_t column) const
  {
    return column < 0 ? -1 : m_line.majorSign * (column - m_edge);
  }

  const Line& m_line;
  double m_major, m_minor;  //!< where in its cell the sensor is
  Rasters& m_rasters;
  std::int32_t m_edge;
};

namespace
{
void addRun(const std::uint64_t* from, std::int32_t low, std::int32_t high, std::uint64_t* to)
{
  forEachWord(low, high,
              [&](std::int32_t word, std::uint64_t mask) { to[word] |= from[word] & mask; });
}

void fillRun(std::int32_t low, std::int32_t high, std::uint64_t* to)
{
  if (low >> 6 == high >> 6)
    to[low >> 6] |= rangeMask(low >> 6, low, high);
  else
    forEachWord(low, high, [&](std::int32_t word, std::uint64_t mask) { to[word] |= mask; });
}
}  // namespace

LineWalk::LineWalk(const SensorPlace& place, Model model, double tolerance, Rasters& rows,
                   Rasters& columns, std::vector<std::int32_t>& scratch)
    : m_place(place),
      m_model(model),
      m_tolerance(tolerance),
      m_rows(rows),
      m_columns(columns),
      m_ends(scratch)
{
  m_ends.resize(static_cast<std::size_t>(rows.object.frame().width));
}

double LineWalk::validUpTo(double wallSq) const
{
  constexpr double kSlack = 1e-9;  // cells; so that a tolerance of a whole number of cells holds
  return std::sqrt(wallSq) + m_tolerance + kSlack;
}

/** What has been found on a line so far. */
struct LineWalk::Findings
{
  double& wallSq;
  double valid;  //!< distance up to which O-cells are valid [cells]
  bool wallCrossed = false;
  std::int32_t lastRow = -1, lastCell = -1;  //!< of the last valid O-cell
};

void LineWalk::walk(const Line& line, double reach, double& wallSq)
{
  const Path path(line, m_place, line.alongY ? m_columns : m_rows);
  const CellBits& any = path.rasters().any;
  Findings found{wallSq, validUpTo(wallSq)};
  const std::int32_t rows = path.rowsWithin(std::min(reach, found.valid));
  std::int32_t first = 0;
  for (std::int32_t minor = 0; minor <= rows; ++minor)
  {
    const std::int32_t end = path.runEnd(minor);
    const std::int32_t last = std::min(end, path.edge());
    m_ends[static_cast<std::size_t>(minor)] = last;
    const auto run = path.columns(first, last);
    if (anySet(any.row(path.row(minor)), run.low, run.high) &&
        !look(path, minor, first, last, found))
      break;
    if (end > path.edge()) break;
    first = last;
  }
  if (found.lastRow >= 0) fillFree(path, found);
}

/** Looks at a row's run, in which there is an O- or W-cell.
 * \return false if the line says no more beyond it */
bool LineWalk::look(const Path& path, std::int32_t minor, std::int32_t first, std::int32_t last,
                    Findings& found)
{
  Rasters& rasters = path.rasters();
  const std::int32_t row = path.row(minor);
  if (!found.wallCrossed)
    if (const auto wall = path.nearest(rasters.wall.row(row), path.columns(first, last)); wall >= 0)
    {
      found.wallCrossed = true;
      found.wallSq = std::min(found.wallSq, path.distanceSq(wall, minor));
      found.valid = validUpTo(found.wallSq);
    }

  const auto isValid = [limitSq = found.valid * found.valid](double distanceSq)
  { return distanceSq <= limitSq; };
  const std::int32_t lastValid = path.lastWhere(first, last, minor, isValid);
  if (lastValid < first) return false;
  const auto run = path.columns(first, lastValid);
  const std::uint64_t* objects = rasters.object.row(row);
  const bool onlyNearest = m_model == Model::ClosestPoint;
  if (onlyNearest && found.lastRow >= 0) return !std::isfinite(found.wallSq);  // seeks the wall
  const auto cell = onlyNearest ? path.nearest(objects, run) : path.farthest(objects, run);
  if (cell >= 0)
  {
    const auto valid = onlyNearest ? path.columns(cell, cell) : run;
    addRun(objects, valid.low, valid.high, rasters.occupied.row(row));
    found.lastRow = minor;
    found.lastCell = cell;
  }
  return lastValid == last;
}

/** Marks the cells up to the last valid one that are nearer than the wall. */
void LineWalk::fillFree(const Path& path, const Findings& found)
{
  const auto firstOf = [this](std::int32_t minor)
  { return minor > 0 ? m_ends[static_cast<std::size_t>(minor) - 1] : 0; };
  const auto isNearer = [&found](double distanceSq) { return distanceSq < found.wallSq; };
  std::int32_t row = found.lastRow;
  std::int32_t last = path.lastWhere(firstOf(row), found.lastCell, row, isNearer);
  while (last < firstOf(row))
  {
    if (--row < 0) return;
    last = path.lastWhere(firstOf(row), m_ends[static_cast<std::size_t>(row)], row, isNearer);
  }
  for (; row >= 0; --row)
  {
    const std::int32_t first = firstOf(row);
    const auto run = path.columns(first, last);
    fillRun(run.low, run.high, path.rasters().free.row(path.row(row)));
    last = first;
  }
}

double LineWalk::crossedWallSq(const Line& line, double reach) const
{
  const Path path(line, m_place, line.alongY ? m_columns : m_rows);
  const CellBits& walls = path.rasters().wall;
  const std::int32_t rows = path.rowsWithin(reach);
  std::int32_t first = 0;
  for (std::int32_t minor = 0; minor <= rows && first <= path.edge(); ++minor)
  {
    const std::int32_t end = path.runEnd(minor);
    const auto run = path.columns(first, std::min(end, path.edge()));
    if (const auto wall = path.nearest(walls.row(path.row(minor)), run); wall >= 0)
      return path.distanceSq(wall, minor);
    first = end;
  }
  return std::numeric_limits<double>::infinity();
}

bool LineWalk::crosses(const Line& line, std::int32_t ix, std::int32_t iy) const
{
  const Path path(line, m_place, line.alongY ? m_columns : m_rows);
  const std::int32_t major = line.majorSign * (line.alongY ? iy : ix);
  const std::int32_t minor = line.minorSign * (line.alongY ? ix : iy);
  if (major < 0 || minor < 0) return false;
  const std::int32_t first = minor > 0 ? path.runEnd(minor - 1) : 0;
  return first <= major && major <= path.runEnd(minor);
}

}  // namespace mrpt_mapconv::scan
