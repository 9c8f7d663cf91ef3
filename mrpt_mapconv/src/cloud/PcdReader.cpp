#include <liblzf/lzf.h>

#include <utility>

#include "CloudBuilder.h"
#include "PcdFile.h"
#include "PcdHeader.h"

namespace mrpt_mapconv::cloud
{
namespace
{
void readAscii(BlockInput& input, const PcdHeader& header, CloudBuilder& builder)
{
  std::vector<std::string_view> words;
  for (std::uint64_t i = 0; i < header.points;)
  {
    const auto line = input.line();
    if (!line) input.failTruncated(header.points, i);
    splitLine(*line, ' ', words);
    if (words.empty()) continue;
    builder.add(textRow(header.columns, words, input));
    ++i;
  }
}

void readBinary(BlockInput& input, const PcdHeader& header, CloudBuilder& builder)
{
  for (std::uint64_t i = 0; i < header.points; ++i)
  {
    const char* point = input.take(header.columns.bytes());
    if (!point) input.failTruncated(header.points, i);
    builder.add(binaryRow(header.columns, point));
  }
}

/** The points, unpacked: all values of the first field, all of the second, and so on. */
std::string unpacked(BlockInput& input, const PcdHeader& header)
{
  constexpr std::uint64_t kMostFromOne = 264;  // bytes that liblzf can make of a few
  const char* sizes = input.take(2 * sizeof(std::uint32_t));
  if (!sizes) input.fail("is truncated before its packed points");
  const auto packedSize = numberAt<std::uint32_t>(sizes);
  const auto size = numberAt<std::uint32_t>(sizes + sizeof(std::uint32_t));
  if (header.points > size || header.points * header.columns.bytes() != size)
    input.fail("its header promises " + std::to_string(header.points) + " points of " +
               std::to_string(header.columns.bytes()) + " bytes, its packed data " +
               std::to_string(size) + " bytes");
  const std::string packed = input.bytes(packedSize);
  if (packed.size() < packedSize) input.fail("is truncated within its packed points");
  std::string bytes;
  if (size / kMostFromOne <= packed.size()) bytes.resize(size);
  if (bytes.size() != size || lzf_decompress(packed.data(), packedSize, bytes.data(), size) != size)
    input.fail("its packed points are damaged");
  return bytes;
}

void readCompressed(BlockInput& input, const PcdHeader& header, CloudBuilder& builder)
{
  const std::string bytes = unpacked(input, header);
  const auto points = static_cast<std::size_t>(header.points);
  for (std::size_t i = 0; i < points; ++i)
  {
    Row row{};
    for (const auto& column : header.columns.used())
      row[indexOf(column.field)] =
          numberAt(bytes.data() + column.at * points + i * column.bytes, column.type);
    builder.add(row);
  }
}
}  // namespace

PointCloud readPcd(BlockInput& input, const CloudReading& reading)
{
  const PcdHeader header = readPcdHeader(input);
  CloudBuilder builder(input.name(), header.columns.fields());
  const char* format = "PCD, ascii";
  switch (header.data)
  {
    case PcdData::Ascii:
      readAscii(input, header, builder);
      break;
    case PcdData::Binary:
      builder.reserve(header.points, input.fileSize(), header.columns.bytes());
      readBinary(input, header, builder);
      format = "PCD, binary";
      break;
    case PcdData::Compressed:
      readCompressed(input, header, builder);
      format = "PCD, binary_compressed";
      break;
  }
  PointCloud cloud = std::move(builder).finished(reading);
  cloud.format = format;
  cloud.otherFields = header.columns.others();
  return cloud;
}

}  // namespace mrpt_mapconv::cloud
