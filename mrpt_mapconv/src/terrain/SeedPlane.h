#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "Tile.h"

namespace mrpt_mapconv::terrain
{
/** How planes are looked for, in units of cells and of kHeightUnit. */
struct PlaneSearch
{
  double tolerance = 0;         //!< d [kHeightUnit]
  double mostSlope = 0;         //!< [kHeightUnit per cell]
  std::int32_t window = 1;      //!< half its side [cells], at most kTileSide
  std::int32_t hypotheses = 1;  //!< K
  std::int32_t blockCells = 1;  //!< B
  std::int32_t minCells = 3;
  std::int32_t minWidth = 1;  //!< [cells], at most kTileSide
};

/** Whether a plane is at most as steep as is allowed. */
inline bool isAllowed(const Plane& plane, const PlaneSearch& search)
{
  return plane.slopeX * plane.slopeX + plane.slopeY * plane.slopeY <=
         search.mostSlope * search.mostSlope;
}

/** Preemptive RANSAC (Nistér 2003) for the plane of one cell.
 *
 * The window is the square of cells around the seed. Cells are drawn from it at random, again and
 * again; those that belong to a plane already, or are not known, are passed over. Each two that
 * remain, of 2 K at most, make a hypothesis, the plane through the seed and them, unless the three
 * lie on one line or the plane is too steep. The k ≤ K hypotheses are scored, Σ max(0, d −
 * |vertical difference|), on blocks of B more draws; after i draws max(1, ⌊k·2^(−⌊i/B⌋)⌋) remain,
 * of equally good ones the first. All that is random follows from the seed's key. */
class SeedPlane
{
 public:
  explicit SeedPlane(const PlaneSearch& search);
  /** \param seed a cell without a plane; only if it is promising() */
  std::optional<Plane> find(const CellRef& seed);
  /** Whether it is worth it: a plane that is wide enough has cells with most of their 8 neighbours
   * in it, and these differ from the cell by no more than the steepest plane and the tolerance. */
  bool isPromising(const CellRef& seed) const;

  static constexpr std::size_t kMostHypotheses = 64;

 private:
  /** Cells of the window, from the seed on. */
  struct Drawn
  {
    std::array<float, 2 * kMostHypotheses> dx{}, dy{}, dz{};
  };

  std::uint64_t random();
  std::size_t draw(const CellRef& seed, std::size_t count, std::size_t cells, Drawn& out);
  std::size_t makeHypotheses(const CellRef& seed);
  void findWinner(const CellRef& seed, std::size_t hypotheses);
  std::size_t keepBest(std::size_t hypotheses, std::size_t kept);

  PlaneSearch m_search;
  double m_besideReach, m_diagonalReach;  //!< such differences [kHeightUnit]
  std::uint64_t m_random = 0;
  /** A place in the window. */
  struct Place
  {
    float dx, dy;
    std::int16_t flat;  //!< dx + dy·kTileSide
    std::int8_t ix, iy;
  };
  bool isWithinTile(const CellRef& seed) const;
  std::shared_ptr<const std::vector<Place>> m_places;  //!< of all copies
  Drawn m_drawn;
  std::array<float, kMostHypotheses> m_gx{}, m_gy{}, m_score{};
};

}  // namespace mrpt_mapconv::terrain
