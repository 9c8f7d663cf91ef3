#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/OpenColumns.h>

#include <algorithm>
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
  std::int32_t standing;     //!< what a robot drives over, if it stands on the ground [voxels]
  std::int32_t clearance;    //!< what it needs [voxels]
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
    return (floor + std::max(step, 2)) * line.n < line.timesN(k);
  }
  /** (b) and (c) for an open cell k with this floor. */
  bool supports(const SupportLine& line, std::int32_t k, std::int64_t floor) const
  {
    const std::int64_t height = line.timesN(k), n = line.n;
    const bool isShort = line.gapSq() <= maxHiddenSq;
    return height <= (floor + (isShort ? hiddenSlack : 1)) * n &&
           (isShort || isWithin(step, line, k, floor));
  }
  /** Whether a height at cell k is at most so many voxels above the line. */
  static bool isWithin(std::int32_t voxels, const SupportLine& line, std::int32_t k,
                       std::int64_t height)
  {
    return height * line.n <= line.timesN(k) + std::int64_t{voxels} * line.n;
  }
  /** Whether (e) may not hold, by the floor alone. */
  bool mayBeBlocked(const SupportLine& line, std::int32_t k, std::int64_t floor) const
  {
    return !isWithin(standing, line, k, floor) || floor * line.n < line.timesN(k);
  }
  /** Not (e): what is known to be occupied at cell k is in the robot's way. */
  bool isBlocked(const SupportLine& line, std::int32_t k, std::int64_t floor,
                 const OpenColumn& open) const
  {
    const bool stands =
        open.under != OpenColumn::kNone && !isWithin(standing, line, k, floor - open.under);
    const bool hangs =
        open.above != OpenColumn::kNone &&
        (floor + open.above) * line.n < line.timesN(k) + std::int64_t{clearance} * line.n;
    return stands || hangs;
  }
  /** How far over a floor things are looked for that may hang too low over a line [voxels]. */
  std::int32_t reachAbove() const { return clearance + hiddenSlack; }
};

}  // namespace mrpt_mapconv::freespace
