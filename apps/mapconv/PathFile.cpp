#include "PathFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "Json.h"

namespace mapconv
{
namespace
{
std::string trimmed(const std::string& text)
{
  const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  const auto begin = std::find_if_not(text.begin(), text.end(), isBlank);
  const auto end = std::find_if_not(text.rbegin(), text.rend(), isBlank).base();
  return begin < end ? std::string(begin, end) : std::string();
}

std::vector<std::string> fieldsOf(const std::string& line)
{
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1)
  {
    comma = line.find(',', begin);
    fields.push_back(trimmed(line.substr(begin, comma - begin)));
  }
  return fields;
}

std::optional<double> numberOf(const std::string& text)
{
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/** Which fields of a line are x and y. */
struct Columns
{
  std::size_t x = 0, y = 1;
};

/** The columns that a header names; nothing if the line is no header. */
std::optional<Columns> headerOf(const std::vector<std::string>& fields)
{
  const auto x = std::find(fields.begin(), fields.end(), "x");
  const auto y = std::find(fields.begin(), fields.end(), "y");
  if (x == fields.end() || y == fields.end()) return std::nullopt;
  return Columns{static_cast<std::size_t>(x - fields.begin()),
                 static_cast<std::size_t>(y - fields.begin())};
}
}  // namespace

std::vector<mrpt::math::TPoint2D> readPath2D(const std::string& file)
{
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error("cannot read '" + file +
                             "': " + std::generic_category().message(errno));
  std::vector<mrpt::math::TPoint2D> path;
  Columns columns;
  bool first = true;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number)
  {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    const auto fields = fieldsOf(line);
    const auto header = first ? headerOf(fields) : std::nullopt;
    first = false;
    if (header)
    {
      columns = *header;
      continue;
    }
    const auto at = [&](std::size_t i)
    { return i < fields.size() ? numberOf(fields[i]) : std::nullopt; };
    const auto x = at(columns.x), y = at(columns.y);
    if (!x || !y)
      throw std::runtime_error(file + ", line " + std::to_string(number) + ": '" +
                               line.substr(0, 80) +
                               "' must give x and y [m] as numbers between commas");
    path.emplace_back(*x, *y);
  }
  if (in.bad()) throw std::runtime_error("cannot read '" + file + "' to its end");
  if (path.empty()) throw std::runtime_error(file + ": it holds no point");
  return path;
}

std::string pathCsv(const mrpt_mapconv::path::LiftedPath& path)
{
  std::string text = "x,y,z\n";
  for (const auto& point : path.points)
    text += jsonNumber(point.position.x) + "," + jsonNumber(point.position.y) + "," +
            jsonNumber(point.position.z) + "\n";
  return text;
}

}  // namespace mapconv
