#pragma once

#include <mrpt_mapconv/voxel/RegionTable.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpt_mapconv::voxel
{
/** A ray with its ends in units of 1/256 voxel (kRayUnits): exact, whatever its direction. */
struct GridRay
{
  std::array<std::int64_t, 3> from{}, to{};
};
constexpr std::int32_t kRayBits = 8;
constexpr std::int64_t kRayUnits = std::int64_t{1} << kRayBits;

/** The keys of a ray's voxels in the order in which walkRay() comes to them, the last one included.
 * \exception std::length_error for a ray of more than a hundred million voxels */
std::vector<VoxelKey> voxelsOnRay(const GridRay& ray);

/** All voxels whose keys on one axis are within [begin, end), which are multiples of kBrickSide. */
struct Slab
{
  int axis = 0;
  std::int64_t begin = INT64_MIN, end = INT64_MAX;
};

/** Where a walk is, packed such that a step is one addition: a position is the index of a voxel in
 * its brick (or of a brick in its region) and how far it is on each axis, in the direction of the
 * walk, from the side at which the walk comes in. */
class BrickCursor
{
 public:
  using Position = std::uint64_t;

  /** \param negative axes on which the walk goes down */
  BrickCursor(const VoxelKey& voxel, const std::array<bool, 3>& negative)
      : m_negative(negative), m_region(regionKey(voxel))
  {
    constexpr std::array<std::int64_t, 3> strides{kBrickColumns, kBrickSide, 1},
        brickStrides{kRegionSide * kRegionSide, kRegionSide, 1};
    for (std::size_t i = 0; i < 3; ++i)
    {
      m_step[i] = stepOf(negative[i] ? -strides[i] : strides[i], i);
      m_brickStep[i] = stepOf(negative[i] ? -brickStrides[i] : brickStrides[i], i);
    }
    m_voxel = positionOf(voxel);
    m_brick = static_cast<Position>(brickIndex(voxel)) << 32 |
              counters({voxel.x >> kBrickBits, voxel.y >> kBrickBits, voxel.z >> kBrickBits},
                       kRegionSide - 1);
  }

  /** What a step on an axis adds to the position. */
  Position step(int axis) const { return m_step[static_cast<std::size_t>(axis)]; }
  Position position() const { return m_voxel; }
  /** That of a voxel in its brick, as this walk would come to it. */
  Position positionOf(const VoxelKey& voxel) const
  {
    return static_cast<Position>(voxelIndex(voxel)) << 32 | counters(voxel, kBrickSide - 1);
  }
  static std::size_t indexIn(Position position) { return position >> 32; }
  static bool isOutside(Position position) { return (position & kVoxelGuards) != 0; }

  /** The walk has come to `position`, outside of its brick: goes on to the next one.
   * \return whether that is in another region */
  bool enterNext(Position position)
  {
    const auto axis = static_cast<std::size_t>(__builtin_ctzll(position & kVoxelGuards)) >> 3;
    m_voxel = position - (m_step[axis] << kBrickBits);
    m_brick += m_brickStep[axis];
    if ((m_brick & kBrickGuards) == 0) return false;
    m_brick -= m_brickStep[axis] << kRegionBits;
    (axis == 0 ? m_region.x : axis == 1 ? m_region.y : m_region.z) += m_negative[axis] ? -1 : 1;
    return true;
  }
  const VoxelKey& region() const { return m_region; }
  std::size_t brick() const { return m_brick >> 32; }
  /** Lowest voxel key of the brick on an axis. */
  std::int64_t brickBegin(int axis) const
  {
    const VoxelKey origin = brickOrigin(m_region, brick());
    return axis == 0 ? origin.x : axis == 1 ? origin.y : origin.z;
  }

 private:
  static constexpr Position kFields = 0x010101;  // a byte for each axis
  static constexpr Position kVoxelGuards = kFields << kBrickBits;
  static constexpr Position kBrickGuards = kFields << kRegionBits;

  static Position stepOf(std::int64_t stride, std::size_t axis)
  {
    return (static_cast<Position>(stride) << 32) + (Position{1} << (8 * axis));
  }
  /** \param mask the last key in a brick (region); 2^n - 1 */
  Position counters(const VoxelKey& key, std::int32_t mask) const
  {
    const auto counter = [mask](std::int32_t k, bool down)
    { return static_cast<Position>((down ? ~k : k) & mask); };
    return counter(key.x, m_negative[0]) | counter(key.y, m_negative[1]) << 8 |
           counter(key.z, m_negative[2]) << 16;
  }

  Position m_voxel = 0, m_brick = 0;  // index << 32 | counters
  std::array<Position, 3> m_step{}, m_brickStep{};
  std::array<bool, 3> m_negative;
  VoxelKey m_region;
};

/** The crossings of a ray with the voxels' faces, axis by axis, in times that are whole numbers:
 * the share t of the ray at which a face is crossed, times a number that is the same for all axes.
 * \tparam Int wide enough for 2^(3·bits + 2), where no coordinate differs by 2^bits units */
template <class Int>
struct RayCrossings
{
  static constexpr Int kNever = Int{1} << (8 * sizeof(Int) - 2);

  explicit RayCrossings(const GridRay& ray)
  {
    std::array<Int, 3> length{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int64_t d = ray.to[i] - ray.from[i];
      negative[i] = d < 0;
      length[i] = static_cast<Int>(std::max<std::int64_t>(1, d < 0 ? -d : d));
      key[i] = ray.from[i] >> kRayBits;
      const std::int64_t count = (ray.to[i] >> kRayBits) - key[i];
      left[i] = count < 0 ? -count : count;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (ray.from[i] == ray.to[i]) continue;
      const Int others = length[(i + 1) % 3] * length[(i + 2) % 3];
      const std::int64_t toFace = negative[i] ? ray.from[i] - (key[i] << kRayBits)
                                              : ((key[i] + 1) << kRayBits) - ray.from[i];
      // A face belongs to the voxel above it: whoever goes down crosses it a trifle later.
      next[i] = 2 * static_cast<Int>(toFace) * others + static_cast<Int>(negative[i]);
      step[i] = 2 * static_cast<Int>(kRayUnits) * others;
    }
  }

  /** Goes on to where the ray comes into a slab. \return false if it never does */
  bool enter(const Slab& slab)
  {
    const auto a = static_cast<std::size_t>(slab.axis);
    const std::int64_t count = key[a] < slab.begin  ? (negative[a] ? -1 : slab.begin - key[a])
                               : key[a] >= slab.end ? (negative[a] ? key[a] - slab.end + 1 : -1)
                                                    : 0;
    if (count == 0) return true;
    if (count < 0 || count > left[a]) return false;
    const Int time = next[a] + step[a] * static_cast<Int>(count - 1);
    pass(a, count);
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (i == a || step[i] == 0) continue;
      const Int before = time - next[i] - (i > a ? 1 : 0);
      if (before >= 0) pass(i, static_cast<std::int64_t>(before / step[i]) + 1);
    }
    return true;
  }

  std::array<Int, 3> next{kNever, kNever, kNever}, step{};  //!< time of the next crossing, and more
  std::array<std::int64_t, 3> key{}, left{};                //!< where it is; crossings to come
  std::array<bool, 3> negative{};

 private:
  void pass(std::size_t axis, std::int64_t count)
  {
    next[axis] += step[axis] * static_cast<Int>(count);
    key[axis] += negative[axis] ? -count : count;
    left[axis] -= count;
  }
};

