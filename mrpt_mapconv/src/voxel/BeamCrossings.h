#pragma once

#include <mrpt_mapconv/voxel/RayWalk.h>
#include <octomap/octomap_types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "OctomapKeys.h"

namespace mrpt_mapconv::voxel
{
/** How far along a beam it crosses the voxels' faces [m], axis by axis: by the arithmetic of
 * octomap::OcTree::computeRayKeys(), its order of comparisons and its sums, of which the rounding
 * errors decide through which voxels a beam goes. */
class BeamCrossings
{
 public:
  BeamCrossings(const OctomapKeys& keys, const octomap::point3d& origin,
                const octomap::point3d& end, const VoxelKey& from)
  {
    octomap::point3d direction = end - origin;
    m_length = static_cast<float>(direction.norm());
    direction /= m_length;
    const std::array<std::int32_t, 3> start{from.x, from.y, from.z};
    for (unsigned i = 0; i < 3; ++i)
    {
      negative[i] = direction(i) < 0;
      if (!(direction(i) > 0) && !negative[i]) continue;
      double border = keys.centre(start[i]);
      border += static_cast<float>((negative[i] ? -1 : 1) * keys.resolution() * 0.5);
      m_next[i] = (border - origin(i)) / direction(i);
      m_delta[i] = keys.resolution() / std::fabs(direction(i));
    }
  }

  /** Takes the steps of a cursor for its own. */
  void follow(const BrickCursor& cursor)
  {
    for (int i = 0; i < 3; ++i) m_move[static_cast<std::size_t>(i)] = cursor.step(i);
  }

  /** Marks the voxels from `at` on.
   * \return where it left the brick; a position inside if the beam ends there, at `stop` or since
   * the next face is farther than its end */
  BrickCursor::Position mark(std::uint16_t* crossed, BrickCursor::Position at,
                             BrickCursor::Position stop)
  {
    double nextX = m_next[0], nextY = m_next[1], nextZ = m_next[2];
    double farthest = m_farthest;
    do
    {
      if (at == stop) return at;
      const std::size_t index = BrickCursor::indexIn(at);
      const auto bit = static_cast<std::uint16_t>(1u << (index & (kBrickSide - 1)));
      std::uint16_t& column = crossed[index >> kBrickBits];
      if (nextX < nextY && nextX < nextZ)
      {
        if (nextX > farthest) return at;
        nextX += m_delta[0];
        at += m_move[0];
      }
      else if (nextY < nextZ && !(nextX < nextY))
      {
        if (nextY > farthest) return at;
        nextY += m_delta[1];
        at += m_move[1];
      }
      else
      {
        if (nextZ > farthest) return at;
        nextZ += m_delta[2];
        at += m_move[2];
      }
      column |= bit;
      farthest = m_length;
    } while (!BrickCursor::isOutside(at));
    m_next = {nextX, nextY, nextZ};
    m_farthest = farthest;
    return at;
  }

  std::array<bool, 3> negative{};

 private:
  static constexpr double kNever = std::numeric_limits<double>::max();
  std::array<double, 3> m_next{kNever, kNever, kNever}, m_delta{kNever, kNever, kNever};
  std::array<BrickCursor::Position, 3> m_move{};
  double m_farthest = kNever;  // the first voxel counts, however near its face
  float m_length = 0;
};
}  // namespace mrpt_mapconv::voxel
