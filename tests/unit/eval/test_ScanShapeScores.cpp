#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/ScanShapeScores.h>

#include "HandMadeScans.h"

namespace mrpt_mapconv
{
using namespace fixtures;

TEST(ScanShapeScores, OccupiedIsJudgedOverAllCellsThatHaveIt)
{
  eval::ScanShapeTruth truth = truthWith({10, 11, 12});
  truth.should = layerWith<std::uint8_t>({8, 9, 10, 11}, 1, 0);
  truth.shouldBeOccupied = layerWith<std::uint8_t>({10, 11}, 1, 0);
  auto map = layerWith({10, 12, 15, 16, 17}, 1.0f, grid::kUnknown);  // 15 to 17 are ghosts
  map.cells()[kFrame.indexOfKey(8, 0)] = grid::kFree;
  map.cells()[kFrame.indexOfKey(11, 0)] = grid::kFree;
  const eval::MapScore score = eval::scoreOf(map, truth);
  EXPECT_DOUBLE_EQ(3.0 / 7, score.labels.precision());
  EXPECT_DOUBLE_EQ(2.0 / 4, score.labels.recall());
  EXPECT_DOUBLE_EQ(2.0 / 5, score.occupied.precision());
  EXPECT_DOUBLE_EQ(1.0 / 2, score.occupied.recall());
  EXPECT_EQ(1u, score.occupiedLabelledFree);
}

TEST(ScanShapeScores, APlaceIsWithinTheWorldAndHasAFreeCell)
{
  const eval::ScanShapeTruth truth = truthWith({10, 11});
  EXPECT_TRUE(eval::isPlaceIn({1.0, 0.0, 1.3, 0.1}, world(), truth));
  EXPECT_FALSE(eval::isPlaceIn({1.0, 0.0, 1.2, 0.1}, world(), truth)) << "both cells are occupied";
  EXPECT_FALSE(eval::isPlaceIn({1.0, 0.0, 51.0, 0.1}, world(), truth)) << "the world ends at 50 m";
  EXPECT_FALSE(eval::isPlaceIn({60.0, 60.0, 61.0, 61.0}, world(), truth));
  EXPECT_FALSE(eval::isPlaceIn({1.26, 0.0, 1.34, 0.04}, world(), truth))
      << "it holds no cell's centre";
}

}  // namespace mrpt_mapconv
