#pragma once

#include <map>
#include <utility>
#include <vector>

#include "PlaneGrowth.h"
#include "PlaneRows.h"

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

  /** A tile whose borders have to be looked at. */
  struct Unsettled
  {
    Tile* tile = nullptr;
    bool hasMovedPlane = false;  //!< a plane of it has other parameters
    PlaneMeetings meetings{};    //!< of cells that are looked at
  };
  /** The tiles in which cells were assigned or released since this was asked last, the ones around
   * them, and the ones of planes that have moved; row by row. \param threads 0 = all cores */
  std::vector<Unsettled> takeUnsettled(int threads);

  /** Merges planes that touch in these tiles and agree; those that have merged are refitted.
   * \return whether any did */
  bool merge(const std::vector<Unsettled>& where);

  /** Gives cells where planes meet to the plane that is nearer, of equally near ones to the less
   * steep, and goes on from there. Where a plane has moved, so it does with cells of none.
   * \param threads 0 = all cores \return whether any cell changed its plane */
  bool relax(const std::vector<Unsettled>& where, int threads);

  /** Splits planes that have lost cells and are not connected any more, and gives up what is too
   * small, or but a line. \return the cells that now have no plane, tiles row by row */
  std::vector<TileCells> splitAndDissolve();

  /** The tiles that a plane has cells in. */
  std::vector<Tile*> tilesOf(std::int32_t id) const;

 private:
  static void findMeetings(Unsettled& part);
  std::int32_t nearest(const CellRef& cell) const;
  void findNearer(const Unsettled& part, std::vector<CellRef>& found) const;
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
