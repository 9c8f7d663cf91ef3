#include "BrickUpdate.h"

#include "../grid/Wide.h"

namespace mrpt_mapconv::voxel
{
namespace
{
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
 * else a miss. */
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
}  // namespace

bool changesByMiss(float logOdds, const OccupancyModel& model)
{
  if (!isTouched(logOdds)) return true;
  std::array<float, kBrickSide> column;
  column.fill(logOdds);
  updateColumn(column.data(), 1, 0, model);
  return column[0] != logOdds;
}

MRPT_MAPCONV_WIDE
void updateBrick(VoxelGrid::Brick& brick, const BrickBits& bits, const OccupancyModel& model,
                 BrickChange& changed)
{
  float* column = brick.logOdds.data();
  for (std::size_t c = 0; c < kBrickColumns; ++c, column += kBrickSide)
  {
    const std::int32_t hits = bits.hit[c], touched = bits.crossed[c] | hits;
    if (!touched) continue;
    const auto change = updateColumn(column, touched, hits, model);
    changed.value |= change.value;
    if (change.state)
      changed.rows[c & (kBrickSide - 1)] |= static_cast<std::uint16_t>(1u << (c >> kBrickBits));
  }
}

}  // namespace mrpt_mapconv::voxel
