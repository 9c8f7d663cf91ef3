#pragma once

#include <array>
#include <optional>

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
};

/** Whether a plane is at most as steep as is allowed. */
inline bool isAllowed(const Plane& plane, const PlaneSearch& search)
{
  return plane.slopeX * plane.slopeX + plane.slopeY * plane.slopeY <=
         search.mostSlope * search.mostSlope;
}

/** Preemptive RANSAC (Nistér 2003) for the plane of one cell.
 *
 * The window is the square of cells around the seed that belong to no plane. Hypotheses are planes
 * through the seed and two other cells of the window, not on one line and not too steep. They are
 * scored, Σ max(0, d − |vertical difference|), on cells of the window in random order; after i
 * cells max(1, ⌊K·2^(−⌊i/B⌋)⌋) remain. All that is random follows from the seed's key. */
class SeedPlane
{
 public:
  explicit SeedPlane(const PlaneSearch& search) : m_search(search) {}
  /** \param seed a cell without a plane */
  std::optional<Plane> find(const CellRef& seed);

 private:
  static constexpr std::size_t kMostCells = 128;  //!< of a window that are looked at
  static constexpr std::size_t kMost = 64;        //!< hypotheses

  void collectAll(const CellRef& seed);
  void draw(const CellRef& seed);
  void take(const CellRef& seed, std::int32_t dx, std::int32_t dy);
  std::size_t makeHypotheses();
  std::size_t winner(std::size_t hypotheses);
  std::size_t keepBest(std::size_t hypotheses, std::size_t kept);
  std::uint64_t random();
  std::size_t below(std::size_t n) { return static_cast<std::size_t>((random() >> 32) * n >> 32); }

  PlaneSearch m_search;
  std::uint64_t m_random = 0;
  std::size_t m_cells = 0;  //!< of the window, but the seed
  std::array<float, kMostCells> m_dx, m_dy, m_dz;
  std::array<float, kMost> m_gx, m_gy, m_score;
};

}  // namespace mrpt_mapconv::terrain
