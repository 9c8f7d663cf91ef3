#pragma once

#include <map>
#include <utility>
#include <vector>

#include "PlaneGrowth.h"

namespace mrpt_mapconv::terrain
{
/** What happens where planes meet. All of it changes assignments only; PlaneSet::refit() has to
 * follow. */
class PlaneBorders
{
 public:
  PlaneBorders(const PlaneSearch& search, TileMap& tiles, PlaneSet& planes)
      : m_search(search), m_tiles(tiles), m_planes(planes), m_flood(tiles)
  {
  }

  /** Gives cells without a plane, beginning with these, to the nearest plane of a neighbour within
   * the tolerance, and goes on from there. */
  void absorb(const std::vector<TileCells>& cells);

  /** Merges planes that touch in these tiles and agree; those that have merged are refitted.
   * \return whether any did */
  bool merge(const std::vector<Tile*>& where);

  /** Gives cells at a border to the plane that is nearer; of equally near ones to the less steep;
   * and so on behind cells that have moved.
   * \return the tiles in which any cell changed its plane */
  std::vector<Tile*> relax(const std::vector<Tile*>& where);

  /** Splits planes that have lost cells and are not connected any more, and gives up what is too
   * small, or but a line. \return the cells that now have no plane, tiles row by row */
  std::vector<TileCells> splitAndDissolve();

  /** Those tiles, the ones around them, and the ones of planes that have moved since they were
   * settled; row by row. */
  std::vector<Tile*> toSettle(const std::vector<Tile*>& changed);
  /** The tiles that a plane has cells in. */
  std::vector<Tile*> tilesOf(std::int32_t id) const;

 private:
  std::int32_t nearest(const CellRef& cell) const;
  bool moveToNearest(const CellRef& cell);
  bool prefers(std::int32_t a, std::int32_t b) const;
  bool agree(std::int32_t a, std::int32_t b) const;
  bool hasMoved(const PlaneState& state) const;
  void join(std::int32_t from, std::int32_t to);
  void split(std::int32_t id);
  void carve(std::int32_t id, const CellRef& origin);
  bool isPlane(const PlaneState& state) const;
  using Freed = std::map<std::pair<std::int32_t, std::int32_t>, TileCells>;  //!< by ty, tx
  void releaseAll(std::int32_t id, Freed& freed);

  const PlaneSearch& m_search;
  TileMap& m_tiles;
  PlaneSet& m_planes;
  Flood m_flood;
};

}  // namespace mrpt_mapconv::terrain
