#include <mrpt_mapconv/voxel/UnknownVoxels.h>

namespace mrpt_mapconv::voxel
{
FilledSource::FilledSource(const VoxelSource& source, const ReadingParams& params)
    : m_source(source)
{
  if (params.unknown == Unknown::Free) m_freeUpTo = source.top();
}

void FilledSource::read(ColumnBlock& block) const
{
  m_source.read(block);
  if (m_freeUpTo) block.freeUnknownAboveOccupied(*m_freeUpTo);
}

}  // namespace mrpt_mapconv::voxel
