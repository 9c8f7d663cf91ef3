#pragma once

#include <cstdint>

namespace mrpt_mapconv::scan
{
/** The part of word `word` that lies within columns [lo, hi] of a row. */
inline std::uint64_t rangeMask(std::int32_t word, std::int32_t lo, std::int32_t hi)
{
  std::uint64_t mask = ~std::uint64_t(0);
  if (word == lo >> 6) mask <<= lo & 63;
  if (word == hi >> 6) mask &= ~std::uint64_t(0) >> (63 - (hi & 63));
  return mask;
}

/** Calls visit(word, mask) for the words of columns [lo, hi], lo ≤ hi, from the lowest. */
template <class Visit>
void forEachWord(std::int32_t lo, std::int32_t hi, const Visit& visit)
{
  for (std::int32_t word = lo >> 6; word <= hi >> 6; ++word) visit(word, rangeMask(word, lo, hi));
}

/** True if a column within [lo, hi] is set. */
inline bool anySet(const std::uint64_t* row, std::int32_t lo, std::int32_t hi)
{
  if (lo >> 6 == hi >> 6) return row[lo >> 6] & rangeMask(lo >> 6, lo, hi);
  std::uint64_t any = 0;
  forEachWord(lo, hi, [&](std::int32_t word, std::uint64_t mask) { any |= row[word] & mask; });
  return any != 0;
}

/** The lowest set column within [lo, hi]; −1: none. */
inline std::int32_t lowestSet(const std::uint64_t* row, std::int32_t lo, std::int32_t hi)
{
  for (std::int32_t word = lo >> 6; word <= hi >> 6; ++word)
    if (const std::uint64_t bits = row[word] & rangeMask(word, lo, hi))
      return (word << 6) + __builtin_ctzll(bits);
  return -1;
}

/** The highest set column within [lo, hi]; −1: none. */
inline std::int32_t highestSet(const std::uint64_t* row, std::int32_t lo, std::int32_t hi)
{
  for (std::int32_t word = hi >> 6; word >= lo >> 6; --word)
    if (const std::uint64_t bits = row[word] & rangeMask(word, lo, hi))
      return (word << 6) + 63 - __builtin_clzll(bits);
  return -1;
}

/** Calls visit(column) for each set bit of a word, from the lowest. */
template <class Visit>
void forEachBit(std::uint64_t bits, std::int32_t word, const Visit& visit)
{
  for (; bits; bits &= bits - 1) visit((word << 6) + __builtin_ctzll(bits));
}

}  // namespace mrpt_mapconv::scan
