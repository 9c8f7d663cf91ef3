#include "PlaneBorders.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "../grid/Parallel.h"
#include "PlaneRows.h"
#include "PlaneWidth.h"

namespace mrpt_mapconv::terrain
{
namespace
{
/** Distances are told apart in steps of this: heights are rounded [kHeightUnit]. */
constexpr double kTie = kSameHeight;
/** Fewer tiles are not worth a second thread. */
constexpr std::size_t kWorthThreads = 128;

struct Step
{
  std::int32_t x, y;
};
constexpr Step kNeighbours[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

/** Largest vertical difference of two planes over where the cells of one are: the rectangle that
 * has their mean and variances [kHeightUnit]. */
double differenceOver(const PlaneMoments& cells, const Plane& a, const Plane& b)
{
  const double dz = (a.height - a.slopeX * a.originX - a.slopeY * a.originY) -
                    (b.height - b.slopeX * b.originX - b.slopeY * b.originY);
  const double sx = a.slopeX - b.slopeX, sy = a.slopeY - b.slopeY;
  const double middle = dz + sx * cells.meanX() + sy * cells.meanY();
  return std::abs(middle) + std::abs(sx) * cells.halfWidthX() + std::abs(sy) * cells.halfWidthY();
}

/** Two planes, the lower number first. */
using PlanePair = std::pair<std::int32_t, std::int32_t>;

void sortUnique(std::vector<PlanePair>& pairs)
{
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/** The planes that touch in a tile. */
void addPairs(const PlaneBorders::Unsettled& part, std::vector<PlanePair>& pairs)
{
  Tile& tile = *part.tile;
  const std::size_t before = pairs.size();
  const auto add = [&](std::int32_t ix, std::int32_t iy, std::int32_t dx, std::int32_t dy)
  {
    const CellRef other = cellAt(tile, ix + dx, iy + dy);
    const PlanePair pair =
        std::minmax(+tile.plane[Tile::indexOf(ix, iy)], +other.tile->plane[other.index()]);
    if (pairs.size() == before || pairs.back() != pair) pairs.push_back(pair);
  };
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
  {
    const auto y = static_cast<std::size_t>(iy);
    forEachBit(part.meetings.east[y], [&](std::int32_t ix) { add(ix, iy, 1, 0); });
    forEachBit(part.meetings.north[y], [&](std::int32_t ix) { add(ix, iy, 0, 1); });
  }
}

std::vector<PlanePair> touchingPairs(const std::vector<PlaneBorders::Unsettled>& where)
{
  std::vector<PlanePair> pairs;
  for (const auto& part : where)
    if (!part.meetings.empty) addPairs(part, pairs);
  sortUnique(pairs);
  return pairs;
}
}  // namespace

std::vector<Tile*> PlaneBorders::tilesOf(std::int32_t id) const
{
  const TileBox& box = m_planes.at(id).tiles;
  std::vector<Tile*> tiles;
  const auto area =
      (std::int64_t{box.xMax} - box.xMin + 1) * (std::int64_t{box.yMax} - box.yMin + 1);
  if (area > static_cast<std::int64_t>(m_tiles.size()))
  {
    for (Tile* tile : m_tiles.sorted())
      if (tile->tx >= box.xMin && tile->tx <= box.xMax && tile->ty >= box.yMin &&
          tile->ty <= box.yMax)
        tiles.push_back(tile);
    return tiles;
  }
  for (std::int32_t ty = box.yMin; ty <= box.yMax; ++ty)
    for (std::int32_t tx = box.xMin; tx <= box.xMax; ++tx)
      if (Tile* tile = m_tiles.find(tx, ty)) tiles.push_back(tile);
  return tiles;
}

/** A choice that does not depend on how planes are numbered. An order that stays until the planes
 * are refitted: cells that only change for the better come to rest. */
bool PlaneBorders::prefers(std::int32_t a, std::int32_t b) const
{
  constexpr double kSameSlope = 0.05;  // [kHeightUnit per cell]
  const auto key = [this](std::int32_t id)
  {
    const Plane& plane = m_planes.at(id).plane;
    const double slope = std::hypot(plane.slopeX, plane.slopeY);
    return std::make_tuple(std::round(slope / kSameSlope), plane.slopeX, plane.slopeY);
  };
  return key(a) < key(b);
}

/** The plane that a cell is nearest to, its own or that of a neighbour within the tolerance. */
std::int32_t PlaneBorders::nearest(const CellRef& cell) const
{
  const std::int32_t own = cell.tile->plane[cell.index()];
  std::array<std::int32_t, 4> others;
  std::size_t count = 0;
  for (const Step& step : kNeighbours)
  {
    const CellRef other = cellAt(*cell.tile, cell.ix + step.x, cell.iy + step.y);
    const std::int32_t id = other ? other.tile->plane[other.index()] : kNoPlane;
    if (id != kNoPlane && id != own && (count == 0 || others[count - 1] != id))
      others[count++] = id;
  }
  if (count == 0) return own;
  const auto rankOf = [](double distance) { return std::floor(distance / kTie); };
  std::int32_t best = own;
  double least = own == kNoPlane ? 0 : rankOf(m_planes.distance(cell, own));
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::int32_t id = others[i];
    const double distance = m_planes.distance(cell, id), rank = rankOf(distance);
    if (distance > m_search.tolerance || id == best) continue;
    const bool isNearer = best == kNoPlane || rank < least || (rank == least && prefers(id, best));
    if (!isNearer) continue;
    best = id;
    least = rank;
  }
  return best;
}

void PlaneBorders::absorb(const std::vector<TileCells>& cells)
{
  std::vector<CellRef> stack;
  const auto tryCell = [&](const CellRef& cell)
  {
    if (!cell || !cell.tile->isKnown(cell.ix, cell.iy) ||
        cell.tile->plane[cell.index()] != kNoPlane)
      return;
    const std::int32_t id = nearest(cell);
    if (id == kNoPlane) return;
    m_planes.assign(cell, id);
    stack.push_back(cell);
  };
  for (const TileCells& part : cells)
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(part.bits[static_cast<std::size_t>(iy)],
                 [&](std::int32_t ix)
                 {
                   tryCell({part.tile, ix, iy});
                   while (!stack.empty())
                   {
                     const CellRef cell = stack.back();
                     stack.pop_back();
                     for (const Step& step : kNeighbours)
                       tryCell(cellAt(*cell.tile, cell.ix + step.x, cell.iy + step.y));
                   }
                 });
}

/** Whether two planes differ by at most the tolerance where the smaller one's cells are. */
bool PlaneBorders::agree(std::int32_t a, std::int32_t b) const
{
  const PlaneState &first = m_planes.at(a), &second = m_planes.at(b);
  const PlaneMoments& cells =
      first.moments.cells() < second.moments.cells() ? first.moments : second.moments;
  return differenceOver(cells, first.plane, second.plane) <= m_search.tolerance;
}

void PlaneBorders::join(std::int32_t from, std::int32_t to)
{
  for (Tile* tile : tilesOf(from))
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(rowOfPlane(*tile, iy, from),
                 [&](std::int32_t ix) { tile->assign(Tile::indexOf(ix, iy), to); });
  PlaneState &source = m_planes.at(from), &target = m_planes.at(to);
  target.moments.add(source.moments);
  target.tiles.take(source.tiles);
  target.hasLost |= source.hasLost;
  target.plane = target.moments.fit();
  m_planes.remove(from);
}

bool PlaneBorders::merge(const std::vector<Unsettled>& where)
{
  const auto pairs = touchingPairs(where);
  std::vector<std::int32_t> now(static_cast<std::size_t>(m_planes.end()));
  std::iota(now.begin(), now.end(), 0);
  const auto numberOf = [&now](std::int32_t id)
  {
    while (now[static_cast<std::size_t>(id)] != id) id = now[static_cast<std::size_t>(id)];
    return id;
  };
  bool any = false;
  for (bool again = true; again;)
  {
    again = false;
    for (const auto& pair : pairs)
    {
      const std::int32_t a = numberOf(pair.first), b = numberOf(pair.second);
      if (a == b || !agree(a, b)) continue;
      const bool isFirstSmaller = m_planes.at(a).moments.cells() < m_planes.at(b).moments.cells();
      const std::int32_t from = isFirstSmaller ? a : b, to = isFirstSmaller ? b : a;
      join(from, to);
      now[static_cast<std::size_t>(from)] = to;
      any = again = true;
    }
  }
  return any;
}

/** The cells of a tile that are nearer to another plane. */
void PlaneBorders::findNearer(const Unsettled& part, std::vector<CellRef>& found) const
{
  Tile& tile = *part.tile;
  const auto look = [&](const TileBits& cells)
  {
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(cells[static_cast<std::size_t>(iy)],
                 [&](std::int32_t ix)
                 {
                   const CellRef cell{&tile, ix, iy};
                   if (nearest(cell) != tile.plane[cell.index()]) found.push_back(cell);
                 });
  };
  if (!part.meetings.empty) look(part.meetings.any);
  if (part.hasMovedPlane) look(freeBesidePlanes(tile));
}

bool PlaneBorders::moveToNearest(const CellRef& cell)
{
  if (!cell || !cell.tile->isKnown(cell.ix, cell.iy)) return false;
  const std::int32_t own = cell.tile->plane[cell.index()], best = nearest(cell);
  if (best == own) return false;
  if (own != kNoPlane) m_planes.release(cell);
  m_planes.assign(cell, best);
  return true;
}

bool PlaneBorders::relax(const std::vector<Unsettled>& where, int threads)
{
  std::vector<std::vector<CellRef>> found(where.size());
  grid::inParallel(where.size(), where.size() < kWorthThreads ? 1 : threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t i = begin; i < end; ++i) findNearer(where[i], found[i]);
                   });
  std::vector<CellRef> moved;
  for (const auto& ofTile : found)
    for (const CellRef& cell : ofTile)
      if (moveToNearest(cell)) moved.push_back(cell);
  const bool any = !moved.empty();
  while (!moved.empty())
  {
    const CellRef cell = moved.back();
    moved.pop_back();
    for (const Step& step : kNeighbours)
    {
      const CellRef next = cellAt(*cell.tile, cell.ix + step.x, cell.iy + step.y);
      if (moveToNearest(next)) moved.push_back(next);
    }
  }
  return any;
}

