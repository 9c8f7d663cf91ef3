#pragma once

#include <cstdint>

namespace mrpt_mapconv::voxel
{
/** Puts two zeros between the 16 lowest bits of a number. */
inline std::uint64_t spreadBits(std::uint64_t bits)
{
  bits = (bits | bits << 16) & 0x0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x0c30c30c30c3ULL;
  return (bits | bits << 2) & 0x249249249249ULL;
}

/** The inverse: every third bit. */
inline std::uint32_t gatherBits(std::uint64_t code)
{
  code &= 0x249249249249ULL;
  code = (code | code >> 2) & 0x0c30c30c30c3ULL;
  code = (code | code >> 4) & 0x00f00f00f00fULL;
  code = (code | code >> 8) & 0x0000ff0000ffULL;
  return static_cast<std::uint32_t>((code | code >> 16) & 0xFFFFu);
}

/** Its bits are, from the highest, the numbers of the children on the way from an octree's root to
 * a node; keys have 16 bits. */
inline std::uint64_t mortonCode(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
  return spreadBits(x) | spreadBits(y) << 1 | spreadBits(z) << 2;
}

}  // namespace mrpt_mapconv::voxel
