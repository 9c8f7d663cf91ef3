#pragma once

#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>

#include "Clamping.h"
#include "KnownRegions.h"

namespace mrpt_mapconv::voxel
{
/** What rays add to log-odds. */
struct RayModel
{
  explicit RayModel(const RayParams& params)
      : hit(logOddsOf(params.probHit)),
        miss(logOddsOf(params.probMiss)),
        // -0, as a bound, would make voxels untouched
        range{static_cast<float>(params.minLogOdds) + 0.0f,
              static_cast<float>(params.maxLogOdds) + 0.0f}
  {
  }
  static float logOddsOf(double probability)
  {
    return static_cast<float>(std::log(probability / (1 - probability)));
  }
  float afterMiss(float logOdds) const { return range.clamp(logOdds + miss); }
  float afterHit(float logOdds) const { return range.clamp(logOdds + hit); }

  float hit, miss;
  ClampingRange range;
};

/** A visitor of rays that updates voxels: the part of the work that one thread does. */
class RayUpdater
{
 public:
  struct Region
  {
    VoxelGrid::Table::Region* slots = nullptr;
    std::array<bool, kRegionBricks> touched{};
  };
  struct Brick
  {
    float* voxels;
    VoxelGrid::Slot* slot;
  };

  /** \param access to the table's hash */
  RayUpdater(VoxelGrid::Table& table, std::mutex& access, const RayModel& model)
      : m_table(table), m_access(access), m_model(model)
  {
    m_nowhere.logOdds.fill(0);
  }

  Region& region(const VoxelKey& key)
  {
    return m_regions(key,
                     [this](const VoxelKey& unknown, Region& region)
                     {
                       const std::lock_guard<std::mutex> lock(m_access);
                       region.slots = &m_table.obtain(unknown);
                     });
  }
  Brick brick(Region& region, std::size_t index)
  {
    VoxelGrid::Slot& slot = (*region.slots)[index];
    region.touched[index] = true;
    if (slot.brick) return {slot.brick->logOdds.data(), &slot};
    // a brick that is as free as can be is not changed by misses
    if (isTouched(slot.value) && m_model.afterMiss(slot.value) == slot.value)
      return {m_nowhere.logOdds.data(), &slot};
    return {slot.expanded().logOdds.data(), &slot};
  }
  void cross(const Brick& brick, std::size_t index)
  {
    float& logOdds = brick.voxels[index];
    logOdds = m_model.afterMiss(logOdds);
  }
  void end(const Brick& brick, std::size_t index)
  {
    if (m_atEnd == RayEnd::Keep) return;
    if (m_atEnd == RayEnd::Clear) return cross(brick, index);
    float& logOdds = brick.slot->expanded().logOdds[index];
    logOdds = m_model.afterHit(logOdds);
  }

  void insert(const GridRay& ray, RayEnd atEnd, const Slab& slab)
  {
    m_atEnd = atEnd;
    walkRay(ray, slab, *this);
  }

  /** Has bricks that are all equal become values. \return the columns of all that were touched */
  ColumnSet finish() const
  {
    ColumnSet columns;
    for (const auto& [key, region] : m_regions.all())
      for (std::size_t i = 0; i < region.touched.size(); ++i)
      {
        if (!region.touched[i]) continue;
        (*region.slots)[i].collapse();
        insertBrick(brickOrigin(key, i), columns);
      }
    return columns;
  }

 private:
  static void insertBrick(const VoxelKey& origin, ColumnSet& columns)
  {
    ColumnMask mask{};
    const auto y = static_cast<std::ptrdiff_t>(origin.y & (kBlockSide - 1));
    std::fill_n(mask.begin() + y, kBrickSide, 0xFFFFu << (origin.x & (kBlockSide - 1)));
    columns.insert(BlockKey{origin.x >> 5, origin.y >> 5}, mask);
  }

  VoxelGrid::Table& m_table;
  std::mutex& m_access;
  RayModel m_model;
  KnownRegions<Region> m_regions;
  VoxelGrid::Brick m_nowhere;
  RayEnd m_atEnd = RayEnd::Keep;
};

/** A visitor of rays that counts the memory that a grid lacks for them, at most. */
class RayMemory
{
 public:
  explicit RayMemory(const VoxelGrid::Table& table) : m_table(table) {}

  struct Region
  {
    const VoxelGrid::Table::Region* slots = nullptr;
    std::array<bool, kRegionBricks> seen{};
  };
  struct Brick
  {
  };

  Region& region(const VoxelKey& key)
  {
    return m_regions(key,
                     [this](const VoxelKey& unknown, Region& region)
                     {
                       region.slots = m_table.find(unknown);
                       if (!region.slots) m_bytes += VoxelGrid::Table::bytesOfRegion();
                     });
  }
  Brick brick(Region& region, std::size_t index)
  {
    if (!region.seen[index] && !(region.slots && (*region.slots)[index].brick))
      m_bytes += sizeof(VoxelGrid::Brick);
    region.seen[index] = true;
    return {};
  }
  void cross(Brick, std::size_t) {}
  void end(Brick, std::size_t) {}

  std::size_t bytes() const { return m_bytes; }

 private:
  const VoxelGrid::Table& m_table;
  KnownRegions<Region> m_regions;
  std::size_t m_bytes = 0;
};

}  // namespace mrpt_mapconv::voxel