/** Where a plane has moved all cells count, else those that have changed and the ones beside. */
void PlaneBorders::findMeetings(Unsettled& part)
{
  const auto unsettled = [](const Tile& tile) -> const TileBits& { return tile.unsettled; };
  part.meetings = meetingsOf(*part.tile);
  if (!part.hasMovedPlane && !part.meetings.empty)
    part.meetings.keepOnly(besideBits(*part.tile, unsettled));
}

bool PlaneBorders::hasMoved(const PlaneState& state) const
{
  return differenceOver(state.moments, state.plane, state.settled) > kTie;
}

std::vector<PlaneBorders::Unsettled> PlaneBorders::takeUnsettled(int threads)
{
  std::vector<Tile*> unsettled;
  for (Tile* tile : m_tiles.sorted())
  {
    if (!tile->isUnsettled) continue;
    unsettled.push_back(tile);
    for (Tile* near : tile->around)
      if (near) near->isNearUnsettled = true;
  }
  for (std::int32_t id = 0; id < m_planes.end(); ++id)
  {
    PlaneState& state = m_planes.at(id);
    if (!state.isAlive || state.moments.cells() == 0 || !hasMoved(state)) continue;
    state.settled = state.plane;
    for (Tile* tile : tilesOf(id)) tile->hasMovedPlane = true;
  }
  std::vector<Unsettled> parts;
  for (Tile* tile : m_tiles.sorted())
  {
    if (!tile->isNearUnsettled && !tile->hasMovedPlane) continue;
    parts.push_back({tile, tile->hasMovedPlane});
    tile->isNearUnsettled = tile->hasMovedPlane = false;
  }
  grid::inParallel(parts.size(), parts.size() < kWorthThreads ? 1 : threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t i = begin; i < end; ++i) findMeetings(parts[i]);
                   });
  for (Tile* tile : unsettled)
  {
    tile->isUnsettled = false;
    tile->unsettled = {};
  }
  return parts;
}

