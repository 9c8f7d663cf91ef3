#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>
#include <mrpt_mapconv/voxel/RayWalk.h>

#include <cmath>
#include <mutex>
#include <utility>

#include "../grid/Parallel.h"
#include "MemoryLimit.h"
#include "RaySlabs.h"
#include "RaySnapping.h"
#include "RayVisitors.h"

namespace mrpt_mapconv::voxel
{
using params::require;

void RayParams::check() const
{
  require(probHit >= 0.5 && probHit < 1, "probHit", probHit, "at least 0.5 and below 1");
  require(probMiss > 0 && probMiss < 0.5, "probMiss", probMiss,
          "above 0 and below 0.5, else what rays go through would not be free");
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

void requireMemoryFor(const VoxelGrid& grid, const SnappedRays& snapped, const RayModel& model,
                      const std::optional<std::int32_t>& maxMemory)
{
  if (snapped.rays.empty()) return;
  const auto limit = static_cast<double>(memoryLimit(maxMemory));
  if (static_cast<double>(grid.heapBytes()) + mostBytes(snapped.rays) <= limit) return;
  RayMemory memory(grid, model, maxMemory);
  for (std::size_t r = 0; r < snapped.rays.size(); ++r)
    memory.count(snapped.rays[r], snapped.ends[r]);
  memory.require();
}

/** More slabs than threads, such that more of what a slab's rays change stays in its cache:
 * unrelated rays go in 1.7 times as fast. */
int slabCount(std::size_t rays, std::size_t threads)
{
  constexpr std::size_t kSlabs = 4, kFewRays = 256;
  return static_cast<int>(
      std::min(std::max<std::size_t>(kSlabs / threads, 1) * threads, rays / kFewRays + 1));
}
}  // namespace

InsertedRays insertRays(VoxelGrid& grid, const std::vector<Ray>& rays, const RayParams& params,
                        int threads)
{
  params.check();
  auto snapped = snapRays(rays, grid.resolution(), params.maxRange);
  const RayModel model(params);
  requireMemoryFor(grid, snapped, model, params.maxMemory);
  const auto slabs =
      slabsFor(snapped.rays, slabCount(snapped.rays.size(), grid::threadCount(threads)));
  std::mutex access;
  std::vector<ColumnSet> columns(slabs.size());
  grid::inParallel(slabs.size(), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t s = begin; s < end; ++s)
                     {
                       RayUpdater updater(grid.table(), access, model);
                       for (std::size_t r = 0; r < snapped.rays.size(); ++r)
                         updater.insert(snapped.rays[r], snapped.ends[r], slabs[s]);
                       columns[s] = updater.finish();
                     }
                   });
  for (const auto& part : columns) snapped.counts.columns.insert(part);
  return std::move(snapped.counts);
}

}  // namespace mrpt_mapconv::voxel
