#include "Columns.h"

#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

namespace mrpt_mapconv::cloud
{
namespace
{
constexpr std::size_t kShown = 40;  // of a word that is none

bool isBlank(char c) { return c == ' ' || c == '\t'; }

void splitAtBlanks(std::string_view line, std::vector<std::string_view>& words)
{
  for (std::size_t at = 0; at < line.size();)
  {
    std::size_t end = at;
    while (end < line.size() && !isBlank(line[end])) ++end;
    if (end > at) words.push_back(line.substr(at, end - at));
    at = end + 1;
  }
}

std::string_view withoutBlanks(std::string_view word)
{
  while (!word.empty() && isBlank(word.front())) word.remove_prefix(1);
  while (!word.empty() && isBlank(word.back())) word.remove_suffix(1);
  return word;
}
}  // namespace

void Columns::add(std::string_view name, NumberType type, std::size_t count)
{
  const auto field = fieldNamed(name);
  const std::size_t bytes = sizeOf(type) * count;
  if (field && !m_fields[indexOf(*field)] && count > 0)
  {
    m_fields.set(indexOf(*field));
    m_used.push_back({*field, type, m_words, m_bytes, bytes});
  }
  else if (name != "_")  // PCL's padding
    m_others.emplace_back(name);
  m_words += count;
  m_bytes += bytes;
}

void Columns::requireCoordinates(const BlockInput& input) const
{
  if (!hasCoordinates()) input.fail("its points have not all of the coordinates x, y and z");
}

Row binaryRow(const Columns& columns, const char* point, bool bigEndian)
{
  Row row{};
  for (const auto& column : columns.used())
    row[indexOf(column.field)] = numberAt(point + column.at, column.type, bigEndian);
  return row;
}

bool readNumber(std::string_view word, double& number)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return params::readWhole(word, number);
}

void splitLine(std::string_view line, char separator, std::vector<std::string_view>& words)
{
  words.clear();
  if (separator == ' ') return splitAtBlanks(line, words);
  for (std::size_t at = 0;;)
  {
    const auto end = line.find(separator, at);
    words.push_back(withoutBlanks(line.substr(at, end - at)));
    if (end == std::string_view::npos) return;
    at = end + 1;
  }
}

Row textRow(const Columns& columns, const std::vector<std::string_view>& words,
            const BlockInput& input)
{
  if (words.size() != columns.words())
    input.failLine("has " + params::counted(words.size(), "column") + " where points have " +
                   std::to_string(columns.words()));
  Row row{};
  for (const auto& column : columns.used())
    if (!readNumber(words[column.word], row[indexOf(column.field)]))
      input.failLine("'" + params::printable(words[column.word], kShown) + "' in column " +
                     std::to_string(column.word + 1) + " is no number");
  return row;
}

}  // namespace mrpt_mapconv::cloud
