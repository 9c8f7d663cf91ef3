#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "Tile.h"

namespace mrpt_mapconv::terrain
{
/** The tiles in which cells are known. */
class TileMap
{
 public:
  TileMap() = default;
  TileMap(const TileMap& o);
  TileMap& operator=(const TileMap& o);
  TileMap(TileMap&&) = default;
  TileMap& operator=(TileMap&&) = default;
  ~TileMap() = default;

  /** The tile of that key, or none. */
  Tile* find(std::int32_t tx, std::int32_t ty) const;
  /** The tile of that key, which is made if there is none. */
  Tile& get(std::int32_t tx, std::int32_t ty);
  void remove(const Tile& tile);
  void clear();

  /** A number that no flood over these tiles had before. */
  std::uint64_t nextFlood() { return ++m_floods; }

  bool empty() const { return m_tiles.empty(); }
  std::size_t size() const { return m_tiles.size(); }
  /** All tiles, row by row. */
  const std::vector<Tile*>& sorted() const;
  /** The cell of a key; without a tile if there is none. */
  CellRef cell(std::int32_t kx, std::int32_t ky) const
  {
    return {find(kx >> kTileBits, ky >> kTileBits), kx & kTileMask, ky & kTileMask};
  }

 private:
  void link(Tile& tile);

  static std::uint64_t keyOf(std::int32_t tx, std::int32_t ty)
  {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(ty)) << 32 |
           static_cast<std::uint32_t>(tx);
  }
  struct Hash
  {
    std::size_t operator()(std::uint64_t key) const
    {
      key *= 0x9E3779B97F4A7C15u;
      return key ^ key >> 32;
    }
  };

  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>, Hash> m_tiles;
  std::uint64_t m_floods = 0;
  mutable std::vector<Tile*> m_sorted;  //!< of all tiles, or without any
};

}  // namespace mrpt_mapconv::terrain
