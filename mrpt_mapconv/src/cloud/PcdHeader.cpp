#include "PcdHeader.h"

#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

#include <optional>
#include <vector>

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr std::size_t kShown = 40, kMostValues = 1U << 16U;  // a point's

/** The lines of the header, as words; those that are missing are empty. */
struct Lines
{
  std::vector<std::string> fields, types;
  std::vector<std::uint64_t> sizes, counts;
  std::optional<std::uint64_t> width, height, points;
  std::string data;
};

std::uint64_t wholeNumber(const std::string& word, const BlockInput& input)
{
  std::uint64_t number = 0;
  if (!params::readWhole(word, number))
    input.failLine("'" + params::printable(word, kShown) + "' is no whole number");
  return number;
}

std::vector<std::uint64_t> wholeNumbers(const std::vector<std::string>& words,
                                        const BlockInput& input)
{
  std::vector<std::uint64_t> numbers;
  numbers.reserve(words.size());
  for (const auto& word : words) numbers.push_back(wholeNumber(word, input));
  return numbers;
}

/** Takes what follows the first word of a line. */
void takeLine(const std::string& key, const std::vector<std::string>& values,
              const BlockInput& input, Lines& lines)
{
  const auto one = [&]
  {
    if (values.size() != 1) input.failLine(key + " needs one value");
    return values.front();
  };
  if (key == "FIELDS" || key == "COLUMNS") lines.fields = values;
  if (key == "SIZE") lines.sizes = wholeNumbers(values, input);
  if (key == "TYPE") lines.types = values;
  if (key == "COUNT") lines.counts = wholeNumbers(values, input);
  if (key == "WIDTH") lines.width = wholeNumber(one(), input);
  if (key == "HEIGHT") lines.height = wholeNumber(one(), input);
  if (key == "POINTS") lines.points = wholeNumber(one(), input);
  if (key == "DATA") lines.data = params::lowerCase(one());
}

Lines readLines(BlockInput& input)
{
  constexpr std::size_t kMostLines = 1000;
  Lines lines;
  std::vector<std::string_view> words;
  while (lines.data.empty())
  {
    const auto text = input.lineNumber() < kMostLines ? input.line() : std::nullopt;
    if (!text) input.fail("its header (of PCL) has no line DATA");
    splitLine(*text, ' ', words);
    if (words.empty()) continue;
    std::string key(words.front());
    for (char& c : key)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    takeLine(key, {words.begin() + 1, words.end()}, input, lines);
  }
  return lines;
}

std::optional<NumberType> typeOf(const std::string& type, std::uint64_t size)
{
  const char letter = type.size() == 1 ? params::lowerCase(type)[0] : '?';
  if (letter == 'f' && size == 4) return NumberType::Float32;
  if (letter == 'f' && size == 8) return NumberType::Float64;
  if (letter == 'i' && size == 1) return NumberType::Int8;
  if (letter == 'i' && size == 2) return NumberType::Int16;
  if (letter == 'i' && size == 4) return NumberType::Int32;
  if (letter == 'i' && size == 8) return NumberType::Int64;
  if (letter == 'u' && size == 1) return NumberType::Uint8;
  if (letter == 'u' && size == 2) return NumberType::Uint16;
  if (letter == 'u' && size == 4) return NumberType::Uint32;
  if (letter == 'u' && size == 8) return NumberType::Uint64;
  return {};
}

Columns columnsOf(const Lines& lines, const BlockInput& input)
{
  const std::size_t count = lines.fields.size();
  const auto check = [&](const char* key, std::size_t values)
  {
    if (values != 0 && values != count)
      input.fail("its line " + std::string(key) + " has " + params::counted(values, "value") +
                 " for " + params::counted(count, "field"));
  };
  check("SIZE", lines.sizes.size());
  check("TYPE", lines.types.size());
  check("COUNT", lines.counts.size());
  Columns columns;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string letter = lines.types.empty() ? "F" : lines.types[i];
    const std::uint64_t size = lines.sizes.empty() ? sizeof(float) : lines.sizes[i];
    const std::uint64_t values = lines.counts.empty() ? 1 : lines.counts[i];
    const auto type = typeOf(letter, size);
    if (!type || values > kMostValues || columns.words() > kMostValues)
      input.fail("its field " + params::printable(lines.fields[i], kShown) + " is of TYPE " +
                 params::printable(letter, kShown) + ", SIZE " + std::to_string(size) +
                 " and COUNT " + std::to_string(values) + ", which is not read");
    columns.add(lines.fields[i], *type, static_cast<std::size_t>(values));
  }
  return columns;
}

std::uint64_t pointsOf(const Lines& lines, const BlockInput& input)
{
  const std::uint64_t width = lines.width.value_or(0), height = lines.height.value_or(1);
  std::uint64_t product = 0;
  const bool tooMany = __builtin_mul_overflow(width, height, &product);
  if (!lines.width && !lines.points) input.fail("its header has neither POINTS nor WIDTH");
  if (lines.width && (tooMany || lines.points.value_or(product) != product))
    input.fail("its header says POINTS " + std::to_string(lines.points.value_or(product)) +
               ", but WIDTH " + std::to_string(width) + " and HEIGHT " + std::to_string(height));
  return lines.points.value_or(product);
}

PcdData dataOf(const Lines& lines, const BlockInput& input)
{
  if (lines.data == "ascii") return PcdData::Ascii;
  if (lines.data == "binary") return PcdData::Binary;
  if (lines.data == "binary_compressed") return PcdData::Compressed;
  input.failLine("DATA is " + params::printable(lines.data, kShown) +
                 "; ascii, binary and binary_compressed are read");
}
}  // namespace

PcdHeader readPcdHeader(BlockInput& input)
{
  const Lines lines = readLines(input);
  PcdHeader header{columnsOf(lines, input), pointsOf(lines, input), dataOf(lines, input)};
  header.columns.requireCoordinates(input);
  if (header.points == 0) input.fail("holds no point");
  return header;
}

}  // namespace mrpt_mapconv::cloud
