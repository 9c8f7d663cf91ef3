#include "TaperedCylinder.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "MeshBuilder.h"

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;
using Meeting = CurvedSurface::Meeting;

namespace
{
double dot(const TVector3D& a, const TVector3D& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

TVector3D cross(const TVector3D& a, const TVector3D& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** How far a disc reaches along the coordinate axes from its middle. */
TVector3D reachOf(double radius, const TVector3D& axis)
{
  const auto across = [&](double along)
  { return radius * std::sqrt(std::max(0.0, 1 - along * along)); };
  return {across(axis.x), across(axis.y), across(axis.z)};
}
}  // namespace

struct TaperedCylinder::Line
{
  double start;             // its zero, as a length from the ray's origin [m]
  double height, climb;     // along the axis: at zero [m], and for a metre of the line
  TVector3D aside, astray;  // across the axis, likewise

  double heightAt(double way) const { return height + way * climb; }
  TVector3D asideAt(double way) const { return aside + astray * way; }
};

TaperedCylinder::TaperedCylinder(const End& from, const End& to) : m_from(from), m_to(to)
{
  const TVector3D way = to.middle - from.middle;
  m_length = way.norm();
  m_axis = way * (1 / m_length);
  m_taper = (to.radius - from.radius) / m_length;
}

Footprint TaperedCylinder::footprint() const
{
  const auto [low, high] = bounds();
  return {low.x, low.y, high.x, high.y};
}

std::array<TPoint3D, 2> TaperedCylinder::bounds() const
{
  const TVector3D a = reachOf(m_from.radius, m_axis), b = reachOf(m_to.radius, m_axis);
  const TPoint3D &from = m_from.middle, &to = m_to.middle;
  return {TPoint3D(std::min(from.x - a.x, to.x - b.x), std::min(from.y - a.y, to.y - b.y),
                   std::min(from.z - a.z, to.z - b.z)),
          TPoint3D(std::max(from.x + a.x, to.x + b.x), std::max(from.y + a.y, to.y + b.y),
                   std::max(from.z + a.z, to.z + b.z))};
}

void TaperedCylinder::appendMesh(Mesh& mesh) const
{
  constexpr std::uint32_t kSectors = 24;
  constexpr double kTurn = 2 * 3.14159265358979323846;
  const TVector3D other = std::abs(m_axis.z) < 0.9 ? TVector3D(0, 0, 1) : TVector3D(1, 0, 0);
  TVector3D u = cross(m_axis, other);
  u *= 1 / u.norm();
  const TVector3D v = cross(m_axis, u);
  MeshBuilder build(mesh);
  const auto ring = [&](const End& end)
  {
    const std::uint32_t middle = build.vertex(end.middle.x, end.middle.y, end.middle.z);
    for (std::uint32_t sector = 0; sector < kSectors; ++sector)
    {
      const double around = kTurn * sector / kSectors;
      const TVector3D r = u * (end.radius * std::cos(around)) + v * (end.radius * std::sin(around));
      build.vertex(end.middle.x + r.x, end.middle.y + r.y, end.middle.z + r.z);
    }
    return middle;
  };
  const std::uint32_t from = ring(m_from), to = ring(m_to);
  for (std::uint32_t sector = 0; sector < kSectors; ++sector)
  {
    const std::uint32_t a = 1 + sector, b = 1 + (sector + 1) % kSectors;
    build.quad(from + a, from + b, to + b, to + a);
    build.triangle(from, from + b, from + a);
    build.triangle(to, to + a, to + b);
  }
}

void TaperedCylinder::appendSolids(double x, double y, std::vector<Solid>& solids) const
{
  const double z = m_from.middle.z;
  const auto found = crossings({x, y, z}, {0, 0, 1});
  if (!found) return;
  const TVector3D& up = (*found)[1].outwards;
  solids.push_back({z + (*found)[0].range, z + (*found)[1].range, std::hypot(up.x, up.y) / up.z});
}

std::optional<Meeting> TaperedCylinder::meet(const TPoint3D& origin, const TVector3D& direction,
                                             double minRange, double maxRange) const
{
  const auto found = crossings(origin, direction);
  if (!found) return {};
  for (const Meeting& meeting : *found)
    if (meeting.range >= minRange && meeting.range <= maxRange) return meeting;
  return {};
}

std::optional<std::array<Meeting, 2>> TaperedCylinder::crossings(const TPoint3D& origin,
                                                                 const TVector3D& direction) const
{
  Line line;
  const TVector3D away = m_from.middle - origin;
  line.start = dot(away, direction);  // so that far rays lose nothing
  const TVector3D place = direction * line.start - away;
  line.height = dot(place, m_axis);
  line.climb = dot(direction, m_axis);
  line.aside = place - m_axis * line.height;
  line.astray = direction - m_axis * line.climb;

  std::vector<Meeting> found;
  meetEnds(line, found);
  meetWall(line, found);
  if (found.size() < 2) return {};  // it touches an edge at most
  const auto [first, last] =
      std::minmax_element(found.begin(), found.end(),
                          [](const Meeting& a, const Meeting& b) { return a.range < b.range; });
  return std::array<Meeting, 2>{*first, *last};
}

void TaperedCylinder::meetEnds(const Line& line, std::vector<Meeting>& found) const
{
  if (line.climb == 0) return;
  const auto meetEnd = [&](double height, double radius, double outwards)
  {
    const double way = (height - line.height) / line.climb;
    const TVector3D aside = line.asideAt(way);
    if (dot(aside, aside) <= radius * radius)
      found.push_back({line.start + way, m_axis * outwards});
  };
  meetEnd(0, m_from.radius, -1);
  meetEnd(m_length, m_to.radius, 1);
}

void TaperedCylinder::meetWall(const Line& line, std::vector<Meeting>& found) const
{
  // |aside + way astray| = radius + way widening: a way² + 2 b way + c = 0
  const double radius = m_from.radius + m_taper * line.height, widening = m_taper * line.climb;
  const double a = dot(line.astray, line.astray) - widening * widening;
  const double b = dot(line.aside, line.astray) - radius * widening;
  const double c = dot(line.aside, line.aside) - radius * radius;
  const double discriminant = b * b - a * c;
  if (a == 0 || discriminant < 0) return;
  const double root = std::sqrt(discriminant);
  for (const double way : {(-b - root) / a, (-b + root) / a})
  {
    const double height = line.heightAt(way);
    if (!(height > 0 && height < m_length)) continue;
    TVector3D outwards = line.asideAt(way);
    outwards *= 1 / outwards.norm();
    found.push_back({line.start + way, outwards - m_axis * m_taper});
  }
}

}  // namespace mrpt_mapconv::sim
