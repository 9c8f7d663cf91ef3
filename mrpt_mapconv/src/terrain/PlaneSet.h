#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "Tile.h"

namespace mrpt_mapconv::terrain
{
/** A rectangle of tiles that holds all cells of a plane, and perhaps more. */
struct TileBox
{
  std::int32_t xMin = 0, yMin = 0, xMax = -1, yMax = -1;

  void take(const Tile& tile) { take({tile.tx, tile.ty, tile.tx, tile.ty}); }
  void take(const TileBox& o)
  {
    if (o.xMax < o.xMin) return;
    if (xMax < xMin)
    {
      *this = o;
      return;
    }
    xMin = std::min(xMin, o.xMin);
    yMin = std::min(yMin, o.yMin);
    xMax = std::max(xMax, o.xMax);
    yMax = std::max(yMax, o.yMax);
  }
};

/** Heights, and distances to planes, that differ by less are the same: they are rounded
 * [kHeightUnit]. */
constexpr std::int32_t kSameHeight = 8;

struct PlaneState
{
  PlaneMoments moments;
  Plane plane;    //!< moments.fit(), as of the last refit
  Plane settled;  //!< as its borders know it
  TileBox tiles;
  bool isAlive = false;
  bool hasChanged = false;  //!< its moments, since the last refit
  bool hasLost = false;     //!< cells, since it was last known to be connected
};

/** Whether a plane stays connected if it loses this cell, as far as the 8 cells around it tell. */
bool isDispensable(const CellRef& cell);

/** The planes by their numbers; those of planes that are no more are used again. */
class PlaneSet
{
 public:
  std::int32_t add(const PlaneMoments& moments)
  {
    std::int32_t id;
    if (m_free.empty())
    {
      id = static_cast<std::int32_t>(m_states.size());
      m_states.emplace_back();
    }
    else
    {
      id = m_free.back();
      m_free.pop_back();
    }
    PlaneState& state = at(id);
    state = {};
    state.moments = moments;
    if (moments.spans()) state.plane = moments.fit();
    state.isAlive = true;
    return id;
  }
  void remove(std::int32_t id)
  {
    at(id) = {};
    m_free.push_back(id);
  }
  void clear()
  {
    m_states.clear();
    m_free.clear();
  }

  PlaneState& at(std::int32_t id) { return m_states[static_cast<std::size_t>(id)]; }
  const PlaneState& at(std::int32_t id) const { return m_states[static_cast<std::size_t>(id)]; }
  std::int32_t end() const { return static_cast<std::int32_t>(m_states.size()); }

  const std::vector<std::int32_t>& freeNumbers() const { return m_free; }
  /** Planes with their numbers, and those that are free, as another set had them. */
  void restore(std::vector<PlaneState> states, std::vector<std::int32_t> freeNumbers)
  {
    m_states = std::move(states);
    m_free = std::move(freeNumbers);
  }

  /** Gives a cell to a plane. */
  void assign(const CellRef& cell, std::int32_t id)
  {
    PlaneState& state = at(id);
    state.moments.add(cell.keyX(), cell.keyY(), cell.tile->height[cell.index()]);
    state.tiles.take(*cell.tile);
    state.hasChanged = true;
    cell.tile->assign(cell.index(), id);
  }
  /** Takes a cell from its plane. */
  void release(const CellRef& cell)
  {
    PlaneState& state = at(cell.tile->plane[cell.index()]);
    state.moments.remove(cell.keyX(), cell.keyY(), cell.tile->height[cell.index()]);
    state.hasChanged = true;
    state.hasLost |= !isDispensable(cell);
    cell.tile->release(cell.index());
  }
  /** Gives a cell another height; it leaves its plane if it is then further away. */
  void setHeight(const CellRef& cell, std::int32_t z, double tolerance)
  {
    std::int32_t& height = cell.tile->height[cell.index()];
    const std::int32_t id = cell.tile->plane[cell.index()];
    if (id == kNoPlane || z == height)
    {
      height = z;
      return;
    }
    PlaneState& state = at(id);
    const std::int32_t kx = cell.keyX(), ky = cell.keyY();
    state.moments.remove(kx, ky, height);
    state.hasChanged = true;
    if (std::abs(std::int64_t{z} - height) > kSameHeight) cell.tile->unsettle(cell.index());
    height = z;
    state.moments.add(kx, ky, z);
    if (distance(cell, id) > tolerance) release(cell);
  }
  /** Vertical difference of a cell to a plane [kHeightUnit]. */
  double distance(const CellRef& cell, std::int32_t id) const
  {
    return std::abs(static_cast<double>(cell.tile->height[cell.index()]) -
                    at(id).plane.at(cell.keyX(), cell.keyY()));
  }
  /** Refits what has changed; planes without enough cells, or all on one line, stay as they are. */
  void refit(std::int64_t minCells)
  {
    for (PlaneState& state : m_states)
    {
      if (!state.isAlive || !state.hasChanged) continue;
      state.hasChanged = false;
      if (state.moments.cells() >= minCells && state.moments.spans())
        state.plane = state.moments.fit();
    }
  }

 private:
  std::vector<PlaneState> m_states;
  std::vector<std::int32_t> m_free;
};

}  // namespace mrpt_mapconv::terrain
