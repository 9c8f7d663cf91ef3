#pragma once

#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace mrpt_mapconv::test
{
/** Rays of the kinds that a walk may get wrong, in the units of GridRay. */
class RandomRays
{
 public:
  /** \param low,high where rays lie on each axis [voxels] */
  RandomRays(std::uint32_t seed, std::int64_t low, std::int64_t high)
      : m_random(seed), m_low(low * voxel::kRayUnits), m_high(high * voxel::kRayUnits)
  {
  }

  std::int64_t between(std::int64_t low, std::int64_t high)
  {
    return std::uniform_int_distribution<std::int64_t>(low, high)(m_random);
  }

  voxel::GridRay anywhere() { return {point(), point()}; }
  /** Along an axis; as often as not on a face or an edge. */
  voxel::GridRay alongAxis();
  /** All coordinates are on faces. */
  voxel::GridRay betweenCorners();
  /** Through corners, up or down on each axis, from one of them or from a point between two. */
  voxel::GridRay diagonal();
  /** In a plane of faces or of voxels' middles. */
  voxel::GridRay inPlane();
  voxel::GridRay withoutLength();
  /** Short ones, of a few units to a few voxels. */
  voxel::GridRay tiny();
  /** One of those above. */
  voxel::GridRay any();

 private:
  using Point = std::array<std::int64_t, 3>;
  std::int64_t coordinate() { return between(m_low, m_high - 1); }
  std::int64_t face() { return (coordinate() >> voxel::kRayBits) * voxel::kRayUnits; }
  Point point() { return {coordinate(), coordinate(), coordinate()}; }
  Point corner() { return {face(), face(), face()}; }

  std::mt19937 m_random;
  std::int64_t m_low, m_high;
};

/** The same ray in metres; exact for a resolution that is a power of two. */
voxel::Ray inMetres(const voxel::GridRay& ray, double resolution, voxel::RayEnd atEnd);

}  // namespace mrpt_mapconv::test
