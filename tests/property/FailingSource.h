#pragma once

#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <new>
#include <optional>

namespace mrpt_mapconv::test
{
/** A source that can fail while it is read. */
class FailingSource : public voxel::VoxelSource
{
 public:
  explicit FailingSource(const voxel::VoxelSource& source) : m_source(source) {}
  double resolution() const override { return m_source.resolution(); }
  std::optional<voxel::KeyRect> bounds() const override { return m_source.bounds(); }
  void read(voxel::ColumnBlock& block) const override
  {
    if (m_left && (*m_left)-- <= 0) throw std::bad_alloc();
    m_source.read(block);
  }

  /** Whether some work fails if the source does after so many blocks; then it is well again. */
  template <class Work>
  bool failsIn(int blocks, const Work& work)
  {
    m_left = blocks;
    bool failed = false;
    try
    {
      work();
    }
    catch (const std::bad_alloc&)
    {
      failed = true;
    }
    m_left.reset();
    return failed;
  }

 private:
  const voxel::VoxelSource& m_source;
  mutable std::optional<int> m_left;
};

}  // namespace mrpt_mapconv::test
