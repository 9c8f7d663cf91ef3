#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "BlockInput.h"
#include "Numbers.h"

namespace mrpt_mapconv::cloud
{
enum class PlyData
{
  Ascii,
  LittleEndian,
  BigEndian
};

struct PlyProperty
{
  std::string name;
  NumberType type = NumberType::Float32;
  std::optional<NumberType> listCount = {};  //!< of a list: the type of its number of values
};

/** What a file has `count` of: vertices, faces, … */
struct PlyElement
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties = {};

  bool hasList() const;
  std::size_t bytes() const;  //!< of one, without lists
};

/** The lines before the data of a `.ply`. */
struct PlyHeader
{
  PlyData data = PlyData::Ascii;
  std::vector<PlyElement> elements;  //!< up to the vertices, which are the last
};

/** Reads it up to its last line, end_header. \exception std::runtime_error naming the file, and the
 * line or what is missing */
PlyHeader readPlyHeader(BlockInput& input);

}  // namespace mrpt_mapconv::cloud
