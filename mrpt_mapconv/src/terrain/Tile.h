#pragma once

#include <mrpt_mapconv/terrain/PlaneFit.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace mrpt_mapconv::terrain
{
/** Cells are kept in squares of 32 x 32, with a bit for each cell of a row. */
constexpr std::int32_t kTileBits = 5, kTileSide = 1 << kTileBits;
constexpr std::int32_t kTileMask = kTileSide - 1;
constexpr std::size_t kTileCells = std::size_t{kTileSide} * kTileSide;
using RowBits = std::uint32_t;
using TileBits = std::array<RowBits, kTileSide>;

constexpr std::int32_t kNoPlane = -1;

/** Weights are whole multiples of 1/kWeightUnit of 1/m². */
constexpr double kWeightUnit = 16;
/** Points are not taken for more exact than this [m]. */
constexpr double kLeastSigma = 1e-3;

/** What the points of a cell add up to. */
struct CellSums
{
  std::int64_t weightedHeight = 0;  //!< Σ w·z [kHeightUnit / kWeightUnit]
  std::uint64_t weight = 0;         //!< Σ w [1 / kWeightUnit]
  /** z·2³² + w of the highest point, of those the surest. */
  std::int64_t highest = std::numeric_limits<std::int64_t>::min();
  std::uint32_t points = 0;
  std::uint32_t triedWith : 31;  //!< points that it had when a plane was last looked for from it
  std::uint32_t isMarked : 1;    //!< its bit of Tile::changed is set

  CellSums() : triedWith(0), isMarked(0) {}

  /** Sums so large that they might overflow take no more points: what they mean is then known far
   * better than any sensor knows it. */
  void add(std::int32_t z, std::uint32_t w)
  {
    constexpr std::uint64_t kFull = std::uint64_t{1} << 61;
    if (static_cast<std::uint64_t>(weightedHeight) + kFull > 2 * kFull) return;
    weightedHeight += std::int64_t{w} * z;
    weight += w;
    const auto bits = static_cast<std::uint64_t>(static_cast<std::uint32_t>(z)) << 32 | w;
    highest = std::max(highest, static_cast<std::int64_t>(bits));
    ++points;
  }
  std::int32_t highestZ() const { return static_cast<std::int32_t>(highest >> 32); }
  std::uint32_t highestWeight() const { return static_cast<std::uint32_t>(highest); }
  /** Σ w·z / Σ w, rounded to the nearest whole, halves upward. */
  std::int32_t fusedZ() const
  {
    const auto w = static_cast<std::int64_t>(weight);
    const std::int64_t doubled = 2 * weightedHeight + w;
    std::int64_t z = doubled / (2 * w);
    if (z * 2 * w > doubled) --z;
    return static_cast<std::int32_t>(z);
  }
};

/** The part of a plane that lies in a tile. */
struct TilePlane
{
  std::int32_t plane = kNoPlane;
  std::int32_t cells = 0;
  std::int32_t xMin = 0, yMin = 0, xMax = 0, yMax = 0;  //!< keys
  std::int32_t firstX = 0;                              //!< of the first cell in row yMin
};

/** A leaf within a tile: cells whose Morton code begins as its own does. */
struct TileLeaf
{
  std::uint16_t code = 0;         //!< Morton code of its lower corner in the tile
  std::uint8_t level = 0;         //!< its side is 2^level cells
  std::int32_t plane = kNoPlane;  //!< none: a cell with a height of its own
};

struct Tile
{
  Tile() { plane.fill(kNoPlane); }

  std::int32_t tx = 0, ty = 0;  //!< key of the tile: that of a cell >> kTileBits
  bool hasChanged = false;      //!< bits of `changed`
  bool isStale = true;          //!< `planes` and `leaves` have yet to follow
  bool isUnsettled = false;     //!< bits of `unsettled`
  bool isNearUnsettled = false, hasMovedPlane = false;  //!< while borders follow
  // of the flood that was here last
  std::uint64_t floodNumber = 0;
  std::uint32_t floodIndex = 0;

  /** West to east, south to north, this one in the middle; null: no cell is known there. */
  std::array<Tile*, 9> around{};

  TileBits known{};     //!< cells that have points, as of the last update
  TileBits changed{};   //!< cells with points since then
  TileBits assigned{};  //!< cells of a plane
  TileBits
      unsettled{};  //!< cells whose plane or height has changed, which borders have yet to follow
  std::array<std::int32_t, kTileCells> height{};  //!< as of the last update [kHeightUnit]
  std::array<std::int32_t, kTileCells> plane;     //!< kNoPlane where not assigned
  std::array<CellSums, kTileCells> sums{};

  std::vector<TilePlane> planes;  //!< that have cells here
  std::vector<TileLeaf> leaves;   //!< by their codes

  std::int32_t keyX(std::int32_t ix) const { return tx * kTileSide + ix; }
  std::int32_t keyY(std::int32_t iy) const { return ty * kTileSide + iy; }
  static std::size_t indexOf(std::int32_t ix, std::int32_t iy)
  {
    return static_cast<std::size_t>(iy * kTileSide + ix);
  }
  bool isKnown(std::int32_t ix, std::int32_t iy) const
  {
    return known[static_cast<std::size_t>(iy)] >> ix & 1u;
  }
  Tile* neighbour(std::int32_t dx, std::int32_t dy) const
  {
    return around[static_cast<std::size_t>(4 + dx + 3 * dy)];
  }
  void assign(std::size_t index, std::int32_t to)
  {
    plane[index] = to;
    assigned[index >> kTileBits] |= RowBits{1} << (index & kTileMask);
    isStale = true;
    unsettle(index);
  }
  void unsettle(std::size_t index)
  {
    unsettled[index >> kTileBits] |= RowBits{1} << (index & kTileMask);
    isUnsettled = true;
  }
  void release(std::size_t index)
  {
    plane[index] = kNoPlane;
    assigned[index >> kTileBits] &= ~(RowBits{1} << (index & kTileMask));
    isStale = true;
    unsettle(index);
  }
};

/** The number of set bits; the built-in one is a call where the processor is not known to count. */
inline std::int32_t countOf(RowBits bits)
{
  bits -= bits >> 1 & 0x55555555u;
  bits = (bits & 0x33333333u) + (bits >> 2 & 0x33333333u);
  return static_cast<std::int32_t>(((bits + (bits >> 4)) & 0x0F0F0F0Fu) * 0x01010101u >> 24);
}

/** The lowest and the highest set bit; there has to be one. */
inline std::int32_t lowestOf(RowBits bits)
{
  return static_cast<std::int32_t>(__builtin_ctz(bits));
}
inline std::int32_t highestOf(RowBits bits)
{
  return kTileMask - static_cast<std::int32_t>(__builtin_clz(bits));
}

/** Calls visit(bit) for each set bit of a row, from the lowest. */
template <class Visit>
void forEachBit(RowBits bits, const Visit& visit)
{
  for (; bits; bits &= bits - 1) visit(static_cast<std::int32_t>(__builtin_ctz(bits)));
}

/** Cells of a tile. */
struct TileCells
{
  Tile* tile = nullptr;
  TileBits bits{};
};

/** A cell of a tile. */
struct CellRef
{
  Tile* tile = nullptr;
  std::int32_t ix = 0, iy = 0;

  std::size_t index() const { return Tile::indexOf(ix, iy); }
  std::int32_t keyX() const { return tile->keyX(ix); }
  std::int32_t keyY() const { return tile->keyY(iy); }
  explicit operator bool() const { return tile != nullptr; }
};

/** The cell at an offset of at most a tile's side; without a tile if there is none. */
inline CellRef cellAt(Tile& from, std::int32_t ix, std::int32_t iy)
{
  Tile* tile = from.neighbour(ix >> kTileBits, iy >> kTileBits);
  return {tile, ix & kTileMask, iy & kTileMask};
}

}  // namespace mrpt_mapconv::terrain
