#include "LeafTree.h"

#include <algorithm>
#include <tuple>

#include "../grid/Parallel.h"
#include "PlaneRows.h"

namespace mrpt_mapconv::terrain
{
namespace
{
/** The bits of a key at even places. */
std::uint64_t spread(std::uint32_t v)
{
  std::uint64_t x = v;
  x = (x | x << 16) & 0x0000FFFF0000FFFFu;
  x = (x | x << 8) & 0x00FF00FF00FF00FFu;
  x = (x | x << 4) & 0x0F0F0F0F0F0F0F0Fu;
  x = (x | x << 2) & 0x3333333333333333u;
  return (x | x << 1) & 0x5555555555555555u;
}
std::uint32_t gathered(std::uint64_t x)
{
  x &= 0x5555555555555555u;
  x = (x | x >> 1) & 0x3333333333333333u;
  x = (x | x >> 2) & 0x0F0F0F0F0F0F0F0Fu;
  x = (x | x >> 4) & 0x00FF00FF00FF00FFu;
  x = (x | x >> 8) & 0x0000FFFF0000FFFFu;
  return static_cast<std::uint32_t>(x | x >> 16);
}
std::uint64_t morton(std::uint32_t x, std::uint32_t y) { return spread(x) | spread(y) << 1; }

/** Keys from 0 on, so that codes are in their order; a multiple of every side. */
constexpr std::uint32_t kOffset = 1u << 31;
std::uint64_t codeOfTile(const Tile& tile)
{
  constexpr std::uint32_t kTileOffset = kOffset >> kTileBits;
  return morton(static_cast<std::uint32_t>(tile.tx) + kTileOffset,
                static_cast<std::uint32_t>(tile.ty) + kTileOffset);
}
std::uint64_t codeOf(const Leaf& leaf)
{
  return morton(static_cast<std::uint32_t>(leaf.x) + kOffset,
                static_cast<std::uint32_t>(leaf.y) + kOffset);
}

/** Makes the leaves of one tile. */
class TileLeaves
{
 public:
  explicit TileLeaves(Tile& tile) : m_tile(tile) {}

  void make()
  {
    m_tile.leaves.clear();
    m_uniform[0] = m_tile.assigned;
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    {
      m_sameEast[static_cast<std::size_t>(iy)] = ~differsEast(m_tile, iy);
      m_sameNorth[static_cast<std::size_t>(iy)] = ~differsNorth(m_tile, iy);
    }
    for (std::size_t level = 1; level <= kTileBits; ++level) reduce(level);
    emit(kTileBits, 0, 0);
    m_tile.leaves.shrink_to_fit();
  }

 private:
  /** Bits at the lower corners of squares of one plane: those of four squares of one plane each
   * that also have the same plane where they touch. */
  void reduce(std::size_t level)
  {
    const std::size_t half = std::size_t{1} << (level - 1);
    const TileBits& from = m_uniform[level - 1];
    m_uniform[level] = {};
    for (std::size_t y = 0; y < kTileSide; y += 2 * half)
    {
      const RowBits both = from[y] & from[y + half] & m_sameNorth[y + half - 1];
      const RowBits east = m_sameEast[y] >> (half - 1);
      m_uniform[level][y] = both & both >> half & east & kCorners[level];
    }
  }

  void emit(std::size_t level, std::size_t x, std::size_t y)
  {
    if (m_uniform[level][y] >> x & 1u) return add(level, x, y, m_tile.plane[y * kTileSide + x]);
    if (level == 0)
    {
      if (m_tile.known[y] >> x & 1u) add(0, x, y, kNoPlane);
      return;
    }
    if (!isAnyKnown(level, x, y)) return;
    const std::size_t half = std::size_t{1} << (level - 1);
    for (std::size_t child = 0; child < 4; ++child)
      emit(level - 1, x + (child & 1) * half, y + (child >> 1) * half);
  }

  bool isAnyKnown(std::size_t level, std::size_t x, std::size_t y) const
  {
    RowBits any = 0;
    for (std::size_t row = y; row < y + (std::size_t{1} << level); ++row) any |= m_tile.known[row];
    return (any >> x & kSides[level]) != 0;
  }

