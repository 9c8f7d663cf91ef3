#pragma once

#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace octomap
{
class OcTree;
}

namespace mrpt_mapconv::sim
{
/** A box of voxel keys, both corners included. */
struct KeyBox
{
  std::array<std::int32_t, 3> min, max;
};

/** A box of voxels to paint on, one byte each, that becomes an octree in the end. Painting outside
 * the box does nothing. Voxels have the keys of voxel::VoxelSource. */
class VoxelCanvas
{
 public:
  using State = voxel::VoxelState;

  /** \param box both corners included; all voxels start unknown */
  explicit VoxelCanvas(const KeyBox& box);

  const KeyBox& box() const { return m_box; }
  /** Unknown outside the box. */
  State at(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return inside(x, y, z) ? m_voxels[index(x, y, z)] : State::Unknown;
  }
  void set(std::int32_t x, std::int32_t y, std::int32_t z, State state)
  {
    if (inside(x, y, z)) m_voxels[index(x, y, z)] = state;
  }
  /** Paints the voxels [zBegin, zEnd) of a column. */
  void fillColumn(std::int32_t x, std::int32_t y, std::int32_t zBegin, std::int32_t zEnd,
                  State state);
  /** Paints a box, both corners included. */
  void fill(const KeyBox& box, State state);

  /** Makes occupied voxels unknown that share no face with a free one: no sensor sees the inside
   * of a wall. */
  void forgetUnseen();

  /** The pruned tree, as OctoMap would have read it from a `.bt` file. */
  std::unique_ptr<octomap::OcTree> toOctree(double resolution) const;

 private:
  bool inside(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return x >= m_box.min[0] && y >= m_box.min[1] && z >= m_box.min[2] && x <= m_box.max[0] &&
           y <= m_box.max[1] && z <= m_box.max[2];
  }
  std::size_t index(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return (static_cast<std::size_t>(x - m_box.min[0]) * m_sizeY +
            static_cast<std::size_t>(y - m_box.min[1])) *
               m_sizeZ +
           static_cast<std::size_t>(z - m_box.min[2]);
  }
  bool touchesFree(std::int32_t x, std::int32_t y, std::int32_t z) const;
  unsigned writeCube(const std::array<std::int32_t, 3>& corner, std::int32_t size,
                     std::string& nodes) const;

  KeyBox m_box;
  std::size_t m_sizeY, m_sizeZ;
  std::vector<State> m_voxels;
};

}  // namespace mrpt_mapconv::sim
