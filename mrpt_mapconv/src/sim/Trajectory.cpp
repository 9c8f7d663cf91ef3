#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>
#include <mrpt_mapconv/sim/Trajectory.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint3D;
using Knot = Trajectory::Knot;

namespace
{
constexpr double kGroundStep = 0.05;  //!< how densely the ground is looked at along the way [m]

[[noreturn]] void failAt(std::size_t i, const TPoint3D& place, const std::string& what)
{
  throw std::invalid_argument("way-point " + std::to_string(i + 1) + " at " + placeText(place) +
                              " " + what);
}

/** The robot's height where the lowest solid with enough room above it is; none: nothing. */
std::optional<double> heightOnGround(const World& world, const Drive& drive, double x, double y)
{
  std::vector<Solid> solids;
  world.solidsAt(x, y, solids);
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    const bool last = i + 1 == solids.size();
    const double above = last ? std::numeric_limits<double>::infinity() : solids[i + 1].bottom;
    if (above - solids[i].top >= drive.height + drive.headroom) return solids[i].top + drive.height;
  }
  return std::nullopt;
}

TPoint3D placeBetween(const TPoint3D& a, const TPoint3D& b, double share)
{
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)};
}

/** Drives from way-point to way-point. */
class Driver
{
 public:
  Driver(const std::vector<TPoint3D>& wayPoints, const Drive& drive, const World& world)
      : m_wayPoints(wayPoints), m_drive(drive), m_world(world)
  {
  }

  std::vector<Knot> drive()
  {
    TPoint3D place = m_wayPoints.front();
    if (m_drive.followGround) place.z = groundAt(0, place);
    for (std::size_t i = 0; i + 1 < m_wayPoints.size(); ++i)
    {
      turnTo(m_wayPoints[i + 1], i, place);
      place = goTo(m_wayPoints[i + 1], i, place);
    }
    if (m_drive.followGround) raiseBeforeSteps();
    return std::move(m_knots);
  }

 private:
  /** Lifts each knot to the higher of its neighbours: between a foot and a top of a step the
   * straight line would lead through the step. */
  void raiseBeforeSteps()
  {
    const auto low = m_knots;
    for (std::size_t k = 0; k < low.size(); ++k)
    {
      double& z = m_knots[k].position.z;
      if (k > 0) z = std::max(z, low[k - 1].position.z);
      if (k + 1 < low.size()) z = std::max(z, low[k + 1].position.z);
    }
  }

  double groundAt(std::size_t i, const TPoint3D& place) const
  {
    const auto z = heightOnGround(m_world, m_drive, place.x, place.y);
    if (!z) failAt(i, place, "leads to where no ground has enough room for the robot above it");
    return *z;
  }

  void turnTo(const TPoint3D& target, std::size_t i, const TPoint3D& place)
  {
    const double dx = target.x - place.x, dy = target.y - place.y;
    const bool vertical = dx == 0 && dy == 0;
    if (m_knots.empty())
    {
      m_yaw = vertical ? 0 : std::atan2(dy, dx);
      add(0, place, i);
      return;
    }
    if (vertical) return;
    const double turn = mrpt::math::wrapToPi(std::atan2(dy, dx) - m_yaw);
    if (std::abs(turn) < 1e-12) return;
    m_yaw += turn;
    add(std::abs(turn) / m_drive.turnRate, place, i);
  }

  /** \return where that is */
  TPoint3D goTo(const TPoint3D& target, std::size_t i, const TPoint3D& start)
  {
    TPoint3D end = target;
    if (m_drive.followGround) end.z = start.z;
    const double length = start.distanceTo(end);
    if (!(length > 1e-9)) failAt(i + 1, target, "must not be where the way-point before it is");
    const int steps = m_drive.followGround ? static_cast<int>(std::ceil(length / kGroundStep)) : 1;
    TPoint3D place = start;
    for (int k = 1; k <= steps; ++k)
    {
      place = k == steps ? target : placeBetween(start, end, static_cast<double>(k) / steps);
      if (m_drive.followGround) place.z = groundAt(i, place);
      add(length / steps / m_drive.speed, place, k == steps ? i + 1 : i);
    }
    return place;
  }

  void add(double passed, const TPoint3D& place, std::size_t i)
  {
    m_time += passed;
    m_knots.push_back({m_time, place, m_yaw, 0, 0, static_cast<int>(i) + 1});
  }

  const std::vector<TPoint3D>& m_wayPoints;
  const Drive& m_drive;
  const World& m_world;
  std::vector<Knot> m_knots;
  double m_time = 0, m_yaw = 0;
};

double readPositive(params::StrictSection& section, const std::string& key, double value)
{
  section.read(key, value);
  if (!(value > 0)) section.fail(key, "a number > 0");
  return value;
}

