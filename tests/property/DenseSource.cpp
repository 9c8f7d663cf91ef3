#include "DenseSource.h"

namespace mrpt_mapconv::test
{
using oracle::DenseMap;
using oracle::Voxel;

namespace
{
bool anyKnown(const DenseMap& map, int ix, int iy)
{
  for (int iz = 0; iz < map.nz; ++iz)
    if (map.at(ix, iy, iz) != Voxel::Unknown) return true;
  return false;
}
}  // namespace

std::optional<voxel::KeyRect> DenseSource::bounds() const
{
  voxel::KeyRect rect{m_map.x0 + m_map.nx, m_map.y0 + m_map.ny, m_map.x0 - 1, m_map.y0 - 1};
  for (int iy = 0; iy < m_map.ny; ++iy)
    for (int ix = 0; ix < m_map.nx; ++ix)
    {
      if (!anyKnown(m_map, ix, iy)) continue;
      rect.xMin = std::min(rect.xMin, m_map.x0 + ix),
      rect.xMax = std::max(rect.xMax, m_map.x0 + ix);
      rect.yMin = std::min(rect.yMin, m_map.y0 + iy),
      rect.yMax = std::max(rect.yMax, m_map.y0 + iy);
    }
  if (rect.xMax < rect.xMin) return std::nullopt;
  return rect;
}

void DenseSource::read(voxel::ColumnBlock& block) const
{
  block.setHeight(m_map.z0, m_map.z0 + m_map.nz);
  for (std::int32_t y = 0; y < voxel::kBlockSide; ++y)
    for (std::int32_t x = 0; x < voxel::kBlockSide; ++x)
    {
      const int ix = block.key().x * voxel::kBlockSide + x - m_map.x0;
      const int iy = block.key().y * voxel::kBlockSide + y - m_map.y0;
      if (ix < 0 || iy < 0 || ix >= m_map.nx || iy >= m_map.ny) continue;
      for (int iz = 0; iz < m_map.nz; ++iz)
        if (const Voxel voxel = m_map.at(ix, iy, iz); voxel != Voxel::Unknown)
          block.markCube<1>(x, y, m_map.z0 + iz, voxel == Voxel::Occupied);
    }
}

DenseMap trimmed(const DenseMap& map)
{
  const voxel::KeyRect rect = DenseSource(map).bounds().value();
  DenseMap part;
  part.resolution = map.resolution;
  part.x0 = rect.xMin, part.y0 = rect.yMin, part.z0 = map.z0;
  part.nx = rect.xMax - rect.xMin + 1, part.ny = rect.yMax - rect.yMin + 1, part.nz = map.nz;
  part.voxels.resize(static_cast<std::size_t>(part.nx) * static_cast<std::size_t>(part.ny) *
                     static_cast<std::size_t>(part.nz));
  for (int iy = 0; iy < part.ny; ++iy)
    for (int ix = 0; ix < part.nx; ++ix)
      for (int iz = 0; iz < part.nz; ++iz)
        part.at(ix, iy, iz) = map.at(part.x0 - map.x0 + ix, part.y0 - map.y0 + iy, iz);
  return part;
}

}  // namespace mrpt_mapconv::test
