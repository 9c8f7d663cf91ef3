#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "../grid/Parallel.h"
#include "Clamping.h"
#include "KnownRegions.h"
#include "MemoryLimit.h"
#include "RaySlabs.h"

namespace mrpt_mapconv::voxel
{
using params::require;

void RayParams::check() const
{
  require(probHit >= 0.5 && probHit < 1, "probHit", probHit, "at least 0.5 and below 1");
  require(probMiss > 0 && probMiss <= 0.5, "probMiss", probMiss, "above 0 and at most 0.5");
  require(std::isfinite(minLogOdds) && minLogOdds <= 0, "minLogOdds", minLogOdds,
          "at most 0, the log-odds of a voxel that was never touched");
  require(std::isfinite(maxLogOdds) && maxLogOdds >= 0, "maxLogOdds", maxLogOdds,
          "at least 0, the log-odds of a voxel that was never touched");
  require(minLogOdds < maxLogOdds, "maxLogOdds", maxLogOdds, "above minLogOdds");
  require(std::isfinite(maxRange) && (maxRange > 0 || maxRange == -1), "maxRange", maxRange,
          "a range > 0 m, or -1 for no limit");
  require(!maxMemory || *maxMemory > 0, "maxMemory", maxMemory.value_or(0), "above 0 MB, or auto");
}

namespace
{
using Slot = VoxelGrid::Slot;

/** What rays add to log-odds. */
struct RayModel
{
  explicit RayModel(const RayParams& params)
      : hit(logOddsOf(params.probHit)),
        miss(logOddsOf(params.probMiss)),
        range{static_cast<float>(params.minLogOdds), static_cast<float>(params.maxLogOdds)}
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

class Snapper
{
 public:
  Snapper(double resolution, double maxRange)
      : m_scale(static_cast<double>(kRayUnits) / resolution), m_maxRange(maxRange)
  {
  }

  /** \return false for a ray that is not finite
   * \exception std::out_of_range beyond the keys' range */
  bool snap(const Ray& ray, GridRay& snapped, RayEnd& atEnd) const
  {
    if (!isFinite(ray.origin) || !isFinite(ray.end)) return false;
    auto end = ray.end;
    if (m_maxRange > 0)
    {
      const auto beam = ray.end - ray.origin;
      const double length = beam.norm();
      if (length > m_maxRange)
      {
        end = ray.origin + beam * (m_maxRange / length);
        atEnd = RayEnd::Clear;
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      snapped.from[i] = unitsOf(ray.origin[i]);
      snapped.to[i] = unitsOf(end[i]);
    }
    return true;
  }

 private:
  static bool isFinite(const mrpt::math::TPoint3D& p)
  {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }
  std::int64_t unitsOf(double metres) const
  {
    constexpr double most = 2147483648.0 * static_cast<double>(kRayUnits);
    const double units = std::floor(metres * m_scale + 0.5);
    if (units >= -most && units < most) return static_cast<std::int64_t>(units);
    throw std::out_of_range(std::to_string(metres) + " m is " +
                            std::to_string(metres * m_scale / static_cast<double>(kRayUnits)) +
                            " voxels from the map's origin; 2^31 is the limit");
  }

  double m_scale, m_maxRange;
};

/** A visitor of rays that updates voxels: the part of the work that one thread does. */
class Updater
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
    Slot* slot;
  };

