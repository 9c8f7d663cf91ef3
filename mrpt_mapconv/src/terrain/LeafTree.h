#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "TileMap.h"

namespace mrpt_mapconv::terrain
{
/** A square that lies in one plane: side 2^level cells. */
struct Leaf
{
  std::int32_t x = 0, y = 0;  //!< key of its lower corner
  std::int32_t level = 0;
  std::int32_t plane = kNoPlane;
  std::int32_t height = 0;  //!< its own, without a plane [kHeightUnit]
};

/** The linear quadtree (Gargantini 1982) of a map: leaves by their Morton codes. Within tiles they
 * are kept by the tiles; squares of a tile and larger ones that lie in one plane are kept here,
 * level by level. */
class LeafTree
{
 public:
  /** Has the leaves follow the planes of tiles that are stale. \param threads 0 = all cores */
  void follow(const TileMap& tiles, int threads);
  void clear() { m_levels.clear(); }

  std::size_t count(const TileMap& tiles) const;
  /** The leaf of a known cell. */
  Leaf at(const CellRef& cell) const;
  /** The leaves that reach into a rectangle of keys, by their Morton codes. */
  std::vector<Leaf> within(const TileMap& tiles, std::int32_t xMin, std::int32_t yMin,
                           std::int32_t xMax, std::int32_t yMax) const;
  /** The leaves of a tile; one that is larger than the tile is given whole. */
  template <class Visit>
  void forEachOf(const Tile& tile, const Visit& visit) const
  {
    if (isOneSquare(tile)) return visit(squareAt(tile));
    for (const TileLeaf& leaf : tile.leaves) visit(leafOf(tile, leaf));
  }
  std::size_t memory() const;

 private:
  struct Square
  {
    std::uint64_t code = 0;  //!< Morton code of its place, in squares of its level
    std::int32_t plane = kNoPlane;
  };
  using Level = std::vector<Square>;

  const Square* find(std::size_t level, std::uint64_t code) const;
  static bool isOneSquare(const Tile& tile)
  {
    return tile.leaves.size() == 1 && tile.leaves.front().level == kTileBits;
  }
  static Leaf leafOf(const Tile& tile, const TileLeaf& leaf);
  Leaf squareAt(const Tile& tile) const;

  std::vector<Level> m_levels;  //!< of sides 2^kTileBits, 2^(kTileBits+1), …
};

}  // namespace mrpt_mapconv::terrain
