#pragma once

#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <algorithm>
#include <vector>

#include "ColumnMarks.h"

namespace mrpt_mapconv::path
{
/** What lies between two kept runs of a column. */
struct Slab
{
  std::int32_t kx;
  float bottom, top;  //!< end of the run below and begin of the run above [m]
};

/** The slabs of the marked columns of a voxel map: what the height layers do not show. */
class SlabMap
{
 public:
  /** Reads each block once.
   * \param minRun voxels that a kept run needs
   * \exception std::invalid_argument if a column's lowest and highest kept run are not what the
   * layers say */
  SlabMap(const voxel::VoxelSource& source, const freespace::Layers& layers, std::int32_t minRun,
          const ColumnMarks& columns);

  /** Calls visit(slab) for each slab of the columns [kxBegin, kxEnd) of row ky, but for rows of
   * blocks that have nothing between `lowest` and `highest` [m]. */
  template <class Visit>
  void forEach(std::int32_t ky, std::int32_t kxBegin, std::int32_t kxEnd, double lowest,
               double highest, const Visit& visit) const
  {
    if (ky < m_blocks.yMin * voxel::kBlockSide || ky >= (m_blocks.yMax + 1) * voxel::kBlockSide)
      return;
    const std::int32_t last = std::min(blockOf(kxEnd - 1), m_blocks.xMax);
    for (std::int32_t x = std::max(blockOf(kxBegin), m_blocks.xMin); x <= last; ++x)
    {
      const Piece& piece = m_pieces[pieceOf(x, ky)];
      if (piece.top <= lowest || piece.bottom >= highest) continue;
      for (std::size_t i = piece.begin; i < piece.end; ++i)
        if (const Slab& slab = m_slabs[i]; slab.kx >= kxBegin && slab.kx < kxEnd) visit(slab);
    }
  }

 private:
  /** The slabs of one row of one block. */
  struct Piece
  {
    std::size_t begin = 0, end = 0;
    float bottom = 0, top = 0;  // of all of them
  };
  std::size_t pieceOf(std::int32_t blockX, std::int32_t ky) const
  {
    const auto across = static_cast<std::size_t>(m_blocks.xMax - m_blocks.xMin + 1);
    return static_cast<std::size_t>(ky - m_blocks.yMin * voxel::kBlockSide) * across +
           static_cast<std::size_t>(blockX - m_blocks.xMin);
  }
  void addBlock(const voxel::ColumnBlock& block, const freespace::Layers& layers,
                std::int32_t minRun);

  Piece pieceSince(std::size_t begin) const;

  voxel::KeyRect m_blocks;
  std::vector<Piece> m_pieces;
  std::vector<Slab> m_slabs;
};

}  // namespace mrpt_mapconv::path
