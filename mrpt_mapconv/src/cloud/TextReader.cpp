#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "CloudBuilder.h"
#include "Columns.h"
#include "TextFile.h"

namespace mrpt_mapconv::cloud
{
namespace
{
using Words = std::vector<std::string_view>;

char separatorOf(std::string_view line)
{
  for (const char separator : {';', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

/** The text of a comment; none for all other lines. */
std::optional<std::string_view> commentOf(std::string_view line)
{
  if (line.substr(0, 1) != "#" && line.substr(0, 2) != "//") return {};
  const auto text = line.find_first_not_of("#/ \t");
  return text == std::string_view::npos ? "" : line.substr(text);
}

std::vector<std::string> namesIn(std::string_view line)
{
  Words words;
  splitLine(line, separatorOf(line), words);
  std::vector<std::string> names;
  for (const auto word : words)
  {
    std::string name(word);
    name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
    names.push_back(name);
  }
  return names;
}

Columns columnsNamed(const std::vector<std::string>& names)
{
  Columns columns;
  for (const auto& name : names) columns.add(name);
  return columns;
}

/** Reads lines one by one, until it knows what the columns are, and points from then on. */
class TextPoints
{
 public:
  TextPoints(BlockInput& input, const std::string& columns) : m_input(input)
  {
    if (columns.empty()) return;
    m_columns = columnsNamed(namesIn(columns));
    if (!m_columns->hasCoordinates())
      throw std::runtime_error("columns = " + params::printable(columns) +
                               " is not valid: it must name x, y and z");
    m_given = true;
  }

  void add(std::string_view line)
  {
    if (m_builder) return addPoint(line);
    if (const auto comment = commentOf(line))
      m_comment = namesIn(*comment);
    else
      addFirst(line);
  }

  PointCloud finished(const CloudReading& reading) &&
  {
    if (!m_builder) m_input.fail("holds no point");
    if (m_promised && *m_promised != m_builder->seen())
      m_input.fail("says to have " + params::counted(*m_promised, "point") + ", but has " +
                   std::to_string(m_builder->seen()));
    PointCloud cloud = std::move(*m_builder).finished(reading);
    cloud.format = std::string("text, separated by ") + (m_separator == ';'   ? "semicolons"
                                                         : m_separator == ',' ? "commas"
                                                                              : "blanks");
    cloud.otherFields = m_columns->others();
    return cloud;
  }

 private:
  /** A line that is the first point, or says what points are. */
  void addFirst(std::string_view line)
  {
    m_separator = separatorOf(line);
    splitLine(line, m_separator, m_words);
    std::size_t promised = 0;
    if (m_words.size() == 1 && !m_promised && params::readWhole(m_words[0], promised))
      m_promised = promised;
    else if (double number = 0; !m_hasHeader && !readNumber(m_words[0], number))
      takeHeader(line);
    else
      begin(line);
  }

  void takeHeader(std::string_view line)
  {
    m_hasHeader = true;
    if (m_given) return;
    m_columns = columnsNamed(namesIn(line));
    if (!m_columns->hasCoordinates())
      m_input.failLine("is neither a point nor names columns x, y and z");
  }

  void begin(std::string_view line)
  {
    if (!m_columns) m_columns = columnsOfFirst();
    if (m_given)
      while (m_columns->words() < m_words.size()) m_columns->add(kUnnamed);
    m_builder.emplace(m_input.name(), m_columns->fields());
    addPoint(line);
  }

  /** As the last comment says, if it names as many; else x, y and z, and others without a name. */
  Columns columnsOfFirst() const
  {
    Columns named = columnsNamed(m_comment);
    if (named.hasCoordinates() && named.words() == m_words.size()) return named;
    std::vector<std::string> names = {"x", "y", "z"};
    for (std::size_t i = names.size(); i < m_words.size(); ++i)
      names.push_back("column " + std::to_string(i + 1));
    return columnsNamed(names);
  }

  void addPoint(std::string_view line)
  {
    if (commentOf(line)) return;
    splitLine(line, m_separator, m_words);
    m_builder->add(textRow(*m_columns, m_words, m_input));
  }

  static constexpr const char* kUnnamed = "_";
  BlockInput& m_input;
  std::optional<Columns> m_columns;
  std::optional<CloudBuilder> m_builder;  //!< from the first point on
  std::optional<std::size_t> m_promised;  //!< points, as a line says
  std::vector<std::string> m_comment;     //!< the last one, as names
  Words m_words;
  char m_separator = ' ';
  bool m_given = false, m_hasHeader = false;
};

std::string_view withoutBlanks(std::string_view line)
{
  const auto first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t");
  return first == std::string_view::npos ? "" : line.substr(first, last - first + 1);
}
}  // namespace

PointCloud readText(BlockInput& input, const CloudReading& reading)
{
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // that editors put before a text
  TextPoints points(input, reading.columns);
  while (auto line = input.line())
  {
    if (input.lineNumber() == 1 && line->substr(0, kMark.size()) == kMark)
      line->remove_prefix(kMark.size());
    if (const auto text = withoutBlanks(*line); !text.empty()) points.add(text);
  }
  return std::move(points).finished(reading);
}

}  // namespace mrpt_mapconv::cloud
