#pragma once

#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>

#include "Clamping.h"
#include "KnownRegions.h"
#include "MemoryLimit.h"

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
  /** Whether all of a brick is as free as can be, so that misses need not write to it. */
  bool isFreest(const VoxelGrid::Slot& slot) const
  {
    return !slot.brick && isTouched(slot.value) && afterMiss(slot.value) == slot.value;
  }

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
    if (m_model.isFreest(slot)) return {m_nowhere.logOdds.data(), &slot};
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
  VoxelGrid::Brick m_nowhere{0};
  RayEnd m_atEnd = RayEnd::Keep;
};

/** A visitor of rays that counts the memory that a grid lacks for them. */
class RayMemory
{
 public:
  RayMemory(VoxelGrid& grid, const RayModel& model, const std::optional<std::int32_t>& maxMemory)
      : m_grid(grid),
        m_model(model),
        m_maxMemory(maxMemory),
        m_most(params::memoryLimit(maxMemory) + kBeyond)
  {
  }

  struct Region
  {
    const VoxelGrid::Table::Region* slots = nullptr;
    std::array<bool, kRegionBricks> counted{};
  };
  struct Brick
  {
    Region* region;
    std::size_t index;
  };

  Region& region(const VoxelKey& key)
  {
    return m_regions(key,
                     [this](const VoxelKey& unknown, Region& region)
                     {
                       region.slots = std::as_const(m_grid).table().find(unknown);
                       if (!region.slots) add(VoxelGrid::Table::bytesOfRegion());
                     });
  }
  Brick brick(Region& region, std::size_t index)
  {
    const Brick brick{&region, index};
    if (!region.slots || !m_model.isFreest((*region.slots)[index])) write(brick);
    return brick;
  }
  void cross(const Brick&, std::size_t) {}
  void end(const Brick& brick, std::size_t)
  {
    if (m_atEnd == RayEnd::Hit) write(brick);
  }

  /** \exception std::runtime_error as reserve(), once this is far from fitting */
  void count(const GridRay& ray, RayEnd atEnd)
  {
    m_atEnd = atEnd;
    walkRay(ray, {}, *this);
  }
  /** Announces what the rays that were counted need.
   * \exception std::runtime_error if that is more than maxMemory */
  void reserve() { reserveMemory(m_grid, m_bytes, m_maxMemory); }

 private:
  /** How far beyond maxMemory it is counted [bytes], so that the complaint can tell what would do:
   * rays may go through all keys, which would take minutes and much memory to count. */
  static constexpr std::size_t kBeyond = 4'000'000'000;

  void write(const Brick& brick)
  {
    bool& counted = brick.region->counted[brick.index];
    if (!counted && !(brick.region->slots && (*brick.region->slots)[brick.index].brick))
      add(sizeof(VoxelGrid::Brick));
    counted = true;
  }
  void add(std::size_t bytes)
  {
    m_bytes += bytes;
    if (m_bytes > m_most) reserve();
  }

  VoxelGrid& m_grid;
  const RayModel& m_model;
  const std::optional<std::int32_t>& m_maxMemory;
  std::size_t m_most, m_bytes = 0;
  KnownRegions<Region> m_regions;
  RayEnd m_atEnd = RayEnd::Keep;
};

}  // namespace mrpt_mapconv::voxel
