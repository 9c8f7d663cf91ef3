#include "Block.h"

#include <cmath>

#include "MeshBuilder.h"

namespace mrpt_mapconv::sim
{
Block::Block(const mrpt::math::TPoint3D& centre, const mrpt::math::TPoint3D& size, double yaw)
    : m_centre(centre), m_half(size * 0.5), m_cos(std::cos(yaw)), m_sin(std::sin(yaw))
{
}

Footprint Block::footprint() const
{
  const double x = std::abs(m_cos) * m_half.x + std::abs(m_sin) * m_half.y;
  const double y = std::abs(m_sin) * m_half.x + std::abs(m_cos) * m_half.y;
  return {m_centre.x - x, m_centre.y - y, m_centre.x + x, m_centre.y + y};
}

void Block::appendMesh(Mesh& mesh) const
{
  std::array<MeshBuilder::Point2, 4> corners;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double u = (i == 1 || i == 2 ? 1 : -1) * m_half.x, v = (i >= 2 ? 1 : -1) * m_half.y;
    corners[i] = {m_centre.x + m_cos * u - m_sin * v, m_centre.y + m_sin * u + m_cos * v};
  }
  MeshBuilder(mesh).prism({corners.begin(), corners.end()}, m_centre.z - m_half.z,
                          m_centre.z + m_half.z);
}

void Block::appendSolids(double x, double y, std::vector<Solid>& solids) const
{
  const double dx = x - m_centre.x, dy = y - m_centre.y;
  const double u = m_cos * dx + m_sin * dy, v = m_cos * dy - m_sin * dx;
  if (std::abs(u) > m_half.x || std::abs(v) > m_half.y) return;
  solids.push_back({m_centre.z - m_half.z, m_centre.z + m_half.z, 0});
}

}  // namespace mrpt_mapconv::sim
