#include "Echo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3Df;

namespace
{
constexpr int kMostBodies = 8;        //!< that a ray is sent on by
constexpr float kBehindPane = 1e-4f;  //!< so that a ray does not meet the same surface again [m]

/** Where a ray that met a surface goes on [m]: farther, also where single precision is coarse. */
float behind(float range)
{
  return std::max(range + kBehindPane,
                  std::nextafter(range, std::numeric_limits<float>::infinity()));
}

TPoint3Df along(const Ray& ray, float range)
{
  return {ray.origin.x + range * ray.direction.x, ray.origin.y + range * ray.direction.y,
          ray.origin.z + range * ray.direction.z};
}

/** Cosine of the angle between a ray and the normal, with the normal's sign: negative. */
double againstNormal(const Ray& ray, const Hit& hit)
{
  const auto product = [](float a, float b) { return static_cast<double>(a) * b; };
  return product(ray.direction.x, hit.normal.x) + product(ray.direction.y, hit.normal.y) +
         product(ray.direction.z, hit.normal.z);
}

/** The ray from where it met a mirror. */
Ray reflected(const Ray& ray, const Hit& hit)
{
  const double twice = 2 * againstNormal(ray, hit);
  const auto folded = [&](float direction, float normal) { return direction - twice * normal; };
  const double x = folded(ray.direction.x, hit.normal.x);
  const double y = folded(ray.direction.y, hit.normal.y);
  const double z = folded(ray.direction.z, hit.normal.z);
  const double length = std::sqrt(x * x + y * y + z * z);
  return {along(ray, hit.range),
          {static_cast<float>(x / length), static_cast<float>(y / length),
           static_cast<float>(z / length)},
          ray.key};
}

/** Share of the rays that a body reflects where this one met it. */
double mirrorShare(const Primitive& body, const Ray& ray, const Hit& hit)
{
  const double mirror = body.mirror();
  if (mirror <= 0) return 0;
  const double rest = std::clamp(1 + againstNormal(ray, hit), 0.0, 1.0);
  return mirror + (1 - mirror) * rest * rest * rest * rest * rest;
}

enum class Fate
{
  Returns,
  GoesThrough,
  IsReflected
};

Fate fateAt(const Primitive& body, const Ray& ray, const Hit& hit, Random& random)
{
  if (body.transparency() <= 0 && body.mirror() <= 0) return Fate::Returns;
  const double share = mirrorShare(body, ray, hit), chance = random.uniform();
  if (chance < share) return Fate::IsReflected;
  return chance < share + (1 - share) * body.transparency() ? Fate::GoesThrough : Fate::Returns;
}
}  // namespace

Echo echoOf(const RayCaster& caster, const Ray& ray, float maxRange, Random random)
{
  Ray leg = ray;
  float before = 0, from = 0;  // length of the legs before this one, and where on it to go on
  // Bodies that this leg is done with: panes that it goes through with both of their faces, and the
  // mirror that it comes from, which is convex and only met again by rounding.
  std::vector<std::int32_t> done;
  bool mirrored = false;
  for (int bodies = 0;;)
  {
    const Hit hit = caster.cast(leg, from, maxRange - before);
    if (hit.primitive < 0) return {};
    from = behind(hit.range);
    if (std::find(done.begin(), done.end(), hit.primitive) != done.end()) continue;
    const Primitive& body = caster.world().primitive(static_cast<std::size_t>(hit.primitive));
    const Fate fate = bodies++ < kMostBodies ? fateAt(body, leg, hit, random) : Fate::Returns;
    if (fate == Fate::Returns)
      return {before + hit.range, hit.primitive, along(leg, hit.range), mirrored};
    if (fate == Fate::IsReflected)
    {
      leg = reflected(leg, hit);
      before += hit.range;
      from = kBehindPane;
      done.clear();
      mirrored = true;
    }
    done.push_back(hit.primitive);
  }
}

}  // namespace mrpt_mapconv::sim
