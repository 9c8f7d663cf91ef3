#include "Rasters.h"

#include <array>

namespace mrpt_mapconv::scan
{
namespace
{
using Block = std::array<std::uint64_t, 64>;  //!< of 64 × 64 bits, row by row

/** Exchanges rows and columns: first those of the four quarters, then those within each, … */
void transpose(Block& block)
{
  std::uint64_t low = 0x00000000FFFFFFFFu;
  for (std::size_t size = 32; size > 0; size /= 2, low ^= low << size)
    for (std::size_t i = 0; i < 64; i = ((i | size) + 1) & ~size)
    {
      const std::uint64_t swap = ((block[i] >> size) ^ block[i | size]) & low;
      block[i] ^= swap << size;
      block[i | size] ^= swap;
    }
}

/** The block at rows from 64·blockRow and words from blockColumn; false if it is empty. */
bool readBlock(const CellBits& bits, std::int32_t blockRow, std::int32_t blockColumn, Block& block)
{
  const std::int32_t rows = std::min(64, bits.frame().height - 64 * blockRow);
  std::uint64_t any = 0;
  block.fill(0);
  for (std::int32_t i = 0; i < rows; ++i)
    any |= block[static_cast<std::size_t>(i)] = bits.row(64 * blockRow + i)[blockColumn];
  return any != 0;
}

/** Adds a square raster to another one with rows and columns exchanged. */
void addTransposed(const CellBits& from, CellBits& to)
{
  const auto blocks = static_cast<std::int32_t>(from.wordsPerRow());
  Block block;
  for (std::int32_t row = 0; row < blocks; ++row)
    for (std::int32_t column = 0; column < blocks; ++column)
    {
      if (!readBlock(from, row, column, block)) continue;
      transpose(block);
      const std::int32_t rows = std::min(64, to.frame().height - 64 * column);
      for (std::int32_t i = 0; i < rows; ++i)
        to.row(64 * column + i)[row] |= block[static_cast<std::size_t>(i)];
    }
}
}  // namespace

void Rasters::reset(const grid::GridFrame& square)
{
  for (CellBits* bits : {&object, &wall, &any, &occupied, &free}) bits->reset(square);
}

void Rasters::findAny()
{
  const std::size_t words = any.wordsPerRow() * static_cast<std::size_t>(any.frame().height);
  const std::uint64_t *objects = object.row(0), *walls = wall.row(0);
  std::uint64_t* both = any.row(0);
  for (std::size_t i = 0; i < words; ++i) both[i] = objects[i] | walls[i];
}

void Rasters::mergeTransposed(const Rasters& columns)
{
  addTransposed(columns.occupied, occupied);
  addTransposed(columns.free, free);
}

}  // namespace mrpt_mapconv::scan
