#include "Tunnels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "SectionKeys.h"

namespace mrpt_mapconv::sim
{
namespace
{
using mrpt::math::TPoint2D;

/** One size for all tunnels or one for each. */
std::vector<double> readSizes(params::StrictSection& section, const std::string& key,
                              std::size_t count)
{
  const std::string right = "one number > 0 [m], or one for each arch";
  std::vector<double> sizes;
  section.read(key, sizes);
  if (sizes.size() == 1) sizes.resize(count, sizes[0]);
  if (sizes.size() != count) section.fail(key, right);
  for (const double size : sizes)
    if (!(size > 0)) section.fail(key, right);
  return sizes;
}

double distanceToSegment(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b)
{
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double share =
      square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

double distanceToLine(const TPoint2D& p, const std::vector<TPoint2D>& line)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(p, line[i - 1], line[i]));
  return nearest;
}
}  // namespace

Tunnels Tunnels::read(params::StrictSection& section)
{
  Tunnels tunnels;
  for (std::size_t i = 1; section.has("arch_" + std::to_string(i)); ++i)
    tunnels.m_tunnels.push_back({readLine(section, "arch_" + std::to_string(i))});
  if (tunnels.empty()) return tunnels;
  const auto widths = readSizes(section, "archWidth", tunnels.m_tunnels.size());
  const auto heights = readSizes(section, "archHeight", tunnels.m_tunnels.size());
  for (std::size_t i = 0; i < tunnels.m_tunnels.size(); ++i)
  {
    tunnels.m_tunnels[i].width = widths[i];
    tunnels.m_tunnels[i].height = heights[i];
  }
  return tunnels;
}

double Tunnels::vaultAt(const TPoint2D& place) const
{
  double highest = 0;
  for (const auto& tunnel : m_tunnels)
  {
    const double share = distanceToLine(place, tunnel.line) / (tunnel.width / 2);
    if (share >= 1) continue;
    // flatter above and steeper at the sides than an ellipse, as where people can walk
    highest = std::max(highest, tunnel.height * std::sqrt(1 - std::pow(share, 4)));
  }
  return highest;
}

}  // namespace mrpt_mapconv::sim
