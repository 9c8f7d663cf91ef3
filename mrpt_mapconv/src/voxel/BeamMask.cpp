#include "BeamMask.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "../grid/Parallel.h"
#include "BeamCrossings.h"
#include "BrickUpdate.h"

namespace mrpt_mapconv::voxel
{
namespace
{
/** Adds the columns of rows of a brick. */
void insertRows(const std::array<std::uint16_t, kBrickSide>& rows, const VoxelKey& origin,
                ColumnSet& columns)
{
  if (std::all_of(rows.begin(), rows.end(), [](auto row) { return row == 0; })) return;
  ColumnMask mask{};
  for (std::size_t y = 0; y < rows.size(); ++y)
    mask[y + static_cast<std::size_t>(origin.y & (kBlockSide - 1))] =
        static_cast<std::uint32_t>(rows[y]) << (origin.x & (kBlockSide - 1));
  columns.insert(BlockKey{origin.x >> 5, origin.y >> 5}, mask);
}

}  // namespace

BeamMask::BeamMask(const ScanBeams& beams, MemoryBudget& budget, int threads)
    : BeamMask(beams.keys, budget)
{
  constexpr std::size_t kFewBeams = 1024;  // for which a thread does not pay
  const std::size_t shares = std::min(grid::threadCount(threads),
                                      (beams.hits.size() + beams.misses.size()) / kFewBeams + 1);
  std::vector<BeamMask> masks;
  for (std::size_t i = 1; i < shares; ++i) masks.push_back(BeamMask(m_keys, budget));
  grid::inParallel(shares, threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t share = begin; share < end; ++share)
                       (share == 0 ? *this : masks[share - 1]).addShare(beams, share, shares);
                   });
  for (auto& mask : masks) add(std::move(mask));
}

/** Adds one of so many shares of a scan's beams. */
void BeamMask::addShare(const ScanBeams& beams, std::size_t share, std::size_t shares)
{
  for (const auto* ends : {&beams.hits, &beams.misses})
    for (std::size_t i = ends->size() * share / shares; i < ends->size() * (share + 1) / shares;
         ++i)
    {
      const auto& beam = (*ends)[i];
      if (ends == &beams.hits) hit(beam.key);
      cross(beams.origin, beam, beams.originKey);
    }
}

void BeamMask::add(BeamMask&& other)
{
  other.m_table.forEachRegion(
      [this](const VoxelKey& key, Table::Region& from)
      {
        Table::Region& to = m_table.obtain(key);
        for (std::size_t i = 0; i < to.size(); ++i)
        {
          if (!from[i]) continue;
          if (!to[i])
          {
            to[i] = std::move(from[i]);
            continue;
          }
          for (std::size_t c = 0; c < kBrickColumns; ++c)
          {
            to[i]->crossed[c] |= from[i]->crossed[c];
            to[i]->hit[c] |= from[i]->hit[c];
          }
        }
      });
}

BeamMask::Table::Region& BeamMask::region(const VoxelKey& key)
{
  return *m_recent(key,
                   [this](const VoxelKey& unknown, Table::Region*& region)
                   {
                     m_budget->take(Table::bytesOfRegion());
                     region = &m_table.obtain(unknown);
                   });
}

BrickBits& BeamMask::bitsOf(Table::Region& region, std::size_t brick)
{
  auto& bits = region[brick];
  if (!bits)
  {
    m_budget->take(sizeof(BrickBits));
    bits = std::make_unique<BrickBits>();
  }
  return *bits;
}

void BeamMask::hit(const VoxelKey& voxel)
{
  const std::size_t index = voxelIndex(voxel);
  bitsOf(region(regionKey(voxel)), brickIndex(voxel)).hit[index >> kBrickBits] |=
      static_cast<std::uint16_t>(1u << (index & (kBrickSide - 1)));
}

void BeamMask::cross(const octomap::point3d& origin, const ScanBeams::Beam& beam,
                     const VoxelKey& from)
{
  if (from == beam.key) return;
  BeamCrossings crossings(m_keys, origin, beam.end, from);
  BrickCursor cursor(from, crossings.negative);
  crossings.follow(cursor);
  const auto last = cursor.positionOf(beam.key);
  const auto lastBrick = brickIndex(beam.key);
  const auto lastRegion = regionKey(beam.key);
  auto* region = &this->region(cursor.region());
  while (true)
  {
    const bool isLastBrick = cursor.brick() == lastBrick && cursor.region() == lastRegion;
    const auto at =
        crossings.mark(bitsOf(*region, cursor.brick()).crossed.data(), cursor.position(),
                       isLastBrick ? last : ~BrickCursor::Position{0});
    if (!BrickCursor::isOutside(at)) return;
    if (!cursor.enterNext(at)) continue;
    if (!OctomapKeys::holds(cursor.region())) return;  // by a rounding error
    region = &this->region(cursor.region());
  }
}

std::size_t BeamMask::bytesFor(const VoxelGrid& grid) const
{
  std::size_t bytes = 0;
  for (const auto& [key, region] : m_table.regions())
  {
    const auto* slots = grid.table().find(key);
    if (!slots) bytes += VoxelGrid::Table::bytesOfRegion();
    for (std::size_t i = 0; i < region->size(); ++i)
      if ((*region)[i] && !(slots && (*slots)[i].brick)) bytes += sizeof(VoxelGrid::Brick);
  }
  return bytes;
}

ColumnSet BeamMask::update(VoxelGrid& grid, const OccupancyModel& model, int threads) const
{
  struct Update
  {
    const BrickBits* bits;
    VoxelGrid::Slot* slot;
    VoxelKey origin;
    bool wasOneValue;
    BrickChange change;
  };
  std::vector<Update> updates;
  for (const auto& [key, region] : m_table.regions())
  {
    auto& slots = grid.table().obtain(key);
    for (std::size_t i = 0; i < region->size(); ++i)
    {
      const auto& bits = (*region)[i];
      if (!bits || (!slots[i].brick && !bits->hasHit() && !changesByMiss(slots[i].value, model)))
        continue;
      updates.push_back({bits.get(), &slots[i], brickOrigin(key, i), !slots[i].brick, {}});
    }
  }
  const auto forAll = [&](const auto& work)
  {
    constexpr std::size_t kFewBricks = 16;
    grid::inParallel(updates.size(), updates.size() < kFewBricks ? 1 : threads,
                     [&](std::size_t begin, std::size_t end)
                     { std::for_each(&updates[begin], &updates[end - 1] + 1, work); });
  };
  // memory first: what comes then cannot fail and leave the map half changed
  forAll([](Update& update) { update.slot->expanded(); });
  forAll(
      [&model](Update& update)
      {
        updateBrick(*update.slot->brick, *update.bits, model, update.change);
        if (update.change.value || update.wasOneValue) update.slot->collapse();
      });
  ColumnSet changed;
  for (const auto& update : updates) insertRows(update.change.rows, update.origin, changed);
  return changed;
}

}  // namespace mrpt_mapconv::voxel
