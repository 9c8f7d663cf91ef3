#include "Terraces.h"

#include <cmath>

#include "Random.h"
#include "SectionKeys.h"

namespace mrpt_mapconv::sim
{
Terraces Terraces::read(params::StrictSection& section, std::uint32_t seed)
{
  Terraces terraces;
  terraces.m_seed = seed;
  if (!section.has("terraces"))
  {
    if (section.has("terraceTilt")) section.fail("terraceTilt", "left out without terraces");
    return terraces;
  }
  const Interval rise = readInterval(section, "terraces");
  terraces.m_low = rise.low;
  terraces.m_high = rise.high;
  terraces.m_tilt = readShare(section, "terraceTilt");
  return terraces;
}

double Terraces::edgeOf(std::int64_t terrace) const
{
  // from a regular edge at most half of what rises may differ by, so that none is beyond its limits
  const double shift =
      Random(randomKey(m_seed, "terrace", static_cast<std::uint64_t>(terrace))).uniform() - 0.5;
  return (m_low + m_high) / 2 * static_cast<double>(terrace) + (m_high - m_low) / 2 * shift;
}

double Terraces::heightAt(double smooth) const
{
  if (m_high == 0) return smooth;
  auto terrace = std::llround(smooth / ((m_low + m_high) / 2));
  if (edgeOf(terrace) > smooth) --terrace;
  const double edge = edgeOf(terrace);
  return edge + m_tilt * (smooth - edge);
}

}  // namespace mrpt_mapconv::sim