/** Walks along a ray from voxel to voxel, as far as it lies in a slab.
 *
 * Each voxel that holds a point of the ray is visited (voxel k is [k, k+1)), one face at a time;
 * where several faces are crossed at once, that of x comes first, then y, then z.
 *
 * \param visitor has
 * - `region(key)`, which returns a reference to what it calls a region,
 * - `brick(region, index)`, which returns what it calls a brick,
 * - `cross(brick, index)`, called for each voxel but the one in which the ray ends,
 * - `end(brick, index)`, called for that one, if it lies in the slab. */
template <class Int, class Visitor>
void walkRayAs(const GridRay& ray, const Slab& slab, Visitor& visitor)
{
  RayCrossings<Int> crossings(ray);
  if (!crossings.enter(slab)) return;
  BrickCursor cursor(
      {static_cast<std::int32_t>(crossings.key[0]), static_cast<std::int32_t>(crossings.key[1]),
       static_cast<std::int32_t>(crossings.key[2])},
      crossings.negative);
  Int nextX = crossings.next[0], nextY = crossings.next[1], nextZ = crossings.next[2];
  const Int stepX = crossings.step[0], stepY = crossings.step[1], stepZ = crossings.step[2];
  const BrickCursor::Position moveX = cursor.step(0), moveY = cursor.step(1),
                              moveZ = cursor.step(2);
  std::int64_t left = crossings.left[0] + crossings.left[1] + crossings.left[2];
  auto* region = &visitor.region(cursor.region());
  while (true)
  {
    auto&& brick = visitor.brick(*region, cursor.brick());
    BrickCursor::Position at = cursor.position();
    do
    {
      if (left == 0) return visitor.end(brick, BrickCursor::indexIn(at));
      --left;
      visitor.cross(brick, BrickCursor::indexIn(at));
      // branches, since neighbouring rays take mostly the same ones: faster than choosing without
      if (nextX <= nextY)
      {
        if (nextX <= nextZ)
        {
          nextX += stepX;
          at += moveX;
        }
        else
        {
          nextZ += stepZ;
          at += moveZ;
        }
      }
      else if (nextY <= nextZ)
      {
        nextY += stepY;
        at += moveY;
      }
      else
      {
        nextZ += stepZ;
        at += moveZ;
      }
    } while (!BrickCursor::isOutside(at));
    const bool elsewhere = cursor.enterNext(at);
    const std::int64_t begin = cursor.brickBegin(slab.axis);
    if (begin < slab.begin || begin >= slab.end) return;
    if (elsewhere) region = &visitor.region(cursor.region());
  }
}

/** Whether a ray is short enough for times of 64 bits. */
inline bool isShort(const GridRay& ray)
{
  constexpr std::int64_t most = std::int64_t{1} << 20;
  return std::all_of(ray.from.begin(), ray.from.end(),
                     [&, i = std::size_t{0}](std::int64_t from) mutable
                     {
                       const std::int64_t d = ray.to[i++] - from;
                       return d <= most && d >= -most;
                     });
}

/** Whether a ray has a voxel in a slab; much faster than to find out by walking. */
inline bool reaches(const GridRay& ray, const Slab& slab)
{
  const auto axis = static_cast<std::size_t>(slab.axis);
  const std::int64_t from = ray.from[axis] >> kRayBits, to = ray.to[axis] >> kRayBits;
  return std::min(from, to) < slab.end && std::max(from, to) >= slab.begin;
}

/** walkRayAs() with times as wide as the ray needs them. */
template <class Visitor>
void walkRay(const GridRay& ray, const Slab& slab, Visitor& visitor)
{
  __extension__ using Wide = __int128;
  if (!reaches(ray, slab)) return;
  if (isShort(ray))
    walkRayAs<std::int64_t>(ray, slab, visitor);
  else
    walkRayAs<Wide>(ray, slab, visitor);
}

}  // namespace mrpt_mapconv::voxel
