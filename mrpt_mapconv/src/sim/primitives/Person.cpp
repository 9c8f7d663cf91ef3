#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "../SectionKeys.h"
#include "../UprightCylinder.h"

namespace mrpt_mapconv::sim
{
namespace
{
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;
using mrpt::math::TVector3D;

/** There and back again along a line with corners, for ever. */
class Walk
{
 public:
  /** \param line two points or more \param speed [m/s] \param ahead time that has already been
   * walked at the start [s] */
  Walk(std::vector<TPoint2D> line, double speed, double ahead)
      : m_line(std::move(line)), m_speed(speed), m_ahead(ahead)
  {
    for (std::size_t i = 1; i < m_line.size(); ++i) m_length += legTo(i);
  }

  const std::vector<TPoint2D>& line() const { return m_line; }
  double length() const { return m_length; }  //!< one way [m]

  /** \param seconds since the start */
  TPoint2D placeAt(double seconds) const
  {
    const double round = std::fmod(m_speed * (seconds + m_ahead), 2 * m_length);
    double way = std::min(round, 2 * m_length - round);
    std::size_t next = 1;
    while (next + 1 < m_line.size() && way > legTo(next)) way -= legTo(next++);
    const double share = legTo(next) > 0 ? std::min(way / legTo(next), 1.0) : 0.0;
    return m_line[next - 1] + (m_line[next] - m_line[next - 1]) * share;
  }

 private:
  double legTo(std::size_t i) const
  {
    return std::hypot(m_line[i].x - m_line[i - 1].x, m_line[i].y - m_line[i - 1].y);
  }

  std::vector<TPoint2D> m_line;
  double m_speed, m_ahead;
  double m_length = 0;
};

/** Somebody who walks: an upright cylinder. path: x y x y … [m], walked to its end and back for
 * ever; speed [m/s]; height, radius [m], default 1.75 and 0.2; base: z of the feet [m], default 0;
 * start: how long the walk has lasted when the run begins [s], default 0.
 *
 * Nobody gets out of the way, neither people nor the robot: a sensor that is inside sees out. */
class Person : public Primitive, public CurvedSurface, public Motion
{
 public:
  /** \param body where the walk's line begins */
  Person(const UprightCylinder& body, Walk walk) : m_body(body), m_walk(std::move(walk)) {}

  static std::unique_ptr<Primitive> read(params::StrictSection& section)
  {
    const auto line = readLine(section, "path");
    const double speed = readPositive(section, "speed");
    double start = 0;
    section.read("start", start);
    if (start < 0) section.fail("start", "a number >= 0 [s]");
    Walk walk(line, speed, start);
    if (!(walk.length() > 0)) section.fail("path", "a line that leads to another place");

    const double base = section.has("base") ? readNumber(section, "base") : 0;
    const double radius = readPositive(section, "radius", 0.2);
    const UprightCylinder body({line[0].x, line[0].y, base}, radius,
                               readPositive(section, "height", 1.75));
    return std::make_unique<Person>(body, std::move(walk));
  }

  Footprint footprint() const override
  {
    const TPoint2D& begin = m_walk.line()[0];
    const Footprint first = m_body.footprint();
    Footprint all = first;
    for (const TPoint2D& place : m_walk.line())
    {
      const double x = place.x - begin.x, y = place.y - begin.y;
      all = {std::min(all.xMin, first.xMin + x), std::min(all.yMin, first.yMin + y),
             std::max(all.xMax, first.xMax + x), std::max(all.yMax, first.yMax + y)};
    }
    return all;
  }
  void appendMesh(Mesh& mesh) const override { m_body.appendMesh(mesh); }
  /** None: who walks on is no part of what is true of a place. */
  void appendSolids(double, double, std::vector<Solid>&) const override {}
  const CurvedSurface* curved() const override { return this; }
  const Motion* motion() const override { return this; }

  std::array<TPoint3D, 2> bounds() const override { return m_body.bounds(); }
  std::optional<Meeting> meet(const TPoint3D& origin, const TVector3D& direction, double minRange,
                              double maxRange) const override
  {
    auto meeting = m_body.meet(origin, direction, minRange, maxRange);
    if (!meeting) return {};
    const TVector3D& n = meeting->outwards;
    const bool fromInside = n.x * direction.x + n.y * direction.y + n.z * direction.z > 0;
    return fromInside ? std::nullopt : meeting;
  }

  TVector3D shiftAt(double seconds) const override
  {
    const TPoint2D place = m_walk.placeAt(seconds), begin = m_walk.line()[0];
    return {place.x - begin.x, place.y - begin.y, 0};
  }

 private:
  UprightCylinder m_body;
  Walk m_walk;
};

const PrimitiveKind kKind("person", Person::read);
}  // namespace
}  // namespace mrpt_mapconv::sim
