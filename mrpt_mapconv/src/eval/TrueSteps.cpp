#include <mrpt_mapconv/eval/TrueSteps.h>
#include <mrpt_mapconv/params/Require.h>

#include <algorithm>
#include <cstddef>

namespace mrpt_mapconv::eval
{
using mrpt::math::TPoint2D;

namespace
{
constexpr double kSpacing = 1e-3;  // [m]
constexpr double kExact = 1e-7;    // [m]

double distance(const TPoint2D& a, const TPoint2D& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/** The ground along a line. */
class Profile
{
 public:
  Profile(const sim::World& world, const TPoint2D& from, const TPoint2D& to)
      : m_world(world),
        m_x(from.x),
        m_y(from.y),
        m_length(distance(from, to)),
        m_alongX((to.x - from.x) / m_length),
        m_alongY((to.y - from.y) / m_length)
  {
  }
  double length() const { return m_length; }
  double alongX() const { return m_alongX; }
  double alongY() const { return m_alongY; }
  double x(double way) const { return m_x + m_alongX * way; }
  double y(double way) const { return m_y + m_alongY * way; }
  /** \return the world's lower bound without a solid */
  double height(double way)
  {
    m_world.solidsAt(x(way), y(way), m_solids);
    return m_solids.empty() ? m_world.min().z : m_solids.front().top;
  }

 private:
  const sim::World& m_world;
  double m_x, m_y;  //!< its start [m]
  double m_length;
  double m_alongX, m_alongY;
  std::vector<sim::Solid> m_solids;
};

struct Jump
{
  double way = 0;   //!< from the line's start [m]
  double rise = 0;  //!< along the line [m]
};

/** Halves a stretch with a jump until it is exact. */
Jump located(Profile& profile, double begin, double end)
{
  double low = profile.height(begin), high = profile.height(end);
  while (end - begin > kExact)
  {
    const double middle = 0.5 * (begin + end), height = profile.height(middle);
    const bool isBefore = std::abs(height - low) < std::abs(high - height);
    (isBefore ? begin : end) = middle;
    (isBefore ? low : high) = height;
  }
  return {0.5 * (begin + end), high - low};
}

std::vector<Jump> jumpsOf(Profile& profile, double jump)
{
  std::vector<Jump> jumps;
  const auto pieces = static_cast<std::size_t>(std::ceil(profile.length() / kSpacing));
  const auto way = [&](std::size_t i)
  { return profile.length() * static_cast<double>(i) / static_cast<double>(pieces); };
  double height = profile.height(0);
  for (std::size_t i = 1; i <= pieces; ++i)
  {
    const double next = profile.height(way(i));
    if (std::abs(next - height) > jump) jumps.push_back(located(profile, way(i - 1), way(i)));
    height = next;
  }
  return jumps;
}

/** Whether a way that leads on from b to c goes straight on from a. */
bool isStraight(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c)
{
  constexpr double kParallel = 1e-6;  // sine of the angle
  const TPoint2D before = b - a, after = c - b;
  const double cross = before.x * after.y - before.y * after.x,
               dot = before.x * after.x + before.y * after.y;
  return dot > 0 && std::abs(cross) <= kParallel * before.norm() * after.norm();
}

/** Where a way begins, turns and ends. */
std::vector<TPoint2D> cornersOf(const sim::Trajectory& way)
{
  std::vector<TPoint2D> corners;
  for (const sim::Trajectory::Knot& knot : way.knots())
  {
    const TPoint2D place(knot.position.x, knot.position.y);
    const std::size_t count = corners.size();
    if (count > 0 && (place - corners.back()).norm() == 0) continue;  // it turns on the spot
    if (count > 1 && isStraight(corners[count - 2], corners.back(), place)) corners.pop_back();
    corners.push_back(place);
  }
  return corners;
}
}  // namespace

std::vector<TrueStep> trueSteps(const sim::World& world, const TPoint2D& from, const TPoint2D& to,
                                double jump)
{
  params::require(jump > 0, "jump", jump, "a height > 0 m");
  params::require(distance(from, to) > 0, "length of the line", distance(from, to), "> 0 m");
  Profile profile(world, from, to);
  const std::vector<Jump> jumps = jumpsOf(profile, jump);
  std::vector<TrueStep> steps;
  for (std::size_t i = 0; i < jumps.size(); ++i)
  {
    const bool isUp = jumps[i].rise > 0;
    const double sign = isUp ? 1 : -1;
    const double way = jumps[i].way;
    TrueStep step{profile.x(way),          profile.y(way),          sign * profile.alongX(),
                  sign * profile.alongY(), std::abs(jumps[i].rise), NAN};
    if (isUp && i + 1 < jumps.size()) step.depth = jumps[i + 1].way - jumps[i].way;
    if (!isUp && i > 0) step.depth = jumps[i].way - jumps[i - 1].way;
    steps.push_back(step);
  }
  return steps;
}

std::vector<TrueStep> trueSteps(const sim::World& world, const sim::Trajectory& way, double jump)
{
  const std::vector<TPoint2D> corners = cornersOf(way);
  std::vector<TrueStep> all;
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    const auto steps = trueSteps(world, corners[i - 1], corners[i], jump);
    all.insert(all.end(), steps.begin(), steps.end());
  }
  return all;
}

std::optional<terrain::TerrainStep> stepFor(const TrueStep& truth,
                                            const std::vector<terrain::TerrainStep>& steps,
                                            double reach)
{
  constexpr double kLeastCosine = 0.9;
  std::optional<terrain::TerrainStep> nearest;
  double least = reach;
  for (const terrain::TerrainStep& step : steps)
  {
    const double x = step.x - truth.x, y = step.y - truth.y;
    const double along = std::abs(x * truth.directionX + y * truth.directionY),
                 across = std::abs(x * truth.directionY - y * truth.directionX);
    if (step.directionX * truth.directionX + step.directionY * truth.directionY < kLeastCosine ||
        across > step.width / 2 + reach || along > least)
      continue;
    least = along;
    nearest = step;
  }
  return nearest;
}

std::vector<StepMatch> matchSteps(const std::vector<TrueStep>& truth,
                                  const terrain::TerrainMap& map)
{
  constexpr double kReach = 0.1;  // [m], less than half a tread
  const auto steps = map.steps();
  std::vector<StepMatch> matches;
  for (const TrueStep& step : truth) matches.push_back({step, stepFor(step, steps, kReach)});
  return matches;
}

}  // namespace mrpt_mapconv::eval
