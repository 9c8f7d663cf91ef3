#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/ScanShapeRegions.h>

#include "HandMadeScans.h"

namespace mrpt_mapconv
{
namespace
{
using namespace fixtures;

/** A region of the cells (10 … 14, 0), the last of which is occupied; its room begins with cell 8.
 */
struct Room
{
  explicit Room(double margin = 0) : maps(kFrame, {region()}, margin, {})
  {
    truth.regions = {layerWith<std::uint8_t>({10, 11, 12, 13, 14}, 1, 0)};
  }

  static eval::MapRegion region()
  {
    eval::MapRegion region;
    region.area = {1.0, 0.0, 1.5, 0.1};
    region.room = {0.8, -1, 2, 1};
    return region;
  }

  void addFrom(std::int32_t x)
  {
    const auto profileTo = [&](std::int32_t end) { return profileOf(scanFrom(x, {{end}})); };
    const auto real = profileTo(12), uncut = profileTo(20), cut = profileTo(9);
    maps.add(scanFrom(x, {}).view, {real, uncut, cut});
  }

  eval::OutsideScore judged() const { return maps.judged(truth).front(); }

  eval::ScanShapeTruth truth = truthWith({14});
  eval::OutsideMaps maps;
};
}  // namespace

TEST(ScanShapeRegions, EachMapIsJudgedByItself)
{
  Room room;
  room.addFrom(0);
  const eval::OutsideScore score = room.judged();
  EXPECT_EQ(1u, score.scans);
  EXPECT_NEAR(0.04, score.maps.cut.trueFreeArea, 1e-9);
  EXPECT_DOUBLE_EQ(0.5, score.maps.real.shareFound) << "cells 10 and 11";
  EXPECT_EQ(0u, score.maps.real.occupiedLabelledFree);
  EXPECT_DOUBLE_EQ(1, score.maps.uncut.shareFound);
  EXPECT_EQ(1u, score.maps.uncut.occupiedLabelledFree) << "cell 14";
  EXPECT_DOUBLE_EQ(0, score.maps.cut.shareFound);
}

TEST(ScanShapeRegions, ScansFromInsideTheRoomAreLeftOut)
{
  Room room;
  for (int i = 0; i < 3; ++i) room.addFrom(17);
  room.addFrom(8);  // in the doorway
  EXPECT_EQ(0u, room.judged().scans);
  EXPECT_DOUBLE_EQ(0, room.judged().maps.uncut.shareFound);
  room.addFrom(7);
  EXPECT_EQ(1u, room.judged().scans);
  EXPECT_DOUBLE_EQ(1, room.judged().maps.uncut.shareFound);
}

TEST(ScanShapeRegions, AMarginKeepsScansAwayFromTheRoom)
{
  Room room(0.4);  // from cell 4 on
  room.addFrom(7);
  room.addFrom(4);
  EXPECT_EQ(0u, room.judged().scans);
  room.addFrom(3);
  EXPECT_EQ(1u, room.judged().scans);
}

}  // namespace mrpt_mapconv