void PlaneBorders::releaseAll(std::int32_t id, Freed& freed)
{
  for (Tile* tile : tilesOf(id))
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    {
      const RowBits row = rowOfPlane(*tile, iy, id);
      if (!row) continue;
      TileCells& cells = freed[{tile->ty, tile->tx}];
      cells.tile = tile;
      cells.bits[static_cast<std::size_t>(iy)] |= row;
      forEachBit(row, [&](std::int32_t ix) { tile->release(Tile::indexOf(ix, iy)); });
    }
  m_planes.remove(id);
}

/** Each connected part becomes a plane of its own; one that has half of the cells goes on as the
 * plane that it was. */
void PlaneBorders::split(std::int32_t id)
{
  std::unordered_map<const Tile*, TileBits> kept;
  const auto open = [&](const Tile& tile, std::int32_t iy)
  {
    const RowBits row = rowOfPlane(tile, iy, id);
    const auto found = kept.find(&tile);
    return found == kept.end() ? row : row & ~found->second[static_cast<std::size_t>(iy)];
  };
  for (Tile* tile : tilesOf(id))
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      while (const RowBits row = open(*tile, iy))
      {
        const CellRef first{tile, __builtin_ctz(row), iy};
        const std::int64_t cells = m_flood.from(first, open), all = m_planes.at(id).moments.cells();
        if (cells == all) return;
        if (kept.empty() && 2 * cells >= all)
          for (const Flood::Part& part : m_flood.parts()) kept.emplace(part.tile, part.reached);
        else
          carve(id, first);
      }
  if (m_planes.at(id).moments.cells() == 0) m_planes.remove(id);
}

