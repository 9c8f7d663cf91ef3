#include "VoxelCanvas.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <sstream>

namespace mrpt_mapconv::sim
{
namespace
{
std::size_t length(const KeyBox& box, std::size_t axis)
{
  return static_cast<std::size_t>(std::int64_t(box.max[axis]) - box.min[axis] + 1);
}

// How a `.bt` file writes a child in two bits.
constexpr unsigned kUnknownChild = 0, kFreeLeaf = 1, kOccupiedLeaf = 2, kInnerChild = 3;

unsigned leafOf(voxel::VoxelState state)
{
  if (state == voxel::VoxelState::Free) return kFreeLeaf;
  return state == voxel::VoxelState::Occupied ? kOccupiedLeaf : kUnknownChild;
}
}  // namespace

VoxelCanvas::VoxelCanvas(const KeyBox& box)
    : m_box(box),
      m_sizeY(length(box, 1)),
      m_sizeZ(length(box, 2)),
      m_voxels(length(box, 0) * m_sizeY * m_sizeZ, State::Unknown)
{
}

void VoxelCanvas::fillColumn(std::int32_t x, std::int32_t y, std::int32_t zBegin, std::int32_t zEnd,
                             State state)
{
  zBegin = std::max(zBegin, m_box.min[2]);
  zEnd = std::min(zEnd, m_box.max[2] + 1);
  if (zBegin >= zEnd || !inside(x, y, zBegin)) return;
  std::fill_n(m_voxels.begin() + static_cast<std::ptrdiff_t>(index(x, y, zBegin)), zEnd - zBegin,
              state);
}

void VoxelCanvas::fill(const KeyBox& box, State state)
{
  for (std::int32_t x = box.min[0]; x <= box.max[0]; ++x)
    for (std::int32_t y = box.min[1]; y <= box.max[1]; ++y)
      fillColumn(x, y, box.min[2], box.max[2] + 1, state);
}

bool VoxelCanvas::touchesFree(std::int32_t x, std::int32_t y, std::int32_t z) const
{
  return at(x - 1, y, z) == State::Free || at(x + 1, y, z) == State::Free ||
         at(x, y - 1, z) == State::Free || at(x, y + 1, z) == State::Free ||
         at(x, y, z - 1) == State::Free || at(x, y, z + 1) == State::Free;
}

void VoxelCanvas::forgetUnseen()
{
  std::size_t i = 0;
  for (std::int32_t x = m_box.min[0]; x <= m_box.max[0]; ++x)
    for (std::int32_t y = m_box.min[1]; y <= m_box.max[1]; ++y)
      for (std::int32_t z = m_box.min[2]; z <= m_box.max[2]; ++z, ++i)
        if (m_voxels[i] == State::Occupied && !touchesFree(x, y, z)) m_voxels[i] = State::Unknown;
}

/** Appends the inner node of a cube and all below it; a cube of one state becomes a leaf instead,
 * which its parent writes. \return how the parent writes the cube */
unsigned VoxelCanvas::writeCube(const std::array<std::int32_t, 3>& corner, std::int32_t size,
                                std::string& nodes) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (corner[axis] > m_box.max[axis] || corner[axis] + size <= m_box.min[axis])
      return kUnknownChild;
  if (size == 1) return leafOf(at(corner[0], corner[1], corner[2]));

  const std::size_t mine = nodes.size();
  nodes.append(2, '\0');
  const std::int32_t half = size / 2;
  unsigned children = 0;
  for (unsigned i = 0; i < 8; ++i)
    children |= writeCube({corner[0] + ((i & 1u) ? half : 0), corner[1] + ((i & 2u) ? half : 0),
                           corner[2] + ((i & 4u) ? half : 0)},
                          half, nodes)
                << 2 * i;
  const unsigned first = children & 3u;
  if (first != kInnerChild && children == first * 0x5555u)
  {
    nodes.resize(mine);
    return first;
  }
  nodes[mine] = static_cast<char>(children & 0xFFu);
  nodes[mine + 1] = static_cast<char>(children >> 8);
  return kInnerChild;
}

std::unique_ptr<octomap::OcTree> VoxelCanvas::toOctree(double resolution) const
{
  constexpr std::int32_t kHalfRange = 32768;  // voxel keys are OctoMap's minus this
  auto tree = std::make_unique<octomap::OcTree>(resolution);
  std::string nodes;
  if (writeCube({-kHalfRange, -kHalfRange, -kHalfRange}, 2 * kHalfRange, nodes) != kInnerChild)
    return tree;
  std::istringstream stream(nodes);
  tree->readBinaryData(stream);
  return tree;
}

}  // namespace mrpt_mapconv::sim
