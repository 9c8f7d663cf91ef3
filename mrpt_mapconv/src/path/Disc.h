#pragma once

#include <mrpt_mapconv/grid/GridFrame.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpt_mapconv::path
{
/** The cells that a sphere may reach: those whose square has a point within the sphere's radius of
 * its centre, on the frame and around it. */
class Disc
{
 public:
  /** Cells [kxBegin, kxEnd) of row ky. The sphere reaches up and down from its centre over cell
   * kxBegin + i by sqrt(max(0, restSq − dxSq[i])). */
  struct Row
  {
    std::int32_t ky, kxBegin, kxEnd;
    std::size_t index;   //!< counted from the lowest row
    double restSq;       //!< radius² less the row's distance² [m²]
    const double* dxSq;  //!< distances² in x [m²]
  };

  Disc(const grid::GridFrame& frame, double radius);

  double radius() const { return m_radius; }
  std::int32_t kxFirst() const { return m_kxFirst; }  //!< no row begins before this key
  /** How many cells it reaches at most beyond the one that holds its centre. */
  std::int32_t reach() const { return m_reach; }
  /** How many columns and rows it has at most. */
  std::size_t side() const { return m_dxSq.size(); }
  /** \param x,y the centre [m], in the frame's cell (kx, ky) */
  void moveTo(double x, double y, std::int32_t kx, std::int32_t ky);

  /** Calls visit(row) for each row, from the lowest y. */
  template <class Visit>
  void forEachRow(const Visit& visit) const
  {
    const auto centre = static_cast<std::size_t>(m_reach);
    std::size_t begin = centre, end = centre + 1;
    for (std::size_t row = 0; row < m_dySq.size(); ++row)
    {
      const double limit = m_limitSq - m_dySq[row];
      if (limit < 0) continue;
      // distances grow from the centre outwards, so the ends only move a little from row to row
      while (begin > 0 && m_dxSq[begin - 1] <= limit) --begin;
      while (end < m_dxSq.size() && m_dxSq[end] <= limit) ++end;
      while (m_dxSq[begin] > limit) ++begin;
      while (m_dxSq[end - 1] > limit) --end;
      visit(Row{m_kyFirst + static_cast<std::int32_t>(row),
                m_kxFirst + static_cast<std::int32_t>(begin),
                m_kxFirst + static_cast<std::int32_t>(end), row, m_radiusSq - m_dySq[row],
                m_dxSq.data() + begin});
    }
  }

 private:
  void setDistances(double x, std::int32_t key, std::vector<double>& squares) const;

  double m_resolution, m_radius, m_radiusSq, m_limitSq;
  std::int32_t m_reach;
  std::int32_t m_kxFirst = 0, m_kyFirst = 0;
  std::vector<double> m_dxSq, m_dySq;
};

}  // namespace mrpt_mapconv::path
