#pragma once

#include <embree3/rtcore.h>
#include <mrpt_mapconv/sim/Primitive.h>

#include <cstdint>

namespace mrpt_mapconv::sim
{
/** A curved surface where it is now. */
struct Placed
{
  const CurvedSurface* surface = nullptr;
  mrpt::math::TVector3D shift{0, 0, 0};  // from where it says that it is [m]
};

/** A ray's way through the world: what Embree hands on to the bodies that the ray may meet. */
struct Way
{
  RTCIntersectContext context;  // first: this is all that Embree knows of
  std::uint64_t key = 0;
};

mrpt::math::TVector3D directionOf(const RTCRay& ray);

/** Geometries of bodies that are no triangles; rays are cast at them one by one, each with a Way.
 * What they are given must stay where it is as long as they live. @{ */
RTCGeometry newGeometry(RTCDevice device, Placed& placed);
RTCGeometry newGeometry(RTCDevice device, const Foliage*& foliage);
/** @} */

}  // namespace mrpt_mapconv::sim
