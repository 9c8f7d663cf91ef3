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

RayParams rayParamsOf(const TVoxelInsertionOptions& options)
{
  const auto logOdds = [](double probability) { return std::log(probability / (1 - probability)); };
  RayParams params;
  params.probHit = options.probHit;
  params.probMiss = options.probMiss;
  params.minLogOdds = logOdds(options.clampingThresMin);
  params.maxLogOdds = logOdds(options.clampingThresMax);
  params.maxRange = options.maxrange;
  params.maxMemory = options.maxMemory;
  return params;
}

namespace
{
/** Bytes that rays can add to a grid at most, as far as their bounding box and their lengths tell.
 */
double mostBytes(const std::vector<GridRay>& rays)
{
  constexpr int brickBits = kRayBits + kBrickBits, regionBits = kRayBits + kRegionVoxelBits;
  double bricksOfBox = 1, regionsOfBox = 1, bricksOfRays = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    std::int64_t low = INT64_MAX, high = INT64_MIN;
    for (const auto& ray : rays)
    {
      const auto [from, to] = std::pair(ray.from[i], ray.to[i]);
      low = std::min({low, from, to});
      high = std::max({high, from, to});
      bricksOfRays += static_cast<double>(std::abs((to >> brickBits) - (from >> brickBits)));
    }
    bricksOfBox *= static_cast<double>((high >> brickBits) - (low >> brickBits) + 1);
    regionsOfBox *= static_cast<double>((high >> regionBits) - (low >> regionBits) + 1);
  }
  bricksOfRays += static_cast<double>(rays.size());
  const double bricks = std::min(bricksOfBox, bricksOfRays);
  return bricks * sizeof(VoxelGrid::Brick) +
         std::min(regionsOfBox, bricks) * static_cast<double>(VoxelGrid::Table::bytesOfRegion());
}

void reserveMemoryFor(const SnappedRays& snapped, const RayModel& model,
                      const std::optional<std::int32_t>& maxMemory, VoxelGrid& grid)
{
  if (snapped.rays.empty()) return;
  const auto limit = static_cast<double>(params::memoryLimit(maxMemory));
  const double most = mostBytes(snapped.rays);
  if (static_cast<double>(grid.heapBytesAtMost()) + most <= limit)
    return grid.announce(static_cast<std::size_t>(most));
  RayMemory memory(grid, model, maxMemory);
  for (std::size_t r = 0; r < snapped.rays.size(); ++r)
    memory.count(snapped.rays[r], snapped.ends[r]);
  memory.reserve();
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
  reserveMemoryFor(snapped, model, params.maxMemory, grid);
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
