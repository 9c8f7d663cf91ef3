#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>
#include <mrpt_mapconv/scan/ScanProfile.h>

#include <cstdint>

namespace mrpt_mapconv::scan
{
/** What an occupied or a free cell of a profile is worth, as probabilities of occupancy.
 *
 * The defaults are measured ones (share/doc/results.md): of the pairs with which nothing of people
 * who walked through a simulated office was left after ten scans had seen a cell free, these gave
 * the best map: the more a free cell counts, the more of what a lidar's beams touch only now and
 * then is lost. A cell that is as occupied as can be takes 19 scans to be free again; with 0.9 and
 * 0.4 it is ten. */
struct UpdateParams
{
  double pHit = 0.7;                //!< of a cell that a scan says is occupied, above 0.5
  double pMiss = 0.45;              //!< of one that a scan says is free, below 0.5
  double pMin = 0.03, pMax = 0.97;  //!< cells are kept within these; around 0.5

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("pHit", p.pHit, "", "probability that stands for an occupied cell of a scan, above 0.5");
    v("pMiss", p.pMiss, "", "probability that stands for a free cell of a scan, below 0.5");
    v("pMin", p.pMin, "", "lowest probability of a cell");
    v("pMax", p.pMax, "", "highest probability of a cell");
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const;
};

/** Bayes' update of MRPT's 8-bit cells (eq. 4 of Mora et al. 2024).
 *
 * Cells count log-odds of being *free* in sixteenths, 0 is p = 0.5. An occupied cell is lowered by
 * hit() = round(16·ln(pHit/(1−pHit))), a free one raised by miss() =
 * −round(16·ln(pMiss/(1−pMiss))); then it is kept within [lowest(), highest()], the outermost units
 * whose probability is within [pMin, pMax]. A cell that already lies beyond is not moved towards
 * the middle by that. */
class LogOddsUpdate
{
 public:
  /** \exception std::invalid_argument for bad parameters, or such that change no cell */
  explicit LogOddsUpdate(const UpdateParams& params = {});

  int hit() const { return m_hit; }          //!< 14 by default
  int miss() const { return m_miss; }        //!< 3 by default
  int lowest() const { return m_lowest; }    //!< −55 by default
  int highest() const { return m_highest; }  //!< 55 by default

  /** Updates each cell of a profile once.
   * \param frame of the grid, of the same resolution; must hold profile.bounds()
   * \param cells of the grid, row by row from the lowest y
   * \exception std::invalid_argument if the frame does not hold them; no cell is changed then */
  void apply(const ScanProfile& profile, const grid::GridFrame& frame, std::int8_t* cells) const;

 private:
  int m_hit, m_miss, m_lowest, m_highest;
};

}  // namespace mrpt_mapconv::scan
