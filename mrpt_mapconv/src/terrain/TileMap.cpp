#include "TileMap.h"

#include <algorithm>
#include <tuple>

namespace mrpt_mapconv::terrain
{
TileMap::TileMap(const TileMap& o) : m_floods(o.m_floods)
{
  m_tiles.reserve(o.m_tiles.size());
  for (const auto& [key, tile] : o.m_tiles) m_tiles.emplace(key, std::make_unique<Tile>(*tile));
  for (const auto& entry : m_tiles) link(*entry.second);
}

TileMap& TileMap::operator=(const TileMap& o)
{
  if (this != &o) *this = TileMap(o);
  return *this;
}

Tile* TileMap::find(std::int32_t tx, std::int32_t ty) const
{
  const auto found = m_tiles.find(keyOf(tx, ty));
  return found == m_tiles.end() ? nullptr : found->second.get();
}

Tile& TileMap::get(std::int32_t tx, std::int32_t ty)
{
  auto& tile = m_tiles[keyOf(tx, ty)];
  if (tile) return *tile;
  tile = std::make_unique<Tile>();
  tile->tx = tx;
  tile->ty = ty;
  link(*tile);
  m_sorted.clear();
  return *tile;
}

/** Lets a tile and those around it know each other. */
void TileMap::link(Tile& tile)
{
  for (std::int32_t dy = -1; dy <= 1; ++dy)
    for (std::int32_t dx = -1; dx <= 1; ++dx)
    {
      Tile* other = dx == 0 && dy == 0 ? &tile : find(tile.tx + dx, tile.ty + dy);
      tile.around[static_cast<std::size_t>(4 + dx + 3 * dy)] = other;
      if (other) other->around[static_cast<std::size_t>(4 - dx - 3 * dy)] = &tile;
    }
}

void TileMap::remove(const Tile& tile)
{
  for (std::size_t i = 0; i < tile.around.size(); ++i)
    if (Tile* other = tile.around[i]) other->around[8 - i] = nullptr;
  m_sorted.clear();
  m_tiles.erase(keyOf(tile.tx, tile.ty));
}

void TileMap::clear()
{
  m_tiles.clear();
  m_sorted.clear();
}

const std::vector<Tile*>& TileMap::sorted() const
{
  if (m_sorted.size() == m_tiles.size()) return m_sorted;
  m_sorted.clear();
  m_sorted.reserve(m_tiles.size());
  for (const auto& entry : m_tiles) m_sorted.push_back(entry.second.get());
  std::sort(m_sorted.begin(), m_sorted.end(),
            [](const Tile* a, const Tile* b)
            { return std::tie(a->ty, a->tx) < std::tie(b->ty, b->tx); });
  return m_sorted;
}

}  // namespace mrpt_mapconv::terrain