/** Rows of `columns` numbers each, at least two. */
std::vector<std::vector<double>> readRows(params::StrictSection& section, const std::string& key,
                                          std::size_t columns, const std::string& meaning)
{
  std::vector<double> numbers;
  section.read(key, numbers);
  if (numbers.size() % columns != 0 || numbers.size() < 2 * columns)
    section.fail(key, "at least two times " + meaning);
  std::vector<std::vector<double>> rows;
  for (auto it = numbers.begin(); it != numbers.end(); it += static_cast<std::ptrdiff_t>(columns))
    rows.emplace_back(it, it + static_cast<std::ptrdiff_t>(columns));
  return rows;
}

Trajectory readDrive(params::StrictSection& section, const World& world)
{
  Drive drive;
  drive.speed = readPositive(section, "speed", 0);
  drive.turnRate = mrpt::DEG2RAD(readPositive(section, "turnRate", 45));
  section.read("followGround", drive.followGround);
  if (drive.followGround)
  {
    section.read("height", drive.height);
    if (drive.height < 0) section.fail("height", "a number >= 0");
    section.read("headroom", drive.headroom);
    if (drive.headroom < 0) section.fail("headroom", "a number >= 0");
  }
  std::vector<TPoint3D> wayPoints;
  const auto rows = drive.followGround ? readRows(section, "waypoints", 2, "x y [m]")
                                       : readRows(section, "waypoints", 3, "x y z [m]");
  wayPoints.reserve(rows.size());
  for (const auto& row : rows)
    wayPoints.emplace_back(row[0], row[1], drive.followGround ? 0 : row[2]);
  try
  {
    return Trajectory::along(wayPoints, drive, world);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("section '" + section.name() + "': waypoints: " + error.what());
  }
}

/** The angle [rad] that differs from `before` by at most half a turn. */
double continued(double degrees, double before)
{
  return before + mrpt::math::wrapToPi(mrpt::DEG2RAD(degrees) - before);
}

Trajectory readPoses(params::StrictSection& section)
{
  std::vector<Knot> knots;
  const auto rows = readRows(section, "poses", 7, "t x y z yaw pitch roll [s, m, degrees]");
  for (const auto& row : rows)
  {
    Knot knot;
    knot.time = row[0] - rows.front()[0];
    knot.position = {row[1], row[2], row[3]};
    const Knot before = knots.empty() ? Knot() : knots.back();
    knot.yaw = continued(row[4], before.yaw);
    knot.pitch = continued(row[5], before.pitch);
    knot.roll = continued(row[6], before.roll);
    knot.number = before.number + 1;
    if (!knots.empty() && !(knot.time > before.time))
      throw std::runtime_error("section '" + section.name() + "': poses: the time of pose " +
                               std::to_string(knot.number) + ", " + std::to_string(row[0]) +
                               " s, must be later than that of the pose before it");
    knots.push_back(knot);
  }
  return Trajectory(std::move(knots));
}
}  // namespace

std::string placeText(const TPoint3D& point)
{
  std::ostringstream text;
  text << '(' << point.x << ", " << point.y << ", " << point.z << ')';
  return text.str();
}

Trajectory Trajectory::read(params::StrictSection& section, const World& world)
{
  const bool poses = section.has("poses");
  if (poses && section.has("waypoints"))
    section.fail("poses", "left out where waypoints are given");
  Trajectory trajectory = poses ? readPoses(section) : readDrive(section, world);
  section.refuseUnknown(poses ? "a list of poses" : "a way along way-points");
  return trajectory;
}

Trajectory Trajectory::along(const std::vector<TPoint3D>& wayPoints, const Drive& drive,
                             const World& world)
{
  return Trajectory(Driver(wayPoints, drive, world).drive());
}

mrpt::poses::CPose3D Trajectory::poseAt(double time) const
{
  const auto next = std::upper_bound(m_knots.begin(), m_knots.end(), time,
                                     [](double t, const Knot& knot) { return t < knot.time; });
  const auto poseOf = [](const Knot& k) {
    return mrpt::poses::CPose3D(k.position.x, k.position.y, k.position.z, k.yaw, k.pitch, k.roll);
  };
  if (next == m_knots.begin()) return poseOf(m_knots.front());
  if (next == m_knots.end()) return poseOf(m_knots.back());
  const Knot &a = *std::prev(next), &b = *next;
  const double share = (time - a.time) / (b.time - a.time);
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  return poseOf({time, placeBetween(a.position, b.position, share), between(a.yaw, b.yaw),
                 between(a.pitch, b.pitch), between(a.roll, b.roll), a.number});
}

bool Trajectory::isFlat() const
{
  return std::all_of(m_knots.begin(), m_knots.end(),
                     [](const Knot& k)
                     { return k.position.z == 0 && k.pitch == 0 && k.roll == 0; });
}

}  // namespace mrpt_mapconv::sim
