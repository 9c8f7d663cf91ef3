#include <utility>
#include <vector>

#include "CloudBuilder.h"
#include "Columns.h"
#include "PlyFile.h"
#include "PlyHeader.h"

namespace mrpt_mapconv::cloud
{
namespace
{
using Words = std::vector<std::string_view>;

/** Lists have no place among columns, and are no field. */
Columns columnsOf(const PlyElement& element)
{
  Columns columns;
  for (const auto& property : element.properties)
    columns.add(property.name, property.type, property.listCount ? 0 : 1);
  return columns;
}

/** Leaves out the words of lists. */
Words withoutLists(const Words& words, const PlyElement& element, const BlockInput& input)
{
  Words kept;
  std::size_t at = 0;
  for (const auto& property : element.properties)
  {
    if (at >= words.size()) input.failLine("has too few numbers");
    const std::string_view word = words[at++];
    if (!property.listCount)
    {
      kept.push_back(word);
      continue;
    }
    double count = 0;
    if (!readNumber(word, count) || !(count >= 0 && count <= static_cast<double>(words.size())))
      input.failLine("has a list with fewer numbers than it says");
    at += static_cast<std::size_t>(count);
  }
  if (at != words.size()) input.failLine("has not as many numbers as its lists say");
  return kept;
}

/** The next line that is not empty, as words. \return false at the end */
bool nextWords(BlockInput& input, Words& words)
{
  do
  {
    const auto line = input.line();
    if (!line) return false;
    splitLine(*line, ' ', words);
  } while (words.empty());
  return true;
}

void readAscii(BlockInput& input, const PlyElement& vertex, const Columns& columns,
               CloudBuilder& builder)
{
  Words words;
  for (std::uint64_t i = 0; i < vertex.count; ++i)
  {
    if (!nextWords(input, words)) input.failTruncated(vertex.count, i);
    builder.add(
        textRow(columns, vertex.hasList() ? withoutLists(words, vertex, input) : words, input));
  }
}

/** Reads a list's values over. \return false if it is cut off */
bool skipList(BlockInput& input, const PlyProperty& list, bool bigEndian)
{
  const char* bytes = input.take(sizeOf(*list.listCount));
  if (!bytes) return false;
  const double count = numberAt(bytes, *list.listCount, bigEndian);
  constexpr double kMost = 4294967295.0;
  if (!(count >= 0 && count <= kMost)) return false;
  return input.skip(static_cast<std::uint64_t>(count) * sizeOf(list.type));
}

/** Reads an element that has lists. \return false if it is cut off */
bool takeScalars(BlockInput& input, const PlyElement& element, bool bigEndian,
                 std::vector<double>& scalars)
{
  scalars.clear();
  for (const auto& property : element.properties)
  {
    if (property.listCount)
    {
      if (!skipList(input, property, bigEndian)) return false;
      continue;
    }
    const char* bytes = input.take(sizeOf(property.type));
    if (!bytes) return false;
    scalars.push_back(numberAt(bytes, property.type, bigEndian));
  }
  return true;
}

void readBinaryLists(BlockInput& input, const PlyElement& vertex, const Columns& columns,
                     bool bigEndian, CloudBuilder& builder)
{
  std::vector<double> scalars;
  for (std::uint64_t i = 0; i < vertex.count; ++i)
  {
    if (!takeScalars(input, vertex, bigEndian, scalars)) input.failTruncated(vertex.count, i);
    Row row{};
    for (const auto& column : columns.used()) row[indexOf(column.field)] = scalars[column.word];
    builder.add(row);
  }
}

void readBinary(BlockInput& input, const PlyElement& vertex, const Columns& columns, bool bigEndian,
                CloudBuilder& builder)
{
  if (vertex.hasList()) return readBinaryLists(input, vertex, columns, bigEndian, builder);
  builder.reserve(vertex.count, input.fileSize(), columns.bytes());
  for (std::uint64_t i = 0; i < vertex.count; ++i)
  {
    const char* point = input.take(columns.bytes());
    if (!point) input.failTruncated(vertex.count, i);
    builder.add(binaryRow(columns, point, bigEndian));
  }
}

/** Reads over what comes before the vertices. */
void skipElement(BlockInput& input, const PlyElement& element, PlyData data)
{
  const auto failCutOff = [&] { input.fail("is truncated within its elements " + element.name); };
  if (element.properties.empty()) return;
  if (data == PlyData::Ascii)
  {
    Words words;
    for (std::uint64_t i = 0; i < element.count; ++i)
      if (!nextWords(input, words)) failCutOff();
  }
  else if (element.hasList())
  {
    std::vector<double> scalars;
    for (std::uint64_t i = 0; i < element.count; ++i)
      if (!takeScalars(input, element, data == PlyData::BigEndian, scalars)) failCutOff();
  }
  else
  {
    std::uint64_t bytes = 0;
    if (__builtin_mul_overflow(element.count, std::uint64_t(element.bytes()), &bytes) ||
        !input.skip(bytes))
      failCutOff();
  }
}
}  // namespace

PointCloud readPly(BlockInput& input, const CloudReading& reading)
{
  const PlyHeader header = readPlyHeader(input);
  const PlyElement& vertex = header.elements.back();
  const Columns columns = columnsOf(vertex);
  columns.requireCoordinates(input);
  for (std::size_t i = 0; i + 1 < header.elements.size(); ++i)
    skipElement(input, header.elements[i], header.data);

  CloudBuilder builder(input.name(), columns.fields());
  if (header.data == PlyData::Ascii)
    readAscii(input, vertex, columns, builder);
  else
    readBinary(input, vertex, columns, header.data == PlyData::BigEndian, builder);
  PointCloud cloud = std::move(builder).finished(reading);
  cloud.format = header.data == PlyData::Ascii       ? "PLY, ascii"
                 : header.data == PlyData::BigEndian ? "PLY, binary, big endian"
                                                     : "PLY, binary, little endian";
  cloud.otherFields = columns.others();
  return cloud;
}

}  // namespace mrpt_mapconv::cloud
