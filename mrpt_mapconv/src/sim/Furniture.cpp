#include "Furniture.h"

#include <algorithm>

namespace mrpt_mapconv::sim
{
using mrpt::math::TPoint2D;
using mrpt::math::TPoint3D;

namespace
{
constexpr double kDegree = 3.14159265358979323846 / 180;
}  // namespace

Furniture::Furniture(params::StrictSection& section, const TPoint2D& middle)
{
  double yaw = 0;
  section.read("yaw", yaw);
  const double base = section.has("base") ? readNumber(section, "base") : 0;
  m_pose = {middle.x, middle.y, base, yaw * kDegree, 0, 0};
}

void Furniture::add(const Corners& part)
{
  TPoint3D centre;
  m_pose.composePoint(part.centre(), centre);
  m_parts.emplace_back(centre, part.size(), m_pose.yaw);
}

void Furniture::addLegs(const TPoint2D& size, double leg, double top)
{
  const double x = (size.x - leg) / 2, y = (size.y - leg) / 2, half = leg / 2;
  for (const auto& [u, v] : {TPoint2D(-x, -y), {x, -y}, {x, y}, {-x, y}})
    add({{u - half, v - half, 0}, {u + half, v + half, top}});
}

Footprint Furniture::footprint() const
{
  Footprint all = m_parts.front().footprint();
  for (const Block& part : m_parts)
  {
    const Footprint area = part.footprint();
    all = {std::min(all.xMin, area.xMin), std::min(all.yMin, area.yMin),
           std::max(all.xMax, area.xMax), std::max(all.yMax, area.yMax)};
  }
  return all;
}

void Furniture::appendMesh(Mesh& mesh) const
{
  for (const Block& part : m_parts) part.appendMesh(mesh);
}

void Furniture::appendSolids(double x, double y, std::vector<Solid>& solids) const
{
  for (const Block& part : m_parts) part.appendSolids(x, y, solids);
}

}  // namespace mrpt_mapconv::sim
