#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace mrpt_mapconv::testing
{
/** A point of a path [m]. */
struct Row
{
  double x, y, z;
};

/** Those of a CSV file that plan or lift wrote. */
inline std::vector<Row> rowsOf(const std::string& path)
{
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ("x,y,z", line);
  std::vector<Row> rows;
  while (std::getline(in, line))
  {
    Row row{};
    EXPECT_EQ(3, std::sscanf(line.c_str(), "%lf,%lf,%lf", &row.x, &row.y, &row.z)) << line;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace mrpt_mapconv::testing
