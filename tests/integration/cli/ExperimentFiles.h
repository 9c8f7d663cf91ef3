#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "Program.h"
#include "support/TempDir.h"

/** What tests of experiments read and write. */
namespace mrpt_mapconv::testing
{
inline const std::string kConfig = std::string(MRPT_MAPCONV_SOURCE_DIR) + "/config/";

/** Rows of a CSV file without quoted cells. */
inline std::vector<std::vector<std::string>> tableRows(const std::string& path)
{
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

using Row = std::vector<std::string>;

/** The first row that begins with some cells. */
inline Row rowWith(const std::vector<Row>& rows, const Row& begin)
{
  for (const Row& row : rows)
    if (row.size() >= begin.size() && std::equal(begin.begin(), begin.end(), row.begin()))
      return row;
  ADD_FAILURE() << "no row begins with " << begin.front();
  return {};
}

inline double number(const Row& row, std::size_t column) { return std::stod(row.at(column)); }

/** A file's only error, for which it must be refused. */
inline std::string experimentError(const TempDir& dir, const std::string& text)
{
  std::ofstream(dir.path("e.ini")) << text;
  const Outcome outcome = mapconv({"experiment", dir.path("e.ini"), "-o", dir.path("out")});
  EXPECT_EQ(1, outcome.status);
  EXPECT_TRUE(isOneError(outcome.err)) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "e.ini")) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(dir.path("out")));
  return outcome.err;
}

/** Text with the first `from` replaced, which must be there. */
inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const auto at = text.find(from);
  if (at == std::string::npos)
    ADD_FAILURE() << "no " << from;
  else
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace mrpt_mapconv::testing
