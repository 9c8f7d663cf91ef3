#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <vector>

namespace mrpt_mapconv::sim
{
/** Ways through rock, each with a vault over a line with corners. */
class Tunnels
{
 public:
  /** Reads arch_1 … arch_N (x y x y … [m], at least two points), archWidth and archHeight [m] (one
   * number for all or one for each), all or none.
   * \exception std::runtime_error naming section, key and value, and what would be right */
  static Tunnels read(params::StrictSection& section);

  bool empty() const { return m_tunnels.empty(); }
  /** Height of the highest vault over a place [m]; 0 where there is none. */
  double vaultAt(const mrpt::math::TPoint2D& place) const;

 private:
  struct Tunnel
  {
    std::vector<mrpt::math::TPoint2D> line;
    double width = 0, height = 0;
  };
  std::vector<Tunnel> m_tunnels;
};

}  // namespace mrpt_mapconv::sim
