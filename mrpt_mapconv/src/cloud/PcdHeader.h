#pragma once

#include <cstdint>
#include <string>

#include "BlockInput.h"
#include "Columns.h"

namespace mrpt_mapconv::cloud
{
enum class PcdData
{
  Ascii,
  Binary,
  Compressed
};

/** The lines before the points of a `.pcd`. */
struct PcdHeader
{
  Columns columns;
  std::uint64_t points = 0;
  PcdData data = PcdData::Ascii;
};

/** Reads it up to its last line, DATA. \exception std::runtime_error naming the file, and the line
 * or what is missing */
PcdHeader readPcdHeader(BlockInput& input);

}  // namespace mrpt_mapconv::cloud
