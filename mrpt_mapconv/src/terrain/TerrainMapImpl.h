#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <array>
#include <vector>

#include "Extraction.h"
#include "LeafTree.h"
#include "PlaneSet.h"
#include "PointBatch.h"
#include "SeedPlane.h"
#include "TileMap.h"

namespace mrpt_mapconv::terrain
{
/** Finds the tiles of points, which mostly lie where others just did. */
class TileCache
{
 public:
  explicit TileCache(TileMap& tiles) : m_tiles(tiles) {}
  Tile& at(std::int32_t tx, std::int32_t ty)
  {
    if (m_last.tile && m_last.tx == tx && m_last.ty == ty) return *m_last.tile;
    Entry& entry = m_entries[static_cast<std::size_t>((tx & 15) | (ty & 15) << 4)];
    if (!entry.tile || entry.tx != tx || entry.ty != ty) entry = {tx, ty, &m_tiles.get(tx, ty)};
    m_last = entry;
    return *entry.tile;
  }

 private:
  struct Entry
  {
    std::int32_t tx = 0, ty = 0;
    Tile* tile = nullptr;
  };
  TileMap& m_tiles;
  Entry m_last;
  std::array<Entry, 256> m_entries{};
};

/** A square of keys, both ends included. */
struct KeyWindow
{
  std::int32_t xMin = 0, yMin = 0, xMax = 0, yMax = 0;
  bool holds(std::int32_t kx, std::int32_t ky) const
  {
    return kx >= xMin && kx <= xMax && ky >= yMin && ky <= yMax;
  }
};

class TerrainMap::Impl
{
 public:
  Impl(double l, const TerrainParams& p);

  /** Adds a point to a cell. */
  void add(Tile& tile, std::size_t at, std::int32_t z, std::uint32_t weight)
  {
    CellSums& sums = tile.sums[at];
    sums.add(z, weight);
    if (sums.isMarked) return;
    sums.isMarked = 1;
    cells += sums.points == 1 ? 1 : 0;
    tile.changed[at >> kTileBits] |= RowBits{1} << (at & kTileMask);
    tile.hasChanged = true;
  }
  void add(TileCache& cache, const PointModel::Batch& batch, std::size_t count,
           InsertedPoints& result);
  void moveWindow(double x, double y);
  void follow(int threads);
  void forgetPlanes();
  void listPlanes();

  CellRef knownCell(std::int32_t kx, std::int32_t ky) const;
  std::int32_t indexOf(std::int32_t id) const
  {
    return id == kNoPlane ? kNoPlane : indices[static_cast<std::size_t>(id)];
  }
  void fillLeaf(const Leaf& leaf, const Tile& tile, TerrainLayers& layers) const;
  void markWhatStands(const Tile& tile, TerrainLayers& layers) const;
  /** Of a cell's height [m²]. */
  double varianceOf(const CellSums& sums) const
  {
    const bool fused = params.heightRule == HeightRule::Fused;
    return kWeightUnit / static_cast<double>(fused ? sums.weight : sums.highestWeight());
  }
  double slopeUnit() const { return kHeightUnit / resolution; }  //!< of Plane::slopeX [m/m]

  double resolution;
  TerrainParams params;
  PlaneSearch search;
  TileMap tiles;
  PlaneSet planes;
  LeafTree tree;
  std::size_t cells = 0;
  bool allOpen = false;               //!< all cells are to be looked at, not just changed ones
  std::vector<TerrainPlane> list;     //!< of planes that are alive, by their first cells
  std::vector<std::int32_t> indices;  //!< in the list, by the planes' numbers
  std::optional<KeyWindow> window;

 private:
  OpenCells takeChanges();
  void takeRow(Tile& tile, std::int32_t iy);
  static RowBits seedsOf(Tile& tile, std::int32_t iy, RowBits open);
  void forget(Tile& tile, const TileBits& outside);
};

}  // namespace mrpt_mapconv::terrain
