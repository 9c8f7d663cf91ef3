#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/UpperEdges.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;
using eval::upperEdges;

namespace
{
const float kNone = std::nanf("");
using Cells = std::vector<std::uint8_t>;

Layer<float> floors(std::int32_t width, std::vector<float> cells)
{
  const auto height = static_cast<std::int32_t>(cells.size()) / width;
  Layer<float> layer(GridFrame{0.1, -3, 7, width, height}, 0);
  layer.cells() = std::move(cells);
  return layer;
}

/** Pair by pair, as the definition says. */
Cells edgesPairByPair(const Layer<float>& floor, double drop)
{
  const auto& frame = floor.frame();
  Cells edges(frame.size(), 0);
  for (std::size_t i = 0; i < frame.size(); ++i)
    for (std::size_t j = 0; j < frame.size(); ++j)
    {
      const auto width = static_cast<std::size_t>(frame.width);
      const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
      if (apart(i % width, j % width) > 1 || apart(i / width, j / width) > 1) continue;
      if (floor.cells()[i] > floor.cells()[j] + drop) edges[i] = 1;
    }
  return edges;
}
}  // namespace

TEST(UpperEdges, LieBesideDropsOnTheirUpperSide)
{
  const auto edges = upperEdges(row({1.25f, 1.25f, 0, 0, 1.25f}), 0.3);
  EXPECT_EQ(edges.cells(), (Cells{0, 1, 0, 0, 1}));
  EXPECT_EQ(edges.frame(), row({0, 0, 0, 0, 0}).frame());
}

TEST(UpperEdges, OfACornerAreDiagonalToo)
{
  const auto edges = upperEdges(floors(3, {1, 1, 1, 1, 1, 1, 1, 1, 0}), 0.3);
  EXPECT_EQ(edges.cells(), (Cells{0, 0, 0, 0, 1, 1, 0, 1, 0}));
}

TEST(UpperEdges, NeedADropHigherThanTheGivenOne)
{
  // 1.25 - 0.95 is a hair more than 0.3 in single precision
  EXPECT_EQ(upperEdges(row({1.25f, 0.95f}), 0.3).cells(), (Cells{0, 0}));
  EXPECT_EQ(upperEdges(row({1.25f, 0.94f}), 0.3).cells(), (Cells{1, 0}));
  EXPECT_EQ(upperEdges(row({0.2f, 0.2f, 0.1f}), 0).cells(), (Cells{0, 1, 0}));
}

TEST(UpperEdges, StairsAndRampsHaveNone)
{
  EXPECT_EQ(upperEdges(row({0.54f, 0.36f, 0.18f, 0}), 0.3).cells(), (Cells{0, 0, 0, 0}));
}

TEST(UpperEdges, AreNotBesideWhatIsUnknown)
{
  EXPECT_EQ(upperEdges(row({1, kNone, 0, kNone}), 0.3).cells(), (Cells{0, 0, 0, 0}));
  EXPECT_EQ(upperEdges(row({kNone}), 0.3).cells(), (Cells{0}));
  EXPECT_TRUE(upperEdges(Layer<float>(), 0.3).cells().empty());
}

TEST(UpperEdges, HaveLowerOnesBesideThem)
{
  const auto floor = row({1.25f, 1.25f, 0, 0, kNone, 0, 0.3f});
  EXPECT_EQ(eval::lowerEdges(floor, 0.3).cells(), (Cells{0, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(eval::lowerEdges(floor, 0.2).cells(), (Cells{0, 0, 1, 0, 0, 1, 0}));
}

TEST(UpperEdges, OfRandomFloorsAreThoseOfTheDefinition)
{
  for (unsigned seed = 1; seed <= 50; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto width = static_cast<std::int32_t>(1 + random() % 7), height = 1 + width % 5;
    std::vector<float> cells(static_cast<std::size_t>(width * height));
    for (float& cell : cells)
      cell = random() % 5 == 0 ? kNone : 0.25f * static_cast<float>(random() % 5);
    const auto floor = floors(width, cells);
    EXPECT_EQ(upperEdges(floor, 0.6).cells(), edgesPairByPair(floor, 0.6));
  }
}

TEST(UpperEdges, RefuseADropThatIsNone)
{
  EXPECT_THROW(upperEdges(row({0}), -0.1), std::invalid_argument);
  EXPECT_THROW(upperEdges(row({0}), std::nan("")), std::invalid_argument);
}
