#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>

#include <cstdint>

namespace mrpt_mapconv::freespace
{
/** A support is kept in 64ths of a voxel, so that sums over supports are exact. */
constexpr std::int32_t kSupportUnits = 64;

/** The straight line between the supports of two seen cells on an axis. Cell k of it is k steps
 * from the first; the second is cell n. Heights are voxel keys. */
struct SupportLine
{
  std::int32_t x, y;           //!< of the first cell
  std::int32_t dx, dy;         //!< one step
  std::int32_t n;              //!< steps to the second cell
  std::int64_t first, second;  //!< their supports [voxels]

  /** Height at cell k, times n [voxels]. */
  std::int64_t timesN(std::int32_t k) const { return first * n + (second - first) * k; }
  /** The same in 64ths of a voxel, halves rounded up. */
  std::int32_t unitsAt(std::int32_t k) const
  {
    const std::int64_t twice = 2 * kSupportUnits * timesN(k) + n, by = 2 * std::int64_t{n};
    return static_cast<std::int32_t>(twice >= 0 ? twice / by : -((-twice + by - 1) / by));
  }
  /** Square of the distance between its ends [cells²]. */
  std::int32_t gapSq() const { return n * n * (dx != 0 && dy != 0 ? 2 : 1); }
};

/** When a line between seen cells says where the ground of an open cell lies: the clauses (a) to
 * (e) of ConversionParams::maxGap, in whole numbers. */
struct SupportRules
{
  std::int32_t step;         //!< h: the highest difference that is no step [voxels]
  std::int32_t hiddenSlack;  //!< how far lines over short gaps may be above a floor [voxels]
  std::int32_t maxGapSq;     //!< [cells²]
  std::int32_t maxHiddenSq;  //!< likewise, where something may hide
  std::int32_t reach;        //!< no line is longer, in cells of either axis

  SupportRules(const ConversionParams& params, double resolution);

  /** (a), and that the gap is not too long for any cell. */
  bool allows(const SupportLine& line) const
  {
    const std::int64_t rise = line.second - line.first;
    return rise <= step && rise >= -step && line.gapSq() <= maxGapSq;
  }
  /** Not (d): an open cell k with this floor shows that the ground lies lower. */
  bool refutes(const SupportLine& line, std::int32_t k, std::int64_t floor) const
  {
    return floor * line.n < line.timesN(k) - 2 * std::int64_t{line.n};
  }
  /** (b) and (c) for an open cell k with this floor. */
  bool supports(const SupportLine& line, std::int32_t k, std::int64_t floor) const
  {
    const std::int64_t height = line.timesN(k), n = line.n;
    const bool isShort = line.gapSq() <= maxHiddenSq;
    return height <= (floor + (isShort ? hiddenSlack : 1)) * n &&
           (isShort || isStepAtMost(line, k, floor));
  }
  /** Whether what stands up to this height at cell k is no more than a step: (e) for its hidden
   * top, and always so if it holds for the floor. */
  bool isStepAtMost(const SupportLine& line, std::int32_t k, std::int64_t top) const
  {
    return top * line.n <= line.timesN(k) + std::int64_t{step} * line.n;
  }
};

}  // namespace mrpt_mapconv::freespace
