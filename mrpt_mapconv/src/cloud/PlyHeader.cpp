#include "PlyHeader.h"

#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>

#include "Columns.h"

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr std::size_t kShown = 40, kMostLines = 100000;
using Words = std::vector<std::string_view>;

struct TypeName
{
  std::string_view name;
  NumberType type;
};

constexpr TypeName kTypes[] = {
    {"char", NumberType::Int8},      {"int8", NumberType::Int8},
    {"uchar", NumberType::Uint8},    {"uint8", NumberType::Uint8},
    {"short", NumberType::Int16},    {"int16", NumberType::Int16},
    {"ushort", NumberType::Uint16},  {"uint16", NumberType::Uint16},
    {"int", NumberType::Int32},      {"int32", NumberType::Int32},
    {"uint", NumberType::Uint32},    {"uint32", NumberType::Uint32},
    {"int64", NumberType::Int64},    {"uint64", NumberType::Uint64},
    {"float", NumberType::Float32},  {"float32", NumberType::Float32},
    {"double", NumberType::Float64}, {"float64", NumberType::Float64},
};

NumberType typeNamed(std::string_view name, const BlockInput& input)
{
  for (const auto& type : kTypes)
    if (type.name == name) return type.type;
  input.failLine("'" + params::printable(name, kShown) + "' is no type of PLY");
}

PlyData dataNamed(std::string_view name, const BlockInput& input)
{
  if (name == "ascii") return PlyData::Ascii;
  if (name == "binary_little_endian") return PlyData::LittleEndian;
  if (name == "binary_big_endian") return PlyData::BigEndian;
  input.failLine("'" + params::printable(name, kShown) +
                 "' is no format of PLY; ascii, binary_little_endian and binary_big_endian are");
}

PlyElement elementOf(const Words& words, const BlockInput& input)
{
  PlyElement element;
  if (words.size() != 3 || !params::readWhole(words[2], element.count))
    input.failLine("must be 'element', a name and a whole number");
  element.name = words[1];
  return element;
}

PlyProperty propertyOf(const Words& words, const BlockInput& input)
{
  if (words.size() == 3) return {std::string(words[2]), typeNamed(words[1], input)};
  if (words.size() == 5 && words[1] == "list")
    return {std::string(words[4]), typeNamed(words[3], input), typeNamed(words[2], input)};
  input.failLine("must be 'property', a type and a name");
}

/** Elements behind the vertices are of no use. */
void keepUpToVertices(std::vector<PlyElement>& elements, const BlockInput& input)
{
  const auto vertices = std::find_if(elements.begin(), elements.end(),
                                     [](const PlyElement& e) { return e.name == "vertex"; });
  if (vertices == elements.end()) input.fail("its header (of PLY) has no element vertex");
  if (vertices->count == 0) input.fail("holds no point");
  elements.erase(vertices + 1, elements.end());
}
}  // namespace

bool PlyElement::hasList() const
{
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.listCount.has_value(); });
}

std::size_t PlyElement::bytes() const
{
  std::size_t sum = 0;
  for (const auto& property : properties)
    if (!property.listCount) sum += sizeOf(property.type);
  return sum;
}

PlyHeader readPlyHeader(BlockInput& input)
{
  PlyHeader header;
  Words words;
  bool hasFormat = false;
  for (;;)
  {
    const auto line = input.lineNumber() < kMostLines ? input.line() : std::nullopt;
    if (!line) input.fail("its header (of PLY) has no line end_header");
    splitLine(*line, ' ', words);
    if (words.empty()) continue;
    if (words[0] == "end_header") break;
    if (words[0] == "format" && words.size() > 1)
    {
      header.data = dataNamed(words[1], input);
      hasFormat = true;
    }
    if (words[0] == "element") header.elements.push_back(elementOf(words, input));
    if (words[0] != "property") continue;
    if (header.elements.empty()) input.failLine("a property before the first element");
    header.elements.back().properties.push_back(propertyOf(words, input));
  }
  if (!hasFormat) input.fail("its header (of PLY) has no line format");
  keepUpToVertices(header.elements, input);
  return header;
}

}  // namespace mrpt_mapconv::cloud
