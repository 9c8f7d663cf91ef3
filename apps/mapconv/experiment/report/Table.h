#pragma once

#include <string>
#include <vector>

namespace mapconv
{
/** A table of an experiment's report. */
struct Table
{
  std::string name;   //!< of its CSV file, without extension
  std::string title;  //!< a line above it
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::string note = {};  //!< a paragraph below it, or none

  /** \exception std::logic_error unless there is a cell for each column */
  void addRow(std::vector<std::string> cells);
};

/** As Markdown: title, table, note. */
std::string markdown(const Table& table);
/** Header and rows as comma-separated values. */
std::string csv(const Table& table);

/** A number with a fixed count of decimals; "-" for NaN and infinity. */
std::string fixed(double value, int decimals);
/** A share as a percentage with one decimal, "93.4 %". */
std::string percent(double share);
/** A target and whether it is met, "at most 30: met". */
std::string judged(const std::string& target, bool met);

}  // namespace mapconv
