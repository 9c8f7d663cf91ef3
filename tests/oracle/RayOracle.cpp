#include "RayOracle.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace mrpt_mapconv::oracle
{
using voxel::GridRay;
using voxel::VoxelKey;

namespace
{
__extension__ using Wide = __int128;

constexpr std::int64_t kUnits = 256;  // of a voxel

std::int64_t keyOf(std::int64_t units)
{
  std::int64_t key = units / kUnits;
  while (key * kUnits > units) --key;
  return key;
}

/** A share of a ray, exactly. */
struct Share
{
  Wide numerator, denominator = 1;  // > 0
  bool operator<(const Share& o) const
  {
    return numerator * o.denominator < o.numerator * denominator;
  }
};

/** When a ray crosses a face. */
struct Crossing
{
  Share when;
  bool isDown = false;
  std::size_t axis = 0;

  bool operator<(const Crossing& o) const
  {
    if (when < o.when || o.when < when) return when < o.when;
    return std::tie(isDown, axis) < std::tie(o.isDown, o.axis);
  }
};
const Crossing kBeforeAll{{-1}}, kAfterAll{{2}};

/** From when to when a ray is between two keys' faces on one axis; it never is if `until` is not
 * later. */
struct Stay
{
  Crossing from = kBeforeAll, until = kAfterAll;
};

Stay stayOn(const GridRay& ray, std::size_t axis, std::int64_t key)
{
  const std::int64_t begin = ray.from[axis], end = ray.to[axis];
  const std::int64_t first = keyOf(begin), last = keyOf(end);
  if (key < std::min(first, last) || key > std::max(first, last)) return {kAfterAll, kBeforeAll};
  const bool isDown = end < begin;
  const auto crossingOf = [&](std::int64_t face)
  {
    const Wide to = face * kUnits - begin, all = end - begin;
    return Crossing{isDown ? Share{-to, -all} : Share{to, all}, isDown, axis};
  };
  Stay stay;
  if (key != first) stay.from = crossingOf(isDown ? key + 1 : key);
  if (key != last) stay.until = crossingOf(isDown ? key : key + 1);
  return stay;
}

std::vector<Stay> staysOn(const GridRay& ray, std::size_t axis, const KeyBox& box)
{
  std::vector<Stay> stays;
  for (std::int64_t key = box.low[axis]; key <= box.high[axis]; ++key)
    stays.push_back(stayOn(ray, axis, key));
  return stays;
}

VoxelKey voxelAt(std::int64_t x, std::int64_t y, std::int64_t z)
{
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)};
}

/** A part of a ray, with or without its ends. */
struct Part
{
  Share from{0}, until{1};
  bool hasFrom = true, hasUntil = true;

  void startAt(const Share& share, bool included)
  {
    if (share < from) return;
    hasFrom = from < share ? included : hasFrom && included;
    from = share;
  }
  void endAt(const Share& share, bool included)
  {
    if (until < share) return;
    hasUntil = share < until ? included : hasUntil && included;
    until = share;
  }
  bool isEmpty() const { return until < from || (!(from < until) && !(hasFrom && hasUntil)); }
};

/** \param closed whether upper faces are part of a voxel */
bool meets(const GridRay& ray, const VoxelKey& voxel, bool closed)
{
  const std::array<std::int64_t, 3> keys{voxel.x, voxel.y, voxel.z};
  Part part;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Wide below = keys[i] * kUnits - ray.from[i], above = below + kUnits;
    const Wide along = ray.to[i] - ray.from[i];
    if (along > 0)
    {
      part.startAt({below, along}, true);
      part.endAt({above, along}, closed);
    }
    else if (along < 0)
    {
      part.startAt({-above, -along}, closed);
      part.endAt({-below, -along}, true);
    }
    else if (below > 0 || above < 0 || (above == 0 && !closed))
      return false;
  }
  return !part.isEmpty();
}
}  // namespace

KeyBox boxOf(const GridRay& ray)
{
  KeyBox box;
  for (std::size_t i = 0; i < 3; ++i)
    std::tie(box.low[i], box.high[i]) = std::minmax({keyOf(ray.from[i]), keyOf(ray.to[i])});
  return box;
}

std::vector<VoxelKey> voxelsOnRay(const GridRay& ray, const KeyBox& box)
{
  const auto xs = staysOn(ray, 0, box), ys = staysOn(ray, 1, box), zs = staysOn(ray, 2, box);
  std::vector<std::pair<Crossing, VoxelKey>> visits;
  for (std::size_t x = 0; x < xs.size(); ++x)
    for (std::size_t y = 0; y < ys.size(); ++y)
      for (std::size_t z = 0; z < zs.size(); ++z)
      {
        const Crossing from = std::max({xs[x].from, ys[y].from, zs[z].from});
        const Crossing until = std::min({xs[x].until, ys[y].until, zs[z].until});
        if (from < until)
          visits.emplace_back(from, voxelAt(box.low[0] + static_cast<std::int64_t>(x),
                                            box.low[1] + static_cast<std::int64_t>(y),
                                            box.low[2] + static_cast<std::int64_t>(z)));
      }
  std::sort(visits.begin(), visits.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<VoxelKey> voxels;
  for (const auto& visit : visits) voxels.push_back(visit.second);
  return voxels;
}

bool holdsPointOf(const GridRay& ray, const VoxelKey& voxel) { return meets(ray, voxel, false); }

bool touches(const GridRay& ray, const VoxelKey& voxel) { return meets(ray, voxel, true); }

}  // namespace mrpt_mapconv::oracle
