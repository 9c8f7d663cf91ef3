#include "SlabMap.h"

#include <mrpt_mapconv/params/Text.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace mrpt_mapconv::path
{
namespace
{
using voxel::kBlockColumns;
using voxel::kBlockSide;

/** Calls visit(begin, end) with the z keys of each run of free voxels of a column, upwards. */
template <class Visit>
void forEachFreeRun(const voxel::ColumnBlock& block, std::int32_t column, const Visit& visit)
{
  const std::uint64_t* plane = block.freePlane() + column;
  std::uint64_t below = 0;
  bool open = false;
  std::int32_t begin = 0;
  for (std::int32_t w = 0; w < block.words(); ++w)
  {
    const std::uint64_t word = plane[w * kBlockColumns];
    std::uint64_t changes = word ^ (word << 1 | below);
    below = word >> 63;
    for (; changes; changes &= changes - 1, open = !open)
    {
      const std::int32_t z = block.zMin() + 64 * w + __builtin_ctzll(changes);
      if (open) visit(begin, z);
      begin = z;
    }
  }
  if (open) visit(begin, block.zMin() + 64 * block.words());
}

bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::string inWords(float floor, float ceiling)
{
  using params::roundedText;
  return roundedText(static_cast<double>(floor)) + " and " +
         roundedText(static_cast<double>(ceiling)) + " m";
}

[[noreturn]] void throwOtherMap(std::int32_t kx, std::int32_t ky, float floor, float ceiling,
                                float layerFloor, float layerCeiling)
{
  std::ostringstream message;
  message << "voxel map: floor and ceiling of cell (" << kx << ", " << ky << ") are "
          << inWords(floor, ceiling) << ", but " << inWords(layerFloor, layerCeiling)
          << " in the layers; it must be the map that the layers were made of";
  throw std::invalid_argument(message.str());
}
}  // namespace

SlabMap::SlabMap(const voxel::VoxelSource& source, const freespace::Layers& layers,
                 std::int32_t minRun, const ColumnMarks& columns)
    : m_blocks(columns.blocks())
{
  const std::int32_t rowEnd = (m_blocks.yMax + 1) * kBlockSide;
  m_pieces.resize(pieceOf(m_blocks.xMin, rowEnd));
  voxel::ColumnBlock block;
  for (std::int32_t y = m_blocks.yMin; y <= m_blocks.yMax; ++y)
    for (std::int32_t x = m_blocks.xMin; x <= m_blocks.xMax; ++x)
    {
      const voxel::ColumnMask wanted = columns.mask({x, y});
      if (std::all_of(wanted.begin(), wanted.end(), [](std::uint32_t row) { return row == 0; }))
        continue;
      block.start({x, y}, wanted);
      source.read(block);
      addBlock(block, layers, minRun);
    }
}

void SlabMap::addBlock(const voxel::ColumnBlock& block, const freespace::Layers& layers,
                       std::int32_t minRun)
{
  const grid::GridFrame& frame = layers.frame();
  const auto metres = [&](std::int32_t z) { return static_cast<float>(z * frame.resolution); };
  for (std::int32_t y = block.rowBegin(); y < block.rowEnd(); ++y)
  {
    const std::int32_t ky = block.key().y * kBlockSide + y;
    const std::size_t before = m_slabs.size();
    for (std::uint32_t row = block.wanted()[static_cast<std::size_t>(y)]; row; row &= row - 1)
    {
      const std::int32_t x = __builtin_ctz(row), kx = block.key().x * kBlockSide + x;
      float floor = freespace::Layers::kNone, ceiling = freespace::Layers::kNone;
      forEachFreeRun(block, y * kBlockSide + x,
                     [&](std::int32_t begin, std::int32_t end)
                     {
                       if (end - begin < minRun) return;
                       if (std::isnan(floor))
                         floor = metres(begin);
                       else
                         m_slabs.push_back({kx, ceiling, metres(begin)});
                       ceiling = metres(end);
                     });
      const std::size_t cell = frame.indexOfKey(kx, ky);
      const float layerFloor = layers.floor.cells()[cell];
      const float layerCeiling = layers.ceiling.cells()[cell];
      if (!same(floor, layerFloor) || !same(ceiling, layerCeiling))
        throwOtherMap(kx, ky, floor, ceiling, layerFloor, layerCeiling);
    }
    m_pieces[pieceOf(block.key().x, ky)] = pieceSince(before);
  }
}

SlabMap::Piece SlabMap::pieceSince(std::size_t begin) const
{
  Piece piece{begin, m_slabs.size()};
  for (std::size_t i = begin; i < piece.end; ++i)
  {
    const Slab& slab = m_slabs[i];
    piece.bottom = i == begin ? slab.bottom : std::min(piece.bottom, slab.bottom);
    piece.top = i == begin ? slab.top : std::max(piece.top, slab.top);
  }
  return piece;
}

}  // namespace mrpt_mapconv::path
