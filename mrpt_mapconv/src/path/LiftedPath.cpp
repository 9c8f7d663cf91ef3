#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/path/LiftPath.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::path
{
using params::require;

namespace
{
std::string place(const mrpt::math::TPoint2D& at, const mrpt::math::TPoint3D& origin)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << '(' << at.x + origin.x << ", " << at.y + origin.y
       << ')';
  return text.str();
}

std::string reason(const LiftedPoint& point, const mrpt::math::TPoint3D& origin)
{
  switch (point.problem)
  {
    case Infeasibility::None:
      break;
    case Infeasibility::OffMap:
      return "it lies outside the map";
    case Infeasibility::NoFloor:
      return "no floor there";
    case Infeasibility::UnseenGround:
      return freespace::evidence::kOpenInWords;
    case Infeasibility::Wall:
      return "the safety sphere reaches the occupied cell at " + place(point.obstacle, origin);
    case Infeasibility::Unknown:
      return "the safety sphere reaches the unknown cell at " + place(point.obstacle, origin);
    case Infeasibility::NoHeight:
      return "the safety sphere fits in at no height";
  }
  return {};
}
}  // namespace

void LiftParams::check(double minClearance) const
{
  require(std::isfinite(lookahead) && lookahead >= 0, "lookahead", lookahead,
          "a finite distance ≥ 0 m");
  require(std::isfinite(heightOffset) && heightOffset >= 0, "heightOffset", heightOffset,
          "a finite height ≥ 0 m");
  if (robot == freespace::Robot::Ground) return;
  std::ostringstream right;
  right << "above 0 m and at most minClearance/2 = " << minClearance / 2 << " m";
  require(safetyRadius > 0 && safetyRadius <= minClearance / 2, "safetyRadius", safetyRadius,
          right.str());
}

std::optional<std::size_t> LiftedPath::firstProblem() const
{
  const auto found =
      std::find_if(points.begin(), points.end(),
                   [](const LiftedPoint& point) { return point.problem != Infeasibility::None; });
  if (found == points.end()) return std::nullopt;
  return static_cast<std::size_t>(found - points.begin());
}

double LiftedPath::length() const
{
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    sum += (points[i].position - points[i - 1].position).norm();
  return sum;
}

double LiftedPath::length2D() const
{
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    sum += std::hypot(points[i].position.x - points[i - 1].position.x,
                      points[i].position.y - points[i - 1].position.y);
  return sum;
}

std::string LiftedPath::describeProblem(std::size_t index) const
{
  const LiftedPoint& point = points.at(index);
  if (point.problem == Infeasibility::None) return {};
  return "point " + std::to_string(index) + " at " +
         place({point.position.x, point.position.y}, shownOrigin) + ": " +
         reason(point, shownOrigin);
}

}  // namespace mrpt_mapconv::path
