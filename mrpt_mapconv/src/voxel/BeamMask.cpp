#include "BeamMask.h"

#include <mrpt_mapconv/voxel/RayWalk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include "../grid/Parallel.h"
#include "../grid/Wide.h"

namespace mrpt_mapconv::voxel
{
namespace
{
using Column = std::array<float, kBrickSide>;

/** What a column's update did to its voxels, a bit each. */
struct ColumnChange
{
  bool state = false;  //!< some voxel became known, or changed between free and occupied
  bool value = false;  //!< some log-odds changed
};

constexpr std::array<std::int32_t, kBrickSide> kBits = []
{
  std::array<std::int32_t, kBrickSide> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = 1 << i;
  return bits;
}();

/** Updates those voxels of a column that have a bit in `touched`: a hit where one is in `hits`,
 * else a miss. As OctoMap, which leaves a known voxel that is at its bound, or beyond, as it is. */
inline ColumnChange updateColumn(float* column, std::int32_t touched, std::int32_t hits,
                                 const OccupancyModel& model)
{
  const float hit = model.hit, miss = model.miss, low = model.range.min, high = model.range.max,
              occupiedFrom = model.occupiedFrom;
  std::int32_t stateChanged = 0, valueChanged = 0;
  for (std::size_t i = 0; i < kBrickSide; ++i)  // without branches, such that it is vectorised
  {
    const float before = column[i];
    std::int32_t bits;
    std::memcpy(&bits, &before, sizeof(bits));
    const float change = (hits & kBits[i]) != 0 ? hit : miss;
    const float sum = before + change;
    const float above = sum < low ? low : sum;
    const float clamped = above > high ? high : above;
    const std::int32_t isNew = bits == kUntouchedBits ? -1 : 0;
    const std::int32_t atTop = (change >= 0 ? -1 : 0) & (before >= high ? -1 : 0);
    const std::int32_t atBottom = (change <= 0 ? -1 : 0) & (before <= low ? -1 : 0);
    const std::int32_t isTouchedNow = (touched & kBits[i]) != 0 ? -1 : 0;
    const std::int32_t updates = isTouchedNow & (isNew | ~(atTop | atBottom));
    const float after = updates != 0 ? clamped : before;
    const std::int32_t flips = (before >= occupiedFrom ? -1 : 0) ^ (after >= occupiedFrom ? -1 : 0);
    stateChanged |= updates & (isNew | flips);
    valueChanged |= updates;
    column[i] = after;
  }
  return {stateChanged != 0, valueChanged != 0};
}

/** Whether a miss changes a voxel. */
bool changesByMiss(float logOdds, const OccupancyModel& model)
{
  if (!isTouched(logOdds)) return true;
  Column column;
  column.fill(logOdds);
  updateColumn(column.data(), 1, 0, model);
  return column[0] != logOdds;
}

/** What a brick's update did: bit x of row y is that column. */
struct BrickChange
{
  std::array<std::uint16_t, kBrickSide> rows{};
  bool value = false;
};

/** \param crossed, hit bits of the voxels of each column */
MRPT_MAPCONV_WIDE
void updateBrick(float* column, const std::uint16_t* crossed, const std::uint16_t* hit,
                 const OccupancyModel& model, BrickChange& changed)
{
  for (std::size_t c = 0; c < kBrickColumns; ++c, column += kBrickSide)
  {
    const std::int32_t hits = hit[c], touched = crossed[c] | hits;
    if (!touched) continue;
    const auto change = updateColumn(column, touched, hits, model);
    changed.value |= change.value;
    if (change.state)
      changed.rows[c & (kBrickSide - 1)] |= static_cast<std::uint16_t>(1u << (c >> kBrickBits));
  }
}

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

/** How far along a beam it crosses the voxels' faces [m], axis by axis. */
class BeamCrossings
{
 public:
  BeamCrossings(const OctomapKeys& keys, const octomap::point3d& origin,
                const octomap::point3d& end, const VoxelKey& from)
  {
    octomap::point3d direction = end - origin;
    m_length = static_cast<float>(direction.norm());
    direction /= m_length;
    const std::array<std::int32_t, 3> start{from.x, from.y, from.z};
    for (unsigned i = 0; i < 3; ++i)
    {
      negative[i] = direction(i) < 0;
      if (!(direction(i) > 0) && !negative[i]) continue;
      double border = keys.centre(start[i]);
      border += static_cast<float>((negative[i] ? -1 : 1) * keys.resolution() * 0.5);
      m_next[i] = (border - origin(i)) / direction(i);
      m_delta[i] = keys.resolution() / std::fabs(direction(i));
    }
  }

