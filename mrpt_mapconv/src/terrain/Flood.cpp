#include "Flood.h"

#include <cmath>

#include "../grid/Wide.h"

namespace mrpt_mapconv::terrain
{
namespace
{
constexpr std::array<std::uint64_t, kTileSide> bitsOfColumns()
{
  std::array<std::uint64_t, kTileSide> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = std::uint64_t{1} << i;
  return bits;
}
constexpr auto kColumns = bitsOfColumns();

/** \param row height at column 0, but for slopeX·dx \param dx of column 0 from the origin */
MRPT_MAPCONV_WIDE
RowBits nearRow(const std::int32_t* __restrict heights, double row, double slopeX, double dx,
                double tolerance)
{
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kTileSide; ++i)
  {
    const double plane = row + slopeX * (dx + static_cast<double>(static_cast<std::int32_t>(i)));
    const double off = std::fabs(static_cast<double>(heights[i]) - plane);
    bits |= off <= tolerance ? kColumns[i] : 0;
  }
  return static_cast<RowBits>(bits);
}
}  // namespace

RowBits nearPlane(const Plane& plane, double tolerance, const Tile& tile, std::int32_t iy,
                  RowBits of)
{
  if (!of) return 0;
  const double dx = static_cast<double>(tile.keyX(0) - plane.originX),
               dy = static_cast<double>(tile.keyY(iy) - plane.originY);
  return of & nearRow(tile.height.data() + static_cast<std::size_t>(iy) * kTileSide,
                      plane.height + plane.slopeY * dy, plane.slopeX, dx, tolerance);
}

RowBits filledRow(RowBits seeds, RowBits within)
{
  RowBits up = seeds, down = seeds, upThrough = within, downThrough = within;
  for (int shift = 1; shift < kTileSide; shift *= 2)
  {
    up |= upThrough & up << shift;
    upThrough &= upThrough << shift;
    down |= downThrough & down >> shift;
    downThrough &= downThrough >> shift;
  }
  return up | down;
}

std::uint32_t Flood::partOf(Tile& tile)
{
  if (tile.floodNumber == m_number) return tile.floodIndex;
  tile.floodNumber = m_number;
  tile.floodIndex = static_cast<std::uint32_t>(m_parts.size());
  m_parts.emplace_back();
  m_parts.back().tile = &tile;
  return tile.floodIndex;
}

std::int64_t Flood::count() const
{
  std::int64_t cells = 0;
  for (const Part& part : m_parts)
    for (const RowBits row : part.reached) cells += countOf(row);
  return cells;
}

PlaneMoments Flood::moments(const CellRef& origin) const
{
  PlaneMoments moments(origin.keyX(), origin.keyY(), origin.tile->height[origin.index()]);
  for (const Part& part : m_parts)
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
    {
      const std::int32_t* heights =
          part.tile->height.data() + static_cast<std::size_t>(iy) * kTileSide;
      const std::int32_t kx = part.tile->keyX(0), ky = part.tile->keyY(iy);
      forEachBit(part.reached[static_cast<std::size_t>(iy)],
                 [&](std::int32_t bit) { moments.add(kx + bit, ky, heights[bit]); });
    }
  return moments;
}

void Flood::addPlane(const PlaneMoments& moments, PlaneSet& planes) const
{
  const std::int32_t id = planes.add(moments);
  for (const Part& part : m_parts)
  {
    planes.at(id).tiles.take(*part.tile);
    for (std::int32_t iy = 0; iy < kTileSide; ++iy)
      forEachBit(part.reached[static_cast<std::size_t>(iy)],
                 [&](std::int32_t ix) { part.tile->assign(Tile::indexOf(ix, iy), id); });
  }
}

}  // namespace mrpt_mapconv::terrain
