#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/RayCaster.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <thread>

#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv::sim;
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;
using mrpt_mapconv::test::worldOf;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-4;  // [m], at up to 30 m

/** A range in closed form, infinite for none. */
using Range = std::function<double(const TPoint3D& origin, const TVector3D& direction)>;

double dot(const TVector3D& a, const TVector3D& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/** Where a ray enters a convex body, given by the planes n·p <= d that enclose it. */
struct Plane
{
  TVector3D normal;
  double distance;
};
Range convexBody(const std::vector<Plane>& planes)
{
  return [planes](const TPoint3D& o, const TVector3D& u)
  {
    double enter = 0, leave = kInfinity;
    for (const auto& [normal, distance] : planes)
    {
      const double speed = dot(normal, u), above = dot(normal, o) - distance;
      if (speed < 0)
        enter = std::max(enter, -above / speed);
      else if (speed > 0)
        leave = std::min(leave, -above / speed);
      else if (above > 0)
        return kInfinity;
    }
    return enter < leave ? enter : kInfinity;
  };
}
std::vector<Plane> boxPlanes(const TPoint3D& min, const TPoint3D& max)
{
  return {{{1, 0, 0}, max.x},   {{0, 1, 0}, max.y},   {{0, 0, 1}, max.z},
          {{-1, 0, 0}, -min.x}, {{0, -1, 0}, -min.y}, {{0, 0, -1}, -min.z}};
}

Range nearest(const std::vector<Range>& bodies)
{
  return [bodies](const TPoint3D& o, const TVector3D& u)
  {
    double range = kInfinity;
    for (const auto& body : bodies) range = std::min(range, body(o, u));
    return range;
  };
}

/** From the textbook's quadratic equation a t² + b t + c = 0: entering, then leaving. */
std::pair<double, double> roots(double a, double b, double c)
{
  const double square = b * b - 4 * a * c;
  if (square < 0 || a == 0) return {kInfinity, -kInfinity};
  return {(-b - std::sqrt(square)) / (2 * a), (-b + std::sqrt(square)) / (2 * a)};
}

Range sphere(const TPoint3D& centre, double radius)
{
  return [=](const TPoint3D& o, const TVector3D& u)
  {
    const TVector3D d = o - centre;
    const double t = roots(1, 2 * dot(u, d), dot(d, d) - radius * radius).first;
    return t >= 0 ? t : kInfinity;
  };
}

/** An upright cylinder as the part of an endless one between two planes. */
Range cylinder(const TPoint3D& base, double radius, double height)
{
  return [=](const TPoint3D& o, const TVector3D& u)
  {
    const double dx = o.x - base.x, dy = o.y - base.y;
    auto [enter, leave] = roots(u.x * u.x + u.y * u.y, 2 * (u.x * dx + u.y * dy),
                                dx * dx + dy * dy - radius * radius);
    const double low = (base.z - o.z) / u.z, high = (base.z + height - o.z) / u.z;
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
    return enter >= 0 && enter < leave ? enter : kInfinity;
  };
}

/** Casts rays from a shell of up to 15 m around a place to about that place. */
void expectRanges(const std::string& text, const TPoint3D& about, double spread, const Range& right)
{
  SCOPED_TRACE(text);
  const World world = worldOf(text);
  const RayCaster caster(world);
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> distance(8, 15), side(-1, 1);
  int hits = 0, misses = 0;
  for (int i = 0; i < 20000; ++i)
  {
    TVector3D away(normal(random), normal(random), normal(random));
    away *= distance(random) / away.norm();
    const TPoint3D target = about + TVector3D(side(random), side(random), side(random)) * spread;
    const auto origin = mrpt::math::TPoint3Df(about + away);
    TVector3D towards = target - TPoint3D(origin);
    towards *= 1 / towards.norm();
    const auto direction = mrpt::math::TPoint3Df(towards);
    // the caster's numbers are single, so the answer must be for those
    const TVector3D cast = TVector3D(direction) * (1 / TVector3D(direction).norm());
    const double range = right(TPoint3D(origin), cast);
    // beside a hit that is no hit a hair's breadth away, rounding decides
    bool edge = false;
    for (const TVector3D& d : {TVector3D(1, 0, 0), TVector3D(0, 1, 0), TVector3D(0, 0, 1)})
      for (const double h : {-2e-5, 2e-5})
        edge = edge || !(std::abs(right(TPoint3D(origin) + d * h, cast) - range) < 0.01 ||
                         right(TPoint3D(origin) + d * h, cast) == range);
    if (edge) continue;
    const Hit hit = caster.cast({origin, direction}, 0, 30);
    if (range > 30)
    {
      ++misses;
      ASSERT_EQ(hit.primitive, -1) << "seed " << kSeed << ", ray " << i << ", at " << hit.range;
      ASSERT_TRUE(std::isinf(hit.range));
      continue;
    }
    ++hits;
    ASSERT_NEAR(hit.range, range, kTolerance) << "seed " << kSeed << ", ray " << i;
    ASSERT_GE(hit.primitive, 0);
    ASSERT_NEAR(hit.normal.norm(), 1, 1e-5);
    ASSERT_LE(dot(TVector3D(hit.normal), cast), 1e-6);
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(misses, 1000);
}

TEST(RayCaster, RangesOfABox)
{
  const TPoint3D min(1, -2, 0.5), max(3, 1, 2);
  expectRanges("[box.a]\nmin = 1 -2 0.5\nmax = 3 1 2\n", {2, -0.5, 1.25}, 2.5,
               convexBody(boxPlanes(min, max)));
}

TEST(RayCaster, RangesOfATurnedBox)
{
  const double c = std::cos(0.5), s = std::sin(0.5);
  const TVector3D u(c, s, 0), v(-s, c, 0);
  expectRanges(
      "[box.a]\nmin = -1 -2 0\nmax = 1 2 3\nyaw = " + std::to_string(90 / std::acos(0.0) * 0.5),
      {0, 0, 1.5}, 3,
      convexBody({{u, 1}, {u * -1.0, 1}, {v, 2}, {v * -1.0, 2}, {{0, 0, 1}, 3}, {{0, 0, -1}, 0}}));
}

TEST(RayCaster, RangesOfASphere)
{
  expectRanges("[sphere.a]\ncentre = 1 2 3\nradius = 1.5\n", {1, 2, 3}, 2, sphere({1, 2, 3}, 1.5));
  expectRanges("[sphere.a]\ncentre = 1 2 3\nradius = 0.1\n", {1, 2, 3}, 0.12,
               sphere({1, 2, 3}, 0.1));
}

TEST(RayCaster, RangesOfACylinder)
{
  expectRanges("[cylinder.a]\nbase = 1 2 3\nradius = 1\nheight = 2\n", {1, 2, 4}, 1.8,
               cylinder({1, 2, 3}, 1, 2));
  expectRanges("[cylinder.post]\nbase = 1 2 3\nradius = 0.05\nheight = 2\n", {1, 2, 4}, 0.1,
               cylinder({1, 2, 3}, 0.05, 2));
}

TEST(RayCaster, RangesOfRamps)
{
  // 4 x 2 x 1: the upper face rises by 0.25 along x, or by 0.5 along y
  const TPoint3D min(-2, -1, 0), max(2, 1, 1);
  const auto wedge = [&](const TVector3D& normal, double distance)
  {
    auto planes = boxPlanes(min, max);
    planes.push_back({normal, distance});
    return convexBody(planes);
  };
  const std::string keys = "min = -2 -1 0\nmax = 2 1 1\ndirection = ";
  expectRanges("[ramp.a]\n" + keys + "+x", {0, 0, 0.5}, 2, wedge({-0.25, 0, 1}, 0.5));
  expectRanges("[ramp.a]\n" + keys + "-x", {0, 0, 0.5}, 2, wedge({0.25, 0, 1}, 0.5));
  expectRanges("[ramp.a]\n" + keys + "+y", {0, 0, 0.5}, 2, wedge({0, -0.5, 1}, 0.5));
  expectRanges("[ramp.a]\n" + keys + "-y", {0, 0, 0.5}, 2, wedge({0, 0.5, 1}, 0.5));
}

TEST(RayCaster, RangesOfStairs)
{
  // three steps, 1 m deep and 0.5 m high, are three boxes
  expectRanges("[stairs.a]\nmin = -1 -1 0\nmax = 2 1 1.5\ndirection = +x\nsteps = 3\n",
               {0.5, 0, 0.75}, 2,
               nearest({convexBody(boxPlanes({-1, -1, 0}, {2, 1, 0.5})),
                        convexBody(boxPlanes({0, -1, 0}, {2, 1, 1})),
                        convexBody(boxPlanes({1, -1, 0}, {2, 1, 1.5}))}));
  expectRanges("[stairs.a]\nmin = -1 -1 0\nmax = 1 2 1.5\ndirection = -y\nsteps = 3\n",
               {0, 0.5, 0.75}, 2,
               nearest({convexBody(boxPlanes({-1, -1, 0}, {1, 2, 0.5})),
                        convexBody(boxPlanes({-1, -1, 0}, {1, 1, 1})),
                        convexBody(boxPlanes({-1, -1, 0}, {1, 0, 1.5}))}));
}

TEST(RayCaster, RangesOfAPane)
{
  // along y at x = 1, 2 cm thick
  expectRanges("[pane.a]\nfrom = 1 -2\nto = 1 2\nbottom = 0\ntop = 3\nthickness = 0.02\n",
               {1, 0, 1.5}, 3, convexBody(boxPlanes({0.99, -2, 0}, {1.01, 2, 3})));
}

TEST(RayCaster, FarGroundUnderASmallAngle)
{
  // the height field's triangles lie in the plane z = 0.1 x - 0.05 y
  const World world = worldOf(
      "[heightField.a]\nmin = -50 -50\nmax = 50 50\ncell = 1\nsolid = below\n"
      "gradient = 0.1 -0.05\n");
  const RayCaster caster(world);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> angle(0, 6.28318f), distance(1, 29.9f);
  for (int i = 0; i < 20000; ++i)
  {
    const float a = angle(random), d = distance(random);
    const double x = d * std::cos(a), y = d * std::sin(a), height = 0.5;
    TVector3D u(x, y, 0.1 * x - 0.05 * y - height);
    u *= 1 / u.norm();
    const mrpt::math::TPoint3Df direction(u), origin(0, 0, 0.5f);
    const TVector3D n(-0.1, 0.05, 1), cast(direction);
    const double range = -dot(n, TPoint3D(origin)) / dot(n, cast);
    if (range > 30) continue;
    const Hit hit = caster.cast({origin, direction}, 0, 40);
    ASSERT_NEAR(hit.range, range, kTolerance) << "ray " << i;
    ASSERT_NEAR(dot(TVector3D(hit.normal), n) / n.norm(), 1, 1e-5);
  }
}

TEST(RayCaster, AWideFloorUnderASmallAngle)
{
  // two triangles of 300 m
  const World world = worldOf("[box.floor]\nmin = -100 -150 -1\nmax = 200 150 0\n");
  const RayCaster caster(world);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> angle(0, 6.28318f), distance(20, 29.9f);
  for (int i = 0; i < 20000; ++i)
  {
    const float a = angle(random), d = distance(random);
    TVector3D u(d * std::cos(a), d * std::sin(a), -0.3);
    u *= 1 / u.norm();
    const mrpt::math::TPoint3Df direction(u), origin(40.7f, -31.3f, 0.3f);
    const Hit hit = caster.cast({origin, direction}, 0, 40);
    ASSERT_NEAR(hit.range, -double(origin.z) / direction.z, kTolerance) << "ray " << i;
  }
}

TEST(RayCaster, InsideABodyItsFarSideIsMet)
{
  const World world = worldOf(
      "[sphere.a]\ncentre = 0 0 0\nradius = 2\n[cylinder.b]\nbase = 10 0 0\nradius = 1\n"
      "height = 3\n[box.c]\nmin = 20 -1 -1\nmax = 22 1 1\n");
  const RayCaster caster(world);
  EXPECT_NEAR(caster.cast({{0.5f, 0, 0}, {1, 0, 0}}, 0, 30).range, 1.5, 1e-6);
  EXPECT_NEAR(caster.cast({{10, 0, 1}, {0, 1, 0}}, 0, 30).range, 1, 1e-6);
  EXPECT_NEAR(caster.cast({{10, 0, 1}, {0, 0, 1}}, 0, 30).range, 2, 1e-6);
  EXPECT_NEAR(caster.cast({{10, 0, 1}, {0, 0, -1}}, 0, 30).range, 1, 1e-6);
  EXPECT_NEAR(caster.cast({{21, 0, 0}, {0, 0, -1}}, 0, 30).range, 1, 1e-6);
}

TEST(RayCaster, OnlyWithinTheRanges)
{
  const World world =
      worldOf("[box.near]\nmin = 1 -1 -1\nmax = 2 1 1\n[sphere.far]\ncentre = 6 0 0\nradius = 1\n");
  const RayCaster caster(world);
  const Ray ray{{0, 0, 0}, {1, 0, 0}};
  const auto expectHit = [&](float minRange, float maxRange, float range, int primitive)
  {
    const Hit hit = caster.cast(ray, minRange, maxRange);
    EXPECT_EQ(hit.range, range);
    EXPECT_EQ(hit.primitive, primitive);
  };
  const float none = std::numeric_limits<float>::infinity();
  expectHit(0, 30, 1, 0);
  expectHit(1.5f, 30, 2, 0);  // its far side
  expectHit(2.5f, 30, 5, 1);
  expectHit(5.5f, 30, 7, 1);
  expectHit(7.5f, 30, none, -1);
  expectHit(0, 0.9f, none, -1);
  expectHit(2.5f, 4.9f, none, -1);
  expectHit(0, none, 1, 0);
}

TEST(RayCaster, NormalsLookBack)
{
  const World world = worldOf("[box.a]\nmin = -1 -1 -1\nmax = 1 1 1\n");
  const RayCaster caster(world);
  for (const auto& away : {mrpt::math::TPoint3Df(1, 0, 0), mrpt::math::TPoint3Df(0, -1, 0),
                           mrpt::math::TPoint3Df(0, 0, 1)})
  {
    EXPECT_EQ(caster.cast({away * 5.0f, away * -1.0f}, 0, 30).normal, away) << away.asString();
    // from inside, at the same face
    EXPECT_EQ(caster.cast({{0, 0, 0}, away}, 0, 30).normal, away * -1.0f) << away.asString();
  }
}

TEST(RayCaster, GlassIsASurface)
{
  const World world =
      worldOf("[pane.a]\nfrom = 1 -2\nto = 1 2\nbottom = -1\ntop = 3\ntransparency = 1\n");
  EXPECT_NEAR(RayCaster(world).cast({{0, 0, 0}, {1, 0, 0}}, 0, 30).range, 0.995, 1e-6);
}

TEST(RayCaster, AnEmptyWorldHasNothingToMeet)
{
  const World world({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(RayCaster(world).cast({{0, 0, 0}, {1, 0, 0}}, 0, 30).primitive, -1);
}

std::vector<Ray> manyRays(int count)
{
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i)
  {
    mrpt::math::TPoint3Df u(normal(random), normal(random), normal(random));
    rays.push_back({{0, 0, 1}, u * (1 / u.norm())});
  }
  return rays;
}

TEST(RayCaster, TheSameAnswersOneByOneInAnotherCasterAndFromSeveralThreads)
{
  const World world = worldOf(
      "[heightField.a]\nmin = -20 -20\nmax = 20 20\ncell = 0.5\nsolid = below\nbase = -1\n"
      "amplitude = 0.8\nwavelength = 4\noctaves = 2\n[box.b]\nmin = 2 2 -1\nmax = 3 5 4\n"
      "[sphere.c]\ncentre = -4 1 3\nradius = 2\n[cylinder.d]\nbase = 0 -4 -2\nradius = 0.3\n"
      "height = 9\n");
  const RayCaster caster(world), other(world);
  const auto rays = manyRays(20000);
  std::vector<Hit> hits, fromOther;
  caster.cast(rays, 0.1f, 30, hits);
  other.cast(rays, 0.1f, 30, fromOther);
  std::vector<std::vector<Hit>> fromThreads(4);
  std::vector<std::thread> threads;
  threads.reserve(fromThreads.size());
  for (auto& answer : fromThreads)
    threads.emplace_back([&] { caster.cast(rays, 0.1f, 30, answer); });
  for (auto& thread : threads) thread.join();

  const auto expectSame = [](const Hit& a, const Hit& b)
  {
    ASSERT_EQ(a.range, b.range);
    ASSERT_EQ(a.primitive, b.primitive);
    ASSERT_EQ(a.normal, b.normal);
  };
  ASSERT_EQ(hits.size(), rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    expectSame(hits[i], caster.cast(rays[i], 0.1f, 30));
    expectSame(hits[i], fromOther[i]);
    for (const auto& answer : fromThreads) expectSame(hits[i], answer[i]);
  }
}

TEST(RayCaster, NoRaySlipsThroughClosedGround)
{
  const World world = worldOf(
      "[heightField.a]\nmin = -20 -20\nmax = 20 20\ncell = 0.5\nsolid = below\nbase = -1\n"
      "amplitude = 0.5\nwavelength = 4\n");
  const RayCaster caster(world);
  for (int i = -38; i <= 38; ++i)
    for (int j = -38; j <= 38; ++j)  // exactly at the points of the lattice, and on its edges
      for (const float aside : {0.0f, 0.25f})
        ASSERT_EQ(caster.cast({{0.5f * float(i), 0.5f * float(j) + aside, 5}, {0, 0, -1}}, 0, 30)
                      .primitive,
                  0);
}
}  // namespace
