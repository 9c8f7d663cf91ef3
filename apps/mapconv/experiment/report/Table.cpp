#include "experiment/report/Table.h"

#include <mrpt/core/format.h>

#include <cmath>
#include <stdexcept>

namespace mapconv
{
namespace
{
std::string quoted(const std::string& cell)
{
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string text = "\"";
  for (const char c : cell) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

std::string csvLine(const std::vector<std::string>& cells)
{
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + quoted(cell);
  return line + "\n";
}

std::string markdownLine(const std::vector<std::string>& cells)
{
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}
}  // namespace

void Table::addRow(std::vector<std::string> cells)
{
  if (cells.size() != header.size())
    throw std::logic_error("table '" + name + "': a row has " + std::to_string(cells.size()) +
                           " cells instead of " + std::to_string(header.size()));
  rows.push_back(std::move(cells));
}

std::string markdown(const Table& table)
{
  std::string text = "### " + table.title + "\n\n" + markdownLine(table.header);
  text += markdownLine(std::vector<std::string>(table.header.size(), "---"));
  for (const auto& row : table.rows) text += markdownLine(row);
  return text + (table.note.empty() ? "" : "\n" + table.note + "\n");
}

std::string csv(const Table& table)
{
  std::string text = csvLine(table.header);
  for (const auto& row : table.rows) text += csvLine(row);
  return text;
}

std::string fixed(double value, int decimals)
{
  return std::isfinite(value) ? mrpt::format("%.*f", decimals, value) : "-";
}

std::string percent(double share)
{
  return std::isfinite(share) ? mrpt::format("%.1f %%", 100 * share) : "-";
}

std::string judged(const std::string& target, bool met)
{
  return target + (met ? ": met" : ": missed");
}

}  // namespace mapconv
