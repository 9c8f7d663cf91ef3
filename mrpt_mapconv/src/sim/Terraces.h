#pragma once

#include <mrpt_mapconv/params/StrictSection.h>

#include <cstdint>

namespace mrpt_mapconv::sim
{
/** Ground that rises by steps, where it would be smooth. */
class Terraces
{
 public:
  /** Reads terraces (lowest and highest rise from one to the next [m]; none without) and
   * terraceTilt (share of it that they rise themselves before their step, 0 … 1, default 0).
   * \exception std::runtime_error naming section, key and value, and what would be right */
  static Terraces read(params::StrictSection& section, std::uint32_t seed);

  /** \param smooth height without steps [m] */
  double heightAt(double smooth) const;

 private:
  double edgeOf(std::int64_t terrace) const;  //!< where it begins [m]

  double m_low = 0, m_high = 0, m_tilt = 0;
  std::uint64_t m_seed = 0;
};

}  // namespace mrpt_mapconv::sim
