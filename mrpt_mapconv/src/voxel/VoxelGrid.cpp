#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/voxel/VoxelGrid.h>

#include <algorithm>

namespace mrpt_mapconv::voxel
{
namespace
{
std::int32_t bitsOf(float value)
{
  std::int32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}
}  // namespace

VoxelGrid::Brick& VoxelGrid::Slot::expanded()
{
  if (!brick) brick = std::make_unique<Brick>(value);
  return *brick;
}

void VoxelGrid::Slot::collapse()
{
  if (!brick) return;
  const auto& voxels = brick->logOdds;
  const std::int32_t first = bitsOf(voxels.front());
  if (bitsOf(voxels.back()) != first ||
      !std::all_of(voxels.begin(), voxels.end(), [first](float v) { return bitsOf(v) == first; }))
    return;
  value = voxels.front();
  brick.reset();
}

VoxelGrid::VoxelGrid(double resolution) : m_resolution(resolution)
{
  grid::requireResolution(resolution);
}

void VoxelGrid::setResolution(double resolution)
{
  grid::requireResolution(resolution);
  m_resolution = resolution;
}

VoxelGrid::VoxelGrid(const VoxelGrid& o)
    : m_resolution(o.m_resolution), m_occupiedFrom(o.m_occupiedFrom), m_bytesAtMost(o.m_bytesAtMost)
{
  for (const auto& [key, region] : o.m_table.regions())
  {
    auto& copy = m_table.obtain(key);
    for (std::size_t i = 0; i < copy.size(); ++i)
    {
      const Slot& from = (*region)[i];
      if (from.brick) copy[i].brick = std::make_unique<Brick>(*from.brick);
      copy[i].value = from.value;
    }
  }
}

VoxelGrid& VoxelGrid::operator=(const VoxelGrid& o)
{
  if (this != &o) *this = VoxelGrid(o);
  return *this;
}

float VoxelGrid::logOdds(const VoxelKey& voxel) const
{
  const auto* region = m_table.find(regionKey(voxel));
  return region ? (*region)[brickIndex(voxel)].at(voxelIndex(voxel)) : kUntouched;
}

void VoxelGrid::set(const VoxelKey& voxel, float logOdds)
{
  if (bitsOf(this->logOdds(voxel)) == bitsOf(logOdds)) return;
  announce(sizeof(Brick) + Table::bytesOfRegion());
  Slot& slot = m_table.obtain(regionKey(voxel))[brickIndex(voxel)];
  slot.expanded().logOdds[voxelIndex(voxel)] = logOdds;
}

void VoxelGrid::fillCube(const VoxelKey& lowest, std::int32_t side, float logOdds)
{
  constexpr std::int32_t regionSide = 1 << kRegionVoxelBits;
  const auto regions = static_cast<std::size_t>(std::max(1, side / regionSide));
  announce(sizeof(Brick) + regions * regions * regions * Table::bytesOfRegion());
  if (side < kBrickSide)
  {
    auto& voxels = m_table.obtain(regionKey(lowest))[brickIndex(lowest)].expanded().logOdds;
    for (std::int32_t x = 0; x < side; ++x)
      for (std::int32_t y = 0; y < side; ++y)
      {
        const auto column = voxelIndex({lowest.x + x, lowest.y + y, lowest.z});
        std::fill_n(voxels.begin() + static_cast<std::ptrdiff_t>(column), side, logOdds);
      }
    return;
  }
  for (std::int32_t x = 0; x < side; x += kBrickSide)
    for (std::int32_t y = 0; y < side; y += kBrickSide)
      for (std::int32_t z = 0; z < side; z += kBrickSide)
      {
        const VoxelKey at{lowest.x + x, lowest.y + y, lowest.z + z};
        Slot& slot = m_table.obtain(regionKey(at))[brickIndex(at)];
        slot.brick.reset();
        slot.value = logOdds;
      }
}

bool VoxelGrid::empty() const
{
  for (const auto& [key, region] : m_table.regions())
    for (const Slot& slot : *region)
      if (slot.brick
              ? std::any_of(slot.brick->logOdds.begin(), slot.brick->logOdds.end(), isTouched)
              : isTouched(slot.value))
        return false;
  return true;
}

std::size_t VoxelGrid::size() const
{
  std::size_t touched = 0;
  for (const auto& [key, region] : m_table.regions())
    for (const Slot& slot : *region)
      if (slot.brick)
        touched += static_cast<std::size_t>(
            std::count_if(slot.brick->logOdds.begin(), slot.brick->logOdds.end(), isTouched));
      else if (isTouched(slot.value))
        touched += kBrickVoxels;
  return touched;
}

std::size_t VoxelGrid::heapBytes() const
{
  std::size_t bricks = 0;
  for (const auto& [key, region] : m_table.regions())
    bricks += static_cast<std::size_t>(std::count_if(
        region->begin(), region->end(), [](const Slot& s) { return s.brick != nullptr; }));
  return bricks * sizeof(Brick) + m_table.size() * Table::bytesOfRegion();
}

}  // namespace mrpt_mapconv::voxel
