#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "Flood.h"
#include "PlaneSet.h"
#include "SeedPlane.h"
#include "TileMap.h"

namespace mrpt_mapconv::terrain
{
/** Grows new planes from cells without one.
 *
 * All seeds are tried twice: first with half of the tolerance, which only finds what is flat; such
 * planes are then grown with all of it. Heights that are mixed of two levels, as those at a riser
 * are, would else make steep planes of their own before the levels are found, and take cells of
 * these.
 *
 * Seeds are tried one after the other, but most of them, in rubble, find nothing. So threads look
 * ahead: they try the next seeds as if none of them found a plane, and the more, the longer that
 * was so. What a plane may have changed since is tried again; the result is that of one thread. */
class PlaneGrowth
{
 public:
  PlaneGrowth(const PlaneSearch& search, TileMap& tiles) : m_search(search), m_flood(tiles) {}

  /** Tries all seeds that have no plane, in the order of their keys, row by row.
   * \param seeds of tiles row by row \param threads 0 = all cores */
  void grow(const std::vector<TileCells>& seeds, PlaneSet& planes, int threads);

 private:
  /** A rectangle of keys. */
  struct KeyBox
  {
    std::int32_t xMin, yMin, xMax, yMax;
  };

  void growWith(double tolerance, const std::vector<TileCells>& seeds, PlaneSet& planes,
                int threads);
  bool growFrom(const CellRef& seed, PlaneSet& planes);
  bool flood(const CellRef& seed, const Plane& plane, double tolerance);
  bool isFlat(const PlaneMoments& moments) const;
  bool isWide(const PlaneMoments& moments) const;
  void reject();
  bool isRejected(const CellRef& seed) const;

  void lookAhead(const std::vector<CellRef>& seeds, int threads);
  bool isStillHopeless(const CellRef& seed, std::size_t index) const;
  KeyBox reachedBox() const;

  PlaneSearch m_search;
  PlaneSearch m_now;                     //!< with the tolerance of now
  std::optional<SeedPlane> m_seedPlane;  //!< likewise
  Flood m_flood;
  std::unordered_map<const Tile*, TileBits> m_rejected;
  std::vector<char> m_hopeless;  //!< of the seeds that were looked at: they find no plane
  std::vector<KeyBox> m_grown;   //!< what planes have taken since
};

}  // namespace mrpt_mapconv::terrain