  void add(std::size_t level, std::size_t x, std::size_t y, std::int32_t plane)
  {
    const auto code = morton(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    m_tile.leaves.push_back(
        {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(level), plane});
  }

  static constexpr std::array<RowBits, kTileBits + 1> kSides{1u,    3u,      15u,
                                                             0xFFu, 0xFFFFu, 0xFFFFFFFFu};
  static constexpr std::array<RowBits, kTileBits + 1> kCorners{
      0xFFFFFFFFu, 0x55555555u, 0x11111111u, 0x01010101u, 0x00010001u, 1u};
  Tile& m_tile;
  TileBits m_sameEast, m_sameNorth;
  std::array<TileBits, kTileBits + 1> m_uniform;
};

/** Makes the list of the planes of one tile. */
void listPlanes(Tile& tile)
{
  tile.planes.clear();
  std::size_t last = 0;
  for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    for (RowBits left = tile.assigned[static_cast<std::size_t>(iy)]; left;)
    {
      const std::int32_t ix = __builtin_ctz(left), id = tile.plane[Tile::indexOf(ix, iy)];
      const RowBits row = rowOfPlane(tile, iy, id);
      left &= ~row;
      const std::int32_t x = tile.keyX(ix), y = tile.keyY(iy),
                         xLast = tile.keyX(31 - __builtin_clz(row));
      if (last >= tile.planes.size() || tile.planes[last].plane != id)
        last = static_cast<std::size_t>(std::find_if(tile.planes.begin(), tile.planes.end(),
                                                     [id](const TilePlane& p)
                                                     { return p.plane == id; }) -
                                        tile.planes.begin());
      if (last == tile.planes.size()) tile.planes.push_back({id, 0, x, y, xLast, y, x});
      TilePlane& part = tile.planes[last];
      part.cells += countOf(row);
      part.xMin = std::min(part.xMin, x);
      part.xMax = std::max(part.xMax, xLast);
      part.yMax = y;
    }
}

}  // namespace

void LeafTree::follow(const TileMap& tiles, int threads)
{
  std::vector<Tile*> stale;
  for (Tile* tile : tiles.sorted())
    if (tile->isStale) stale.push_back(tile);
  constexpr std::size_t kWorthThreads = 128;  // tiles
  grid::inParallel(stale.size(), stale.size() < kWorthThreads ? 1 : threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t i = begin; i < end; ++i)
                     {
                       TileLeaves(*stale[i]).make();
                       listPlanes(*stale[i]);
                       stale[i]->isStale = false;
                     }
                   });
  Level level;
  for (const Tile* tile : tiles.sorted())
    if (isOneSquare(*tile)) level.push_back({codeOfTile(*tile), tile->leaves.front().plane});
  std::sort(level.begin(), level.end(),
            [](const Square& a, const Square& b) { return a.code < b.code; });
  m_levels.clear();
  while (!level.empty())
  {
    Level next;
    for (std::size_t i = 0; i + 3 < level.size(); ++i)
    {
      const Square& first = level[i];
      const bool four = (first.code & 3u) == 0 && level[i + 3].code == first.code + 3 &&
                        level[i + 1].plane == first.plane && level[i + 2].plane == first.plane &&
                        level[i + 3].plane == first.plane;
      if (four) next.push_back({first.code >> 2, first.plane});
    }
    m_levels.push_back(std::move(level));
    level = std::move(next);
  }
}

const LeafTree::Square* LeafTree::find(std::size_t level, std::uint64_t code) const
{
  if (level >= m_levels.size()) return nullptr;
  const Level& squares = m_levels[level];
  const auto found = std::lower_bound(squares.begin(), squares.end(), code,
                                      [](const Square& s, std::uint64_t c) { return s.code < c; });
  return found != squares.end() && found->code == code ? &*found : nullptr;
}

std::size_t LeafTree::count(const TileMap& tiles) const
{
  std::size_t leaves = 0;
  for (const Tile* tile : tiles.sorted()) leaves += tile->leaves.size();
  for (std::size_t level = 1; level < m_levels.size(); ++level)
    leaves -= 3 * m_levels[level].size();
  return leaves;
}

/** The largest square that a tile of one plane lies in. */
Leaf LeafTree::squareAt(const Tile& tile) const
{
  std::uint64_t code = codeOfTile(tile);
  std::size_t level = 0;
  const Square* square = find(0, code);
  for (const Square* parent = find(1, code >> 2); parent; parent = find(level + 1, code >> 2))
  {
    square = parent;
    code >>= 2;
    ++level;
  }
  const auto shift = static_cast<std::int32_t>(level) + kTileBits;
  const auto key = [&](std::uint32_t place)
  { return static_cast<std::int32_t>((place << shift) - kOffset); };
  return {key(gathered(code)), key(gathered(code >> 1)), shift, square->plane, 0};
}

Leaf LeafTree::leafOf(const Tile& tile, const TileLeaf& leaf)
{
  const auto x = static_cast<std::int32_t>(gathered(leaf.code)),
             y = static_cast<std::int32_t>(gathered(leaf.code >> 1u));
  const bool isPlane = leaf.plane != kNoPlane;
  return {tile.keyX(x), tile.keyY(y), leaf.level, leaf.plane,
          isPlane ? 0 : tile.height[Tile::indexOf(x, y)]};
}

Leaf LeafTree::at(const CellRef& cell) const
{
  const Tile& tile = *cell.tile;
  if (isOneSquare(tile)) return squareAt(tile);
  const auto code =
      morton(static_cast<std::uint32_t>(cell.ix), static_cast<std::uint32_t>(cell.iy));
  const auto behind =
      std::upper_bound(tile.leaves.begin(), tile.leaves.end(), code,
                       [](std::uint64_t c, const TileLeaf& leaf) { return c < leaf.code; });
  return leafOf(tile, *(behind - 1));
}

std::vector<Leaf> LeafTree::within(const TileMap& tiles, std::int32_t xMin, std::int32_t yMin,
                                   std::int32_t xMax, std::int32_t yMax) const
{
  std::vector<Leaf> leaves;
  const auto add = [&](const Leaf& leaf)
  {
    const std::int32_t side = 1 << leaf.level;
    if (leaf.x <= xMax && leaf.y <= yMax && leaf.x + (side - 1) >= xMin &&
        leaf.y + (side - 1) >= yMin)
      leaves.push_back(leaf);
  };
  for (const Tile* tile : tiles.sorted())
  {
    if (tile->keyX(0) > xMax || tile->keyY(0) > yMax || tile->keyX(kTileMask) < xMin ||
        tile->keyY(kTileMask) < yMin)
      continue;
    forEachOf(*tile, add);
  }
  std::sort(leaves.begin(), leaves.end(),
            [](const Leaf& a, const Leaf& b) { return codeOf(a) < codeOf(b); });
  leaves.erase(std::unique(leaves.begin(), leaves.end(),
                           [](const Leaf& a, const Leaf& b)
                           { return std::tie(a.x, a.y) == std::tie(b.x, b.y); }),
               leaves.end());
  return leaves;
}

std::size_t LeafTree::memory() const
{
  std::size_t bytes = m_levels.capacity() * sizeof(Level);
  for (const Level& level : m_levels) bytes += level.capacity() * sizeof(Square);
  return bytes;
}

}  // namespace mrpt_mapconv::terrain