  /** Takes the steps of a cursor for its own. */
  void follow(const BrickCursor& cursor)
  {
    for (int i = 0; i < 3; ++i) m_move[static_cast<std::size_t>(i)] = cursor.step(i);
  }

  /** Marks the voxels from `at` on.
   * \return where it left the brick; a position inside if the beam ends there, at `stop` or since
   * the next face is farther than its end */
  BrickCursor::Position mark(std::uint16_t* crossed, BrickCursor::Position at,
                             BrickCursor::Position stop)
  {
    double nextX = m_next[0], nextY = m_next[1], nextZ = m_next[2];
    double farthest = m_farthest;
    do
    {
      if (at == stop) return at;
      const std::size_t index = BrickCursor::indexIn(at);
      const auto bit = static_cast<std::uint16_t>(1u << (index & (kBrickSide - 1)));
      std::uint16_t& column = crossed[index >> kBrickBits];
      if (nextX < nextY && nextX < nextZ)
      {
        if (nextX > farthest) return at;
        nextX += m_delta[0];
        at += m_move[0];
      }
      else if (nextY < nextZ && !(nextX < nextY))
      {
        if (nextY > farthest) return at;
        nextY += m_delta[1];
        at += m_move[1];
      }
      else
      {
        if (nextZ > farthest) return at;
        nextZ += m_delta[2];
        at += m_move[2];
      }
      column |= bit;
      farthest = m_length;
    } while (!BrickCursor::isOutside(at));
    m_next = {nextX, nextY, nextZ};
    m_farthest = farthest;
    return at;
  }

  std::array<bool, 3> negative{};

 private:
  static constexpr double kNever = std::numeric_limits<double>::max();
  std::array<double, 3> m_next{kNever, kNever, kNever}, m_delta{kNever, kNever, kNever};
  std::array<BrickCursor::Position, 3> m_move{};
  double m_farthest = kNever;  // the first voxel counts, however near its face
  float m_length = 0;
};
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
  return *m_recent(key, [this](const VoxelKey& unknown, Table::Region*& region)
                   { region = &m_table.obtain(unknown); });
}

BeamMask::Bits& BeamMask::bitsOf(Table::Region& region, std::size_t brick)
{
  auto& bits = region[brick];
  if (!bits)
  {
    m_budget->take(sizeof(Bits));
    bits = std::make_unique<Bits>();
  }
  return *bits;
}

void BeamMask::hit(const VoxelKey& voxel)
{
  const std::size_t index = voxelIndex(voxel);
  bitsOf(region(regionKey(voxel)), brickIndex(voxel)).hit[index >> kBrickBits] |=
      static_cast<std::uint16_t>(1u << (index & (kBrickSide - 1)));
}

/** The voxels of octomap::OcTree::computeRayKeys(), by its arithmetic: its order of comparisons and
 * its sums, of which the rounding errors decide which voxels they are. */
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
    if (cursor.enterNext(at)) region = &this->region(cursor.region());
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
  std::vector<Update> updates;
  for (const auto& [key, region] : m_table.regions())
  {
    auto& slots = grid.table().obtain(key);
    for (std::size_t i = 0; i < region->size(); ++i)
      if (const auto& bits = (*region)[i])
        updates.push_back({bits.get(), brickOrigin(key, i), &slots[i]});
  }
  ColumnSet changed;
  std::mutex access;
  constexpr std::size_t kFewBricks = 16;
  grid::inParallel(updates.size(), updates.size() < kFewBricks ? 1 : threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     ColumnSet part;
                     for (std::size_t i = begin; i < end; ++i) update(updates[i], model, part);
                     const std::lock_guard<std::mutex> lock(access);
                     changed.insert(part);
                   });
  return changed;
}

void BeamMask::update(const Update& update, const OccupancyModel& model, ColumnSet& changed)
{
  const auto& [bits, origin, slot] = update;
  const bool noHit = std::all_of(bits->hit.begin(), bits->hit.end(), [](auto b) { return b == 0; });
  if (noHit && !slot->brick && !changesByMiss(slot->value, model)) return;
  BrickChange change;
  updateBrick(slot->expanded().logOdds.data(), bits->crossed.data(), bits->hit.data(), model,
              change);
  if (change.value) slot->collapse();
  insertRows(change.rows, origin, changed);
}

}  // namespace mrpt_mapconv::voxel
