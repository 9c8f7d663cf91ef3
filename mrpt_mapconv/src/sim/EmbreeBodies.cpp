#include "EmbreeBodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Random.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

namespace
{
// Embree hands out plain pointers: ours are to these, see newGeometry().
const Placed& placedOf(void* userData) { return *static_cast<const Placed*>(userData); }
const Foliage& foliageOf(void* userData) { return **static_cast<const Foliage**>(userData); }

void setBounds(const TPoint3D& low, const TPoint3D& high, RTCBounds& bounds)
{
  // Embree's box must hold the body also after the rounding to single precision
  const auto below = [](double v)
  { return std::nextafterf(static_cast<float>(v), -std::numeric_limits<float>::infinity()); };
  const auto above = [](double v)
  { return std::nextafterf(static_cast<float>(v), std::numeric_limits<float>::infinity()); };
  bounds = {below(low.x),  below(low.y),  below(low.z),  0,
            above(high.x), above(high.y), above(high.z), 0};
}

/** The ray; a packet of one is the plain structure. */
RTCRayHit& queryOf(const RTCIntersectFunctionNArguments* args)
{
  return *reinterpret_cast<RTCRayHit*>(args->rayhit);
}

TPoint3D originOf(const RTCRay& ray) { return {ray.org_x, ray.org_y, ray.org_z}; }

/** Tells Embree where a ray ends. */
void endRay(const RTCIntersectFunctionNArguments* args, double range, const TVector3D& outwards)
{
  RTCRayHit& query = queryOf(args);
  query.ray.tfar = static_cast<float>(range);
  query.hit.Ng_x = static_cast<float>(outwards.x);
  query.hit.Ng_y = static_cast<float>(outwards.y);
  query.hit.Ng_z = static_cast<float>(outwards.z);
  query.hit.primID = args->primID;
  query.hit.geomID = args->geomID;
  query.hit.instID[0] = args->context->instID[0];
}

void boundCurved(const RTCBoundsFunctionArguments* args)
{
  const Placed& placed = placedOf(args->geometryUserPtr);
  const auto [low, high] = placed.surface->bounds();
  setBounds(low + placed.shift, high + placed.shift, *args->bounds_o);
}

void meetCurved(const RTCIntersectFunctionNArguments* args)
{
  if (!args->valid[0]) return;
  const Placed& placed = placedOf(args->geometryUserPtr);
  const RTCRay& ray = queryOf(args).ray;
  const auto meeting =
      placed.surface->meet(originOf(ray) - placed.shift, directionOf(ray), ray.tnear, ray.tfar);
  if (meeting) endRay(args, meeting->range, meeting->outwards);
}

void boundFoliage(const RTCBoundsFunctionArguments* args)
{
  const auto [low, high] = foliageOf(args->geometryUserPtr).boundsOf(args->primID);
  setBounds(low, high, *args->bounds_o);
}

/** How far a ray gets through leaves of a density of 1 before it meets one. */
double wayToLeaf(const RTCIntersectFunctionNArguments* args)
{
  const std::uint64_t key = reinterpret_cast<const Way*>(args->context)->key;
  const auto number = [](unsigned id) { return static_cast<std::int32_t>(id); };
  Random random(hashAt(key, number(args->geomID), number(args->primID)));
  return -std::log(1 - random.uniform());
}

void meetFoliage(const RTCIntersectFunctionNArguments* args)
{
  if (!args->valid[0]) return;
  const Foliage& foliage = foliageOf(args->geometryUserPtr);
  const RTCRay& ray = queryOf(args).ray;
  const TVector3D direction = directionOf(ray);
  const auto stretch = foliage.inside(args->primID, originOf(ray), direction);
  if (!stretch) return;
  // from the ray's origin on, not from tnear: who looks on behind a pane meets the same leaf
  const double range = std::max(stretch->from, 0.0) + wayToLeaf(args) / foliage.density();
  if (range > stretch->to || range < ray.tnear || range > ray.tfar) return;
  endRay(args, range, {-direction.x, -direction.y, -direction.z});
}

RTCGeometry newUserGeometry(RTCDevice device, std::size_t parts, void* user)
{
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(parts));
  rtcSetGeometryUserData(geometry, user);
  return geometry;
}
}  // namespace

TVector3D directionOf(const RTCRay& ray) { return {ray.dir_x, ray.dir_y, ray.dir_z}; }

RTCGeometry newGeometry(RTCDevice device, Placed& placed)
{
  const RTCGeometry geometry = newUserGeometry(device, 1, &placed);
  rtcSetGeometryBoundsFunction(geometry, boundCurved, nullptr);
  rtcSetGeometryIntersectFunction(geometry, meetCurved);
  return geometry;
}

RTCGeometry newGeometry(RTCDevice device, const Foliage*& foliage)
{
  const RTCGeometry geometry = newUserGeometry(device, foliage->parts(), &foliage);
  rtcSetGeometryBoundsFunction(geometry, boundFoliage, nullptr);
  rtcSetGeometryIntersectFunction(geometry, meetFoliage);
  return geometry;
}

}  // namespace mrpt_mapconv::sim
