#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include "Noise.h"

namespace mrpt_mapconv::sim
{
/** A key for Random: other seeds, streams (whose noise it is) and indices give independent numbers.
 */
constexpr std::uint64_t randomKey(std::uint64_t seed, std::string_view stream, std::uint64_t index)
{
  std::uint64_t key = mixBits(seed);
  for (const char c : stream) key = mixBits(key ^ static_cast<unsigned char>(c));
  return mixBits(mixBits(key) ^ index);
}

/** Random numbers that depend on a key alone, not on what was drawn elsewhere before; and not on
 * the standard library, whose distributions differ between implementations. */
class Random
{
 public:
  explicit Random(std::uint64_t key) : m_state(key) {}

  /** In [0, 1). */
  double uniform()
  {
    m_state += 0x9E3779B97F4A7C15u;
    return static_cast<double>(mixBits(m_state) >> 11) * 0x1p-53;
  }

  /** Of mean 0 and standard deviation 1 (Box and Muller 1958, eq. 1). */
  double normal()
  {
    constexpr double kTwoPi = 6.283185307179586;
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(kTwoPi * uniform());
  }

 private:
  std::uint64_t m_state;
};

}  // namespace mrpt_mapconv::sim
