#pragma once

#include <mrpt/math/TPoint3D.h>
#include <mrpt_mapconv/sim/World.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace mrpt_mapconv::sim
{
struct Ray
{
  mrpt::math::TPoint3Df origin;     //!< [m]
  mrpt::math::TPoint3Df direction;  //!< of length 1
  std::uint64_t key = 0;            //!< which leaves it meets; the same key, the same leaves
};

/** What a ray meets first. */
struct Hit
{
  float range = std::numeric_limits<float>::infinity();  //!< [m]; infinite: nothing
  std::int32_t primitive = -1;                           //!< its number in the world
  /** Of the surface, of length 1, towards the ray's origin; of a leaf, the way back. */
  mrpt::math::TPoint3Df normal;
};

/** Casts rays at a world's surfaces (by Embree). Several threads may cast at once, but not while
 * the world moves. */
class RayCaster
{
 public:
  /** The world must outlive the caster and is not to be changed. */
  explicit RayCaster(const World& world);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  const World& world() const;
  /** Puts the bodies that move where they are at a time [s]; before the first call it is 0. */
  void moveTo(double seconds);
  /** The first surface that each ray meets between minRange and maxRange [m]. Glass counts as any
   * other surface: whoever wants to look through it casts on from there. */
  void cast(const std::vector<Ray>& rays, float minRange, float maxRange,
            std::vector<Hit>& hits) const;
  Hit cast(const Ray& ray, float minRange, float maxRange) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> m_scene;
};

}  // namespace mrpt_mapconv::sim
