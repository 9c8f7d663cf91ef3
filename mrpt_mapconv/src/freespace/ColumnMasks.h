#pragma once

#include <mrpt_mapconv/voxel/ColumnBlock.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace mrpt_mapconv::freespace
{
/** A bit that is set or not, at column x of a row's mask. */
inline std::uint32_t bitIf(bool set, std::int32_t x)
{
  return static_cast<std::uint32_t>(set) << x;
}

/** Calls visit(x) for every column of a row's mask. */
template <class Visit>
void forEachInRow(std::uint32_t row, const Visit& visit)
{
  if (row == voxel::kFullRow)
    for (std::int32_t x = 0; x < voxel::kBlockSide; ++x) visit(x);
  else
    for (; row; row &= row - 1) visit(__builtin_ctz(row));
}

/** Calls visit(y, row) for every row of a mask that is not empty. */
template <class Visit>
void forEachRow(const voxel::ColumnMask& mask, const Visit& visit)
{
  for (std::int32_t y = 0; y < voxel::kBlockSide; ++y)
    if (const std::uint32_t row = mask[static_cast<std::size_t>(y)]; row) visit(y, row);
}

/** Calls visit(x, y) for every column of a mask. */
template <class Visit>
void forEachColumn(const voxel::ColumnMask& mask, const Visit& visit)
{
  forEachRow(mask, [&](std::int32_t y, std::uint32_t row)
             { forEachInRow(row, [&](std::int32_t x) { visit(x, y); }); });
}

inline bool any(const voxel::ColumnMask& mask)
{
  std::uint32_t rows = 0;
  for (const auto row : mask) rows |= row;
  return rows != 0;
}

inline voxel::ColumnMask operator&(voxel::ColumnMask a, const voxel::ColumnMask& b)
{
  for (std::size_t y = 0; y < a.size(); ++y) a[y] &= b[y];
  return a;
}

inline voxel::ColumnMask operator|(voxel::ColumnMask a, const voxel::ColumnMask& b)
{
  for (std::size_t y = 0; y < a.size(); ++y) a[y] |= b[y];
  return a;
}

inline voxel::ColumnMask operator~(voxel::ColumnMask a)
{
  for (auto& row : a) row = ~row;
  return a;
}

/** Which columns of a row satisfy holds(x), asked of all of them. */
template <class Holds>
std::uint32_t rowWhere(const Holds& holds)
{
  // constants instead of shifts by x: those can be vectors
  static constexpr auto bits = []
  {
    std::array<std::uint32_t, voxel::kBlockSide> out{};
    for (std::size_t x = 0; x < out.size(); ++x) out[x] = std::uint32_t{1} << x;
    return out;
  }();
  std::uint32_t row = 0;
  for (std::int32_t x = 0; x < voxel::kBlockSide; ++x)
    row |= bits[static_cast<std::size_t>(x)] & (0u - static_cast<std::uint32_t>(holds(x)));
  return row;
}

/** One value for each column of a block's row. */
using RowValues = std::array<float, voxel::kBlockSide>;

/** Copies the values of a row's columns to a layer, from whose cell column 0 is. */
inline void writeRow(std::uint32_t row, const float* from, float* to)
{
  forEachInRow(row, [&](std::int32_t x) { to[x] = from[x]; });
}

/** The columns of a row whose two values are not the same bits, which may be those of NaN. */
inline std::uint32_t differing(std::uint32_t row, const float* a, const float* b)
{
  const auto bitsOf = [](float value)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
  };
  std::uint32_t out = 0;
  forEachInRow(row, [&](std::int32_t x) { out |= bitIf(bitsOf(a[x]) != bitsOf(b[x]), x); });
  return out;
}

}  // namespace mrpt_mapconv::freespace