/** Makes what the flood has reached a plane of its own. */
void PlaneBorders::carve(std::int32_t id, const CellRef& origin)
{
  const PlaneMoments moments = m_flood.moments(origin);
  m_flood.addPlane(moments, m_planes);
  m_planes.at(id).moments.subtract(moments);
  m_planes.at(id).hasChanged = true;
}

bool PlaneBorders::isPlane(const PlaneState& state) const
{
  const PlaneMoments& moments = state.moments;
  return moments.cells() >= m_search.minCells && moments.spans() &&
         moments.narrowness() >= kNearlyFilled * m_search.minWidth &&
         isAllowed(moments.fit(), m_search);
}

std::vector<TileCells> PlaneBorders::splitAndDissolve()
{
  for (std::int32_t id = 0; id < m_planes.end(); ++id)  // those that split off are connected
  {
    if (!m_planes.at(id).isAlive || !m_planes.at(id).hasLost) continue;
    m_planes.at(id).hasLost = false;
    split(id);
  }
  Freed freed;
  for (std::int32_t id = 0; id < m_planes.end(); ++id)
    if (m_planes.at(id).isAlive && !isPlane(m_planes.at(id))) releaseAll(id, freed);
  std::vector<TileCells> cells;
  cells.reserve(freed.size());
  for (const auto& entry : freed) cells.push_back(entry.second);
  return cells;
}

}  // namespace mrpt_mapconv::terrain