  /** \param access to the table's hash */
  Updater(VoxelGrid::Table& table, std::mutex& access, const RayModel& model)
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
    Slot& slot = (*region.slots)[index];
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

/** A visitor of rays that counts what a grid lacks. */
class Counter
{
 public:
  explicit Counter(const VoxelGrid::Table& table) : m_table(table) {}

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

/** Rays on a grid's units, in order. */
struct SnappedRays
{
  std::vector<GridRay> rays;
  std::vector<RayEnd> ends;
  InsertedRays counts;
};

SnappedRays snap(const std::vector<Ray>& rays, double resolution, double maxRange)
{
  const Snapper snapper(resolution, maxRange);
  SnappedRays snapped;
  snapped.rays.reserve(rays.size());
  snapped.ends.reserve(rays.size());
  for (std::size_t r = 0; r < rays.size(); ++r)
  {
    auto [ray, atEnd] = std::pair{GridRay{}, rays[r].atEnd};
    try
    {
      if (!snapper.snap(rays[r], ray, atEnd))
      {
        ++snapped.counts.notFinite;
        continue;
      }
    }
    catch (const std::out_of_range& error)
    {
      throw std::out_of_range("ray " + std::to_string(r + 1) + " of " +
                              std::to_string(rays.size()) + ": " + error.what());
    }
    snapped.rays.push_back(ray);
    snapped.ends.push_back(atEnd);
    snapped.counts.updates += atEnd == RayEnd::Keep ? 0 : 1;
    for (std::size_t i = 0; i < 3; ++i)
      snapped.counts.updates +=
          static_cast<std::size_t>(std::abs((ray.to[i] >> kRayBits) - (ray.from[i] >> kRayBits)));
  }
  snapped.counts.rays = snapped.rays.size();
  return snapped;
}

/** Bytes that rays can add to a grid at most, as far as their bounding box tells. */
double mostBytes(const std::vector<GridRay>& rays)
{
  constexpr int kBits = kRayBits + kBrickBits;
  double bricks = 1;
  for (std::size_t i = 0; i < 3; ++i)
  {
    std::int64_t low = INT64_MAX, high = INT64_MIN;
    for (const auto& ray : rays)
    {
      low = std::min({low, ray.from[i], ray.to[i]});
      high = std::max({high, ray.from[i], ray.to[i]});
    }
    bricks *= static_cast<double>((high >> kBits) - (low >> kBits) + 1);
  }
  return bricks * static_cast<double>(sizeof(VoxelGrid::Brick) + VoxelGrid::Table::bytesOfRegion());
}

void requireMemoryFor(const VoxelGrid& grid, const std::vector<GridRay>& rays,
                      const std::optional<std::int32_t>& maxMemory)
{
  if (rays.empty()) return;
  const std::size_t limit = memoryLimit(maxMemory);
  if (static_cast<double>(grid.heapBytes()) + mostBytes(rays) <= static_cast<double>(limit)) return;
  Counter counter(grid.table());
  for (const auto& ray : rays)
  {
    walkRay(ray, {}, counter);
    if (counter.bytes() > limit) break;  // more would be known, but not in time
  }
  requireMemory(grid, counter.bytes(), maxMemory);
}

/** Several slabs for each thread, such that more of what a slab's rays change stays in its cache:
 * unrelated rays go in 1.7 times as fast. */
int slabCount(std::size_t rays, std::size_t threads)
{
  constexpr std::size_t kSlabs = 4;
  constexpr std::size_t kFewRays = 256;
  return static_cast<int>(std::min(kSlabs * threads, rays / kFewRays + 1));
}
}  // namespace

InsertedRays insertRays(VoxelGrid& grid, const std::vector<Ray>& rays, const RayParams& params,
                        int threads)
{
  params.check();
  auto snapped = snap(rays, grid.resolution(), params.maxRange);
  requireMemoryFor(grid, snapped.rays, params.maxMemory);
  const RayModel model(params);
  const auto slabs =
      slabsFor(snapped.rays, slabCount(snapped.rays.size(), grid::threadCount(threads)));
  std::mutex access;
  std::vector<ColumnSet> columns(slabs.size());
  grid::inParallel(slabs.size(), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t s = begin; s < end; ++s)
                     {
                       Updater updater(grid.table(), access, model);
                       for (std::size_t r = 0; r < snapped.rays.size(); ++r)
                         updater.insert(snapped.rays[r], snapped.ends[r], slabs[s]);
                       columns[s] = updater.finish();
                     }
                   });
  for (const auto& part : columns) snapped.counts.columns.insert(part);
  return std::move(snapped.counts);
}

}  // namespace mrpt_mapconv::voxel
