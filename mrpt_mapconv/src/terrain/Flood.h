#pragma once

#include <vector>

#include "PlaneSet.h"
#include "TileMap.h"

namespace mrpt_mapconv::terrain
{
/** The cells of a row of a tile that lie at most `tolerance` above or below a plane.
 * \param of those that are asked for \param tolerance [kHeightUnit] */
RowBits nearPlane(const Plane& plane, double tolerance, const Tile& tile, std::int32_t iy,
                  RowBits of);
/** All set bits of `within` that are connected to a set bit of `seeds`. */
RowBits filledRow(RowBits seeds, RowBits within);

/** A flood over 4-neighbours, row by row of bits. */
class Flood
{
 public:
  /** What was reached of a tile. */
  struct Part
  {
    Tile* tile = nullptr;
    TileBits reached{};
    TileBits open{};        //!< cells that may be reached, of rows in `evaluated`
    RowBits evaluated = 0;  //!< rows
    RowBits pending = 0;    //!< rows that have yet to be spread
    bool isQueued = false;  //!< or being spread
  };

  explicit Flood(TileMap& tiles) : m_tiles(&tiles) {}

  /** Floods from a cell. \param open(tile, iy) gives the cells of a row that may be reached
   * \return the number of cells */
  template <class Open>
  std::int64_t from(const CellRef& seed, const Open& open)
  {
    m_parts.clear();
    m_queue.clear();
    m_number = m_tiles->nextFlood();
    reach(seed.tile, seed.iy, RowBits{1} << seed.ix, open);
    while (!m_queue.empty())
    {
      const std::uint32_t part = m_queue.back();
      m_queue.pop_back();
      spread(part, open);
    }
    return count();
  }

  const std::vector<Part>& parts() const { return m_parts; }
  /** The cells of a row that were reached. */
  RowBits row(const Tile& tile, std::int32_t iy) const
  {
    return tile.floodNumber == m_number
               ? m_parts[tile.floodIndex].reached[static_cast<std::size_t>(iy)]
               : 0;
  }
  /** Moments of what was reached. */
  PlaneMoments moments(const CellRef& origin) const;
  /** Makes what was reached, which has these moments, a plane. */
  void addPlane(const PlaneMoments& moments, PlaneSet& planes) const;

 private:
  std::int64_t count() const;
  std::uint32_t partOf(Tile& tile);

  template <class Open>
  void reach(Tile* tile, std::int32_t iy, RowBits bits, const Open& open)
  {
    if (!tile || !bits) return;
    const std::uint32_t index = partOf(*tile);
    Part& part = m_parts[index];
    const auto y = static_cast<std::size_t>(iy);
    const RowBits row = RowBits{1} << iy;
    if (!(part.evaluated & row))
    {
      part.open[y] = open(*tile, iy);
      part.evaluated |= row;
    }
    const RowBits fresh = bits & part.open[y] & ~part.reached[y];
    if (!fresh) return;
    part.reached[y] |= fresh;
    part.pending |= row;
    if (part.isQueued) return;
    part.isQueued = true;
    m_queue.push_back(index);
  }

  template <class Open>
  void spread(std::uint32_t index, const Open& open)
  {
    while (m_parts[index].pending)
    {
      Part& part = m_parts[index];  // which reach() may move
      Tile& tile = *part.tile;
      const std::int32_t iy = __builtin_ctz(part.pending);
      const auto y = static_cast<std::size_t>(iy);
      part.pending &= part.pending - 1;
      const RowBits row = filledRow(part.reached[y], part.open[y]);
      part.reached[y] = row;
      for (const std::int32_t step : {1, -1})
      {
        const std::int32_t to = iy + step;
        reach(tile.neighbour(0, to >> kTileBits), to & kTileMask, row, open);
      }
      reach(row & 1u ? tile.neighbour(-1, 0) : nullptr, iy, RowBits{1} << kTileMask, open);
      reach(row >> kTileMask ? tile.neighbour(1, 0) : nullptr, iy, 1, open);
    }
    m_parts[index].isQueued = false;
  }

  TileMap* m_tiles;
  std::uint64_t m_number = 0;
  std::vector<Part> m_parts;
  std::vector<std::uint32_t> m_queue;
};

}  // namespace mrpt_mapconv::terrain
