#include <mrpt_mapconv/params/Require.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "PointBatch.h"
#include "TerrainMapImpl.h"

namespace mrpt_mapconv::terrain
{
double TerrainPlane::slope() const { return std::hypot(slopeX, slopeY); }

TerrainMap::TerrainMap(double resolution, const TerrainParams& params)
    : m_impl(std::make_unique<Impl>(resolution, params))
{
}
TerrainMap::~TerrainMap() = default;
TerrainMap::TerrainMap(const TerrainMap& o) : m_impl(std::make_unique<Impl>(*o.m_impl)) {}
TerrainMap& TerrainMap::operator=(const TerrainMap& o)
{
  if (this != &o) m_impl = std::make_unique<Impl>(*o.m_impl);
  return *this;
}
TerrainMap::TerrainMap(TerrainMap&&) noexcept = default;
TerrainMap& TerrainMap::operator=(TerrainMap&&) noexcept = default;

double TerrainMap::resolution() const { return m_impl->resolution; }
const TerrainParams& TerrainMap::params() const { return m_impl->params; }

InsertedPoints TerrainMap::insert(const TerrainScan& scan, const PointSigmas& sigmas)
{
  const PointModel model(scan, sigmas, m_impl->resolution);
  model.checkRange();
  m_impl->moveWindow(scan.robotPose.x(), scan.robotPose.y());
  InsertedPoints result;
  TileCache cache(m_impl->tiles);
  PointModel::Batch batch;
  for (std::size_t first = 0; first < scan.points; first += PointModel::kBatch)
  {
    const std::size_t count = std::min(PointModel::kBatch, scan.points - first);
    model.compute(first, count, batch);
    m_impl->add(cache, batch, count, result);
  }
  result.inserted = scan.points - result.notFinite - result.outside;
  return result;
}

void TerrainMap::insertPoint(double x, double y, double z, double sigma)
{
  params::require(std::isfinite(sigma) && sigma >= 0, "sigma", sigma,
                  "a standard deviation >= 0 m");
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return;
  const PointModel::Place place = PointModel::placeOf(x, y, z, m_impl->resolution);
  if (m_impl->window && !m_impl->window->holds(place.kx, place.ky)) return;
  Tile& tile = m_impl->tiles.get(place.kx >> kTileBits, place.ky >> kTileBits);
  m_impl->add(tile, Tile::indexOf(place.kx & kTileMask, place.ky & kTileMask), place.z,
              PointModel::weightOf(sigma * sigma));
}

void TerrainMap::update(int threads) { m_impl->follow(threads); }

void TerrainMap::extract(int threads)
{
  m_impl->forgetPlanes();
  m_impl->follow(threads);
}

void TerrainMap::clear() { *m_impl = Impl(m_impl->resolution, m_impl->params); }

std::size_t TerrainMap::cells() const { return m_impl->cells; }

std::int32_t TerrainMap::keyOf(double x) const
{
  using Keys = std::numeric_limits<std::int32_t>;
  const double key = std::floor(x / m_impl->resolution + 0.5);
  return key > Keys::min() && key <= Keys::max() ? static_cast<std::int32_t>(key) : Keys::min();
}

std::optional<TerrainCell> TerrainMap::cell(std::int32_t kx, std::int32_t ky) const
{
  const CellRef cell = m_impl->tiles.cell(kx, ky);
  if (!cell) return std::nullopt;
  const CellSums& sums = cell.tile->sums[cell.index()];
  if (sums.points == 0) return std::nullopt;
  const bool fused = m_impl->params.heightRule == HeightRule::Fused;
  TerrainCell out;
  out.points = sums.points;
  out.height = kHeightUnit * (fused ? sums.fusedZ() : sums.highestZ());
  out.variance = m_impl->varianceOf(sums);
  return out;
}

grid::GridFrame TerrainMap::frame() const
{
  grid::GridFrame frame;
  frame.resolution = m_impl->resolution;
  frame.shift = -0.5;
  for (const Tile* tile : m_impl->tiles.sorted())
  {
    RowBits columns = 0, rows = 0;
    for (std::size_t iy = 0; iy < kTileSide; ++iy)
    {
      const RowBits row = tile->known[iy] | tile->changed[iy];
      columns |= row;
      rows |= row ? RowBits{1} << iy : 0;
    }
    if (!columns) continue;
    const auto low = [](RowBits bits) { return __builtin_ctz(bits); };
    const auto size = [&](RowBits bits) { return 32 - __builtin_clz(bits) - low(bits); };
    grid::GridFrame part = frame;
    part.x0 = tile->keyX(low(columns));
    part.y0 = tile->keyY(low(rows));
    part.width = size(columns);
    part.height = size(rows);
    frame = unite(frame, part);
  }
  return frame;
}

const std::vector<TerrainPlane>& TerrainMap::planes() const { return m_impl->list; }
std::size_t TerrainMap::leaves() const { return m_impl->tree.count(m_impl->tiles); }

std::optional<TerrainPoint> TerrainMap::at(double x, double y) const
{
  const CellRef cell = m_impl->knownCell(keyOf(x), keyOf(y));
  if (!cell) return std::nullopt;
  const Leaf leaf = m_impl->tree.at(cell);
  TerrainPoint point;
  point.leafSide = 1 << leaf.level;
  point.plane = m_impl->indexOf(leaf.plane);
  if (leaf.plane == kNoPlane)
  {
    point.height = kHeightUnit * leaf.height;
    return point;
  }
  const TerrainPlane& plane = m_impl->list[static_cast<std::size_t>(point.plane)];
  point.height = plane.heightAt(x, y);
  const double length = std::hypot(plane.slopeX, plane.slopeY, 1.0);
  point.normal = {-plane.slopeX / length, -plane.slopeY / length, 1 / length};
  return point;
}

std::vector<TerrainLeaf> TerrainMap::leavesIn(double xMin, double yMin, double xMax,
                                              double yMax) const
{
  const auto key = [this](double v)
  { return keyOf(std::clamp(v / m_impl->resolution, -1e9, 1e9) * m_impl->resolution); };
  std::vector<TerrainLeaf> leaves;
  for (const Leaf& leaf :
       m_impl->tree.within(m_impl->tiles, key(xMin), key(yMin), key(xMax), key(yMax)))
  {
    TerrainLeaf out{leaf.x, leaf.y, 1 << leaf.level, m_impl->indexOf(leaf.plane),
                    kHeightUnit * leaf.height};
    if (out.plane != kNoPlane)
    {
      const double middle = 0.5 * (out.side - 1);
      out.height = m_impl->list[static_cast<std::size_t>(out.plane)].heightAt(
          (leaf.x + middle) * m_impl->resolution, (leaf.y + middle) * m_impl->resolution);
    }
    leaves.push_back(out);
  }
  return leaves;
}

std::size_t TerrainMap::memory() const
{
  std::size_t bytes = m_impl->tree.memory() + m_impl->list.capacity() * sizeof(TerrainPlane) +
                      static_cast<std::size_t>(m_impl->planes.end()) * sizeof(PlaneState);
  for (const Tile* tile : m_impl->tiles.sorted())
    bytes += sizeof(Tile) + tile->leaves.capacity() * sizeof(TileLeaf) +
             tile->planes.capacity() * sizeof(TilePlane);
  return bytes;
}

}  // namespace mrpt_mapconv::terrain
