#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/HandMap.h"

namespace mrpt_mapconv::test
{
/** A plan of cells, north up, each a word; words that stand for what is free begin at a height in
 * voxels: `s4` ground seen under free space from 4 on, `o4` the same with nothing known under it,
 * `o4/1/3` likewise but for occupied voxels [1, 3), `#` a wall from -3 to 25, `.` nothing. */
using Plan = std::vector<std::string>;
constexpr int kPlanSide = 7;

/** A plan with one row in the middle of nothing. */
inline Plan across(const std::string& row)
{
  const std::string none = ". . . . . . .";
  return {none, none, none, row, none, none, none};
}

inline std::vector<std::vector<std::string>> wordsOf(const Plan& plan)
{
  std::vector<std::vector<std::string>> rows;
  for (const std::string& text : plan)
  {
    std::istringstream in(text);
    rows.emplace_back();
    for (std::string word; in >> word;) rows.back().push_back(word);
    EXPECT_EQ(rows.back().size(), static_cast<std::size_t>(kPlanSide)) << text;
    rows.back().resize(kPlanSide, ".");
  }
  EXPECT_EQ(rows.size(), static_cast<std::size_t>(kPlanSide));
  rows.resize(kPlanSide, std::vector<std::string>(kPlanSide, "."));
  return rows;
}

/** Where a cell lies in one of the eight ways of turning and mirroring a plan. */
inline std::pair<int, int> turned(int which, int column, int row)
{
  if (which & 4) std::swap(column, row);
  return {which & 1 ? kPlanSide - 1 - column : column, which & 2 ? kPlanSide - 1 - row : row};
}

inline void drawPlan(const Plan& plan, int which, HandMap& map)
{
  const auto words = wordsOf(plan);
  for (int row = 0; row < kPlanSide; ++row)
    for (int column = 0; column < kPlanSide; ++column)
    {
      const std::string& word =
          words[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      const auto [kx, ky] = turned(which, column, kPlanSide - 1 - row);
      if (word == "#") map.occupied(kx, ky, -3, 25);
      if (word[0] != 's' && word[0] != 'o') continue;
      const int floor = std::stoi(word.substr(1));
      map.free(kx, ky, floor, floor + 12);
      if (word[0] == 's') map.occupied(kx, ky, floor - 1, floor);
      if (const auto first = word.find('/'); first != std::string::npos)
        map.occupied(kx, ky, std::stoi(word.substr(first + 1)),
                     std::stoi(word.substr(word.rfind('/') + 1)));
    }
}

/** Values of a layer against words: a number times `unit`, `-` for none (NaN), `.` for whatever;
 * in all eight ways. Cells beyond the frame have no value. */
inline void expectPlan(const Plan& plan, double resolution,
                       const freespace::ConversionParams& params,
                       grid::Layer<float> freespace::Layers::*member, double unit,
                       const Plan& expected)
{
  const auto words = wordsOf(expected);
  for (int which = 0; which < 8; ++which)
  {
    HandMap map(resolution);
    drawPlan(plan, which, map);
    const freespace::Layers layers = map.convert(params);
    for (int row = 0; row < kPlanSide; ++row)
      for (int column = 0; column < kPlanSide; ++column)
      {
        const std::string& word =
            words[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
        if (word == ".") continue;
        SCOPED_TRACE("row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1) +
                     ", turned " + std::to_string(which));
        const auto [kx, ky] = turned(which, column, kPlanSide - 1 - row);
        const grid::GridFrame& frame = layers.frame();
        const float value =
            frame.containsKey(kx, ky) ? (layers.*member).cells()[frame.indexOfKey(kx, ky)] : kNaN;
        if (word == "-")
          EXPECT_TRUE(std::isnan(value)) << value;
        else
          EXPECT_EQ(value, static_cast<float>(std::stod(word) * unit));
      }
  }
}

}  // namespace mrpt_mapconv::test
