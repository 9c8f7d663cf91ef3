#include "input/PathFile.h"

#include <mrpt_mapconv/files/ForeignKind.h>
#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "input/InputFile.h"

namespace mapconv
{
namespace files = mrpt_mapconv::files;
namespace params = mrpt_mapconv::params;

namespace
{
/** The fields of a line, without blanks and quotation marks around them. */
std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1)
  {
    comma = line.find(',', begin);
    std::string field = params::trimmed(line.substr(begin, comma - begin));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
      field = params::trimmed(field.substr(1, field.size() - 2));
    fields.push_back(field);
  }
  return fields;
}

/** A coordinate [m]; nothing for what is none. */
std::optional<double> coordinateOf(const std::string& text)
{
  constexpr double kFarthest = 1e8;  // [m]; the Earth's girth is 4e7
  std::string_view digits = text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  double value = 0;
  if (!params::readWhole(digits, value) || !(std::abs(value) <= kFarthest)) return std::nullopt;
  return value;
}

/** Which fields of a line are x and y, and how many fields a line has. */
struct Columns
{
  std::size_t x = 0, y = 1, count = 2;
};

/** The columns that a header names, in capitals or not; nothing if the line is no header. */
std::optional<Columns> headerOf(const std::vector<std::string>& fields)
{
  const auto find = [&](char lower, char upper)
  {
    const auto it =
        std::find_if(fields.begin(), fields.end(),
                     [&](const std::string& field)
                     { return field == std::string(1, lower) || field == std::string(1, upper); });
    return static_cast<std::size_t>(it - fields.begin());
  };
  const Columns columns{find('x', 'X'), find('y', 'Y'), fields.size()};
  if (columns.x == fields.size() || columns.y == fields.size()) return std::nullopt;
  return columns;
}

/** Reads the points of a path, line by line. */
class PathReader
{
 public:
  explicit PathReader(std::string file) : m_file(std::move(file)) {}

  void read(std::string line)
  {
    ++m_number;
    line = params::trimmed(m_number == 1 ? params::withoutByteOrderMark(line) : line);
    if (line.empty() || line.front() == '#') return;
    const auto fields = fieldsOf(line);
    if (!m_columns)
    {
      m_columns = headerOf(fields);
      if (m_columns) return;
      if (fields.size() == 1 && line.find_first_of(";\t ") != std::string::npos)
        fail(line, "must have commas between its fields");
      if (fields.size() != 2 && fields.size() != 3)
        fail(line, "must give x,y or x,y,z [m], or name the columns x and y");
      m_columns = Columns{0, 1, fields.size()};
    }
    if (fields.size() != m_columns->count)
      fail(line, "must have " + std::to_string(m_columns->count) + " fields between commas");
    const auto x = coordinateOf(fields[m_columns->x]), y = coordinateOf(fields[m_columns->y]);
    if (!x || !y) fail(line, "must give x and y [m] as numbers up to 1e8");
    m_path.emplace_back(*x, *y);
  }

  const std::vector<mrpt::math::TPoint2D>& path() const { return m_path; }

 private:
  [[noreturn]] void fail(const std::string& line, const std::string& right) const
  {
    throw std::runtime_error(m_file + ", line " + std::to_string(m_number) + ": '" +
                             params::printable(line, 80) + "' " + right);
  }

  std::string m_file;
  std::size_t m_number = 0;
  std::optional<Columns> m_columns;
  std::vector<mrpt::math::TPoint2D> m_path;
};
}  // namespace

std::vector<mrpt::math::TPoint2D> readPath2D(const std::string& file)
{
  auto stream = openInput(file);
  // by its first bytes alone: of the names that texts of points have, this is one
  const auto kind = files::foreignKindOf({"", stream.preview()});
  if (!kind.empty()) throw std::runtime_error(stream.name() + ": " + kind);
  constexpr std::size_t kMost = std::size_t(1) << 28U;
  std::istringstream in(stream.readUpTo(kMost));
  PathReader reader(stream.name());
  for (std::string line; std::getline(in, line);) reader.read(line);
  if (reader.path().empty()) throw std::runtime_error(stream.name() + ": it holds no point");
  return reader.path();
}

}  // namespace mapconv
