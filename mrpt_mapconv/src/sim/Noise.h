#pragma once

#include <cstdint>

namespace mrpt_mapconv::sim
{
/** Well mixed 64 bits from 64 bits (the finalizer of SplitMix64). */
constexpr std::uint64_t mixBits(std::uint64_t v)
{
  v += 0x9E3779B97F4A7C15u;
  v = (v ^ (v >> 30)) * 0xBF58476D1CE4E5B9u;
  v = (v ^ (v >> 27)) * 0x94D049BB133111EBu;
  return v ^ (v >> 31);
}

/** The same random bits for the same seed and place. */
constexpr std::uint64_t hashAt(std::uint64_t seed, std::int32_t x, std::int32_t y)
{
  return mixBits(mixBits(seed ^ static_cast<std::uint32_t>(x)) ^ static_cast<std::uint32_t>(y));
}

/** A die whose throws only depend on its seed; the standard library's distributions differ between
 * implementations. */
class Dice
{
 public:
  explicit Dice(std::uint64_t seed) : m_state(seed) {}
  /** A whole number in [low, high]. */
  std::int32_t operator()(std::int32_t low, std::int32_t high)
  {
    m_state = mixBits(m_state);
    const auto count = static_cast<std::uint64_t>(std::int64_t(high) - low + 1);
    return static_cast<std::int32_t>(low + static_cast<std::int64_t>(m_state % count));
  }

 private:
  std::uint64_t m_state;
};

/** Smooth noise on integer cells: random values on a coarse lattice, blended between its points.
 * Integers only, so that it gives the same bits everywhere. */
class ValueNoise
{
 public:
  static constexpr std::int64_t kOne = 1 << 16;

  /** \param period distance of lattice points [cells], ≥ 1 */
  ValueNoise(std::uint64_t seed, std::int32_t period) : m_seed(mixBits(seed)), m_period(period) {}

  /** In [0, kOne). */
  std::int64_t operator()(std::int32_t x, std::int32_t y) const
  {
    const std::int32_t ix = floorDivide(x), iy = floorDivide(y);
    const std::int64_t tx = blend(x - ix * m_period), ty = blend(y - iy * m_period);
    const std::int64_t low = between(value(ix, iy), value(ix + 1, iy), tx);
    const std::int64_t high = between(value(ix, iy + 1), value(ix + 1, iy + 1), tx);
    return between(low, high, ty);
  }

 private:
  std::int32_t floorDivide(std::int32_t v) const
  {
    return v >= 0 ? v / m_period : -((m_period - 1 - v) / m_period);
  }
  /** 3t² − 2t³, which leaves the lattice points without a crease. */
  std::int64_t blend(std::int32_t offset) const
  {
    const std::int64_t t = offset * kOne / m_period;
    return t * t / kOne * (3 * kOne - 2 * t) / kOne;
  }
  std::int64_t value(std::int32_t ix, std::int32_t iy) const
  {
    return static_cast<std::int64_t>(hashAt(m_seed, ix, iy) & (kOne - 1));
  }
  static std::int64_t between(std::int64_t a, std::int64_t b, std::int64_t t)
  {
    return a + (b - a) * t / kOne;
  }

  std::uint64_t m_seed;
  std::int32_t m_period;
};

}  // namespace mrpt_mapconv::sim
