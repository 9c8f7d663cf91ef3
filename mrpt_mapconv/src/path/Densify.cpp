#include "Densify.h"

#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::path
{
namespace
{
constexpr double kSlack =
    1e-9;  // of the spacing: three cells in decimals are three steps, not four
constexpr double kMaxPoints = 1e7;

LiftedPoint pointAt(double x, double y, bool isInput)
{
  LiftedPoint point;
  point.position = {x, y, 0};
  point.isInput = isInput;
  return point;
}

[[noreturn]] void throwTooLong(std::size_t index, double length, double spacing)
{
  std::ostringstream message;
  message << "path point " << index << ": " << params::roundedText(length)
          << " m from the point before it at " << params::roundedText(spacing)
          << " m a cell make more than 10 million points; the path must be shorter";
  throw std::invalid_argument(message.str());
}
}  // namespace

DensePath densify(const std::vector<mrpt::math::TPoint2D>& path, double spacing)
{
  DensePath dense;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const auto& to = path[i];
    double arc = 0;
    if (i > 0)
    {
      const auto& from = path[i - 1];
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      const double steps = std::max(1.0, std::ceil(length / spacing - kSlack));
      if (static_cast<double>(dense.points.size()) + steps > kMaxPoints)
        throwTooLong(i, length, spacing);
      const double before = dense.arc.back();
      const auto count = static_cast<std::size_t>(steps);
      for (std::size_t step = 1; step < count; ++step)
      {
        const double share = static_cast<double>(step) / steps;
        dense.points.push_back(
            pointAt(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), false));
        dense.arc.push_back(before + share * length);
      }
      arc = before + length;
    }
    dense.points.push_back(pointAt(to.x, to.y, true));
    dense.arc.push_back(arc);
  }
  return dense;
}

}  // namespace mrpt_mapconv::path
