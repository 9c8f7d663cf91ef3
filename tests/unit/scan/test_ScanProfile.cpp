// Slices, ranges, lines and profiles of section 1, worked out by hand.
#include "HandScan.h"

namespace
{
using namespace mrpt_mapconv;
using test::Drawing;
using test::HandScan;
using test::radians;

/** What a row of cells becomes, without the reflection filter. */
std::string wholeShape(const std::string& row)
{
  HandScan scan({row});
  scan.params.reflectionFilter = false;
  return scan.row();
}

std::string closestPoint(const std::string& row)
{
  HandScan scan({row});
  scan.params.model = scan::Model::ClosestPoint;
  scan.params.reflectionFilter = false;
  return scan.row();
}

TEST(ScanProfile, PapersFigure3TwoObjectsOnOneLine)
{
  EXPECT_EQ(wholeShape("S..o...oo..."), "...#...##???");
}

TEST(ScanProfile, ALineEndsWithItsLastObjectCell)
{
  EXPECT_EQ(wholeShape("S.o"), "..#");
  EXPECT_EQ(wholeShape("So...."), ".#????");
  EXPECT_EQ(wholeShape("..o.S..oo.."), "??#....##??") << "one line to each side";
}

TEST(ScanProfile, ALineWithoutObjectSaysNothing)
{
  EXPECT_EQ(wholeShape("S......"), "???????");
  HandScan scan({"S...w.."});
  EXPECT_EQ(scan.row(), "???????") << "a wall alone is no object";
}

TEST(ScanProfile, ClosestPointStopsAtTheNearestObjectCell)
{
  EXPECT_EQ(closestPoint("S..o...oo..."), "...#????????");
  EXPECT_EQ(closestPoint("S......"), "???????");
  HandScan scan({".o..", "....", "So.o"});
  scan.params.model = scan::Model::ClosestPoint;
  EXPECT_EQ(scan.profile(), (Drawing{"????", "????", ".#??"})) << "no line crosses (1, 2)";
}

TEST(ScanProfile, ObjectsInTheSensorsCell)
{
  HandScan scan({"S..o."});
  scan.params.minRange = 0;
  scan.object(0.75, 0.5);
  EXPECT_EQ(scan.row(), "#..#?");
  scan.params.model = scan::Model::ClosestPoint;
  EXPECT_EQ(scan.row(), "#????");
}

TEST(ScanProfile, SlicesHoldTheirEnds)
{
  const auto profile = [](double height)
  {
    HandScan scan({"S..."});
    scan.params.objectMinZ = 0.25;
    scan.params.objectMaxZ = 1.5;
    return scan.point(2.5, 0.5, height).row();
  };
  EXPECT_EQ(profile(0.25), "..#?");
  EXPECT_EQ(profile(1.5), "..#?");
  EXPECT_EQ(profile(0.249), "????");
  EXPECT_EQ(profile(1.501), "????");
}

TEST(ScanProfile, StructureSliceHoldsItsEnds)
{
  const auto isCut = [](double height)
  {
    HandScan scan({"S.....o"});
    scan.params.structureMinZ = 2.25;
    scan.params.structureMaxZ = 2.75;
    return scan.point(2.5, 0.5, height).row() == "???????";
  };
  EXPECT_TRUE(isCut(2.25));
  EXPECT_TRUE(isCut(2.75));
  EXPECT_FALSE(isCut(2.249));
  EXPECT_FALSE(isCut(2.751));
}

TEST(ScanProfile, HeightsAreThoseAboveTheBase)
{
  HandScan scan({"S..."});
  scan.view.baseZ = -2;
  scan.params.objectMinZ = 0.25;
  scan.params.objectMaxZ = 1.5;
  scan.sensor(0.5, 0.5, -1);
  scan.point(1.5, 0.5, -0.25);  // 1.75 m above the base
  scan.point(2.5, 0.5, -1.75);
  EXPECT_EQ(scan.row(), "..#?");
}

TEST(ScanProfile, PointsAreTurnedByTheSensorsPose)
{
  // looks to -y, tilted down by 30 degrees: 2 m ahead are 1.73 m, and 1 m down
  scan::Viewpoint view;
  view.sensorPose = mrpt::poses::CPose3D(0.5, 0.5, 1.25, radians(-90), radians(30), 0);
  scan::ProfileParams params;
  params.reflectionFilter = false;
  params.sectors = 4;
  scan::ScanProfile profile;
  profile.compute({{2, 0, 0}}, view, 1.0, params);
  EXPECT_TRUE(profile.occupied().containsKey(0, -2));
  EXPECT_EQ(profile.occupied().count(), 1u);
  EXPECT_TRUE(profile.free().containsKey(0, 0) && profile.free().containsKey(0, -1));
  EXPECT_EQ(profile.free().count(), 2u);
}

TEST(ScanProfile, RangesAreHorizontalAndHoldTheirEnds)
{
  HandScan scan({"S......"});
  scan.params.minRange = 2;
  scan.params.maxRange = 4;
  scan.object(2.25, 0.5).object(4.75, 0.5);
  EXPECT_EQ(scan.row(), "???????");
  scan.object(2.5, 0.5);
  EXPECT_EQ(scan.row(), "..#????");
  scan.point(4.5, 0.5, 0.25);  // 4 m away, 4.07 m along the beam
  EXPECT_EQ(scan.row(), "..#.#??");
}

TEST(ScanProfile, OnePointWithinTheRangesIsEnoughForACell)
{
  HandScan scan({"S......"});
  scan.params.minRange = 2.5;
  scan.params.maxRange = 4.25;
  scan.object(2.75, 0.5).object(3.0, 0.5);  // in cells 2 and 3
  scan.object(4.75, 0.5).object(4.95, 0.5);
  EXPECT_EQ(scan.row(), "...##??");
}

TEST(ScanProfile, CellsHoldTheirLowerBorders)
{
  HandScan scan({"S......"});
  scan.object(3.0, 0.5);
  EXPECT_EQ(scan.row(), "...#???");
}

TEST(ScanProfile, LinesWalkThroughCellsThatShareASide)
{
  // eight lines; the one to the north-east leaves each cell through its side x = k
  HandScan scan({"...o", "....", "....", "S..."});
  scan.params.sectors = 8;
  EXPECT_EQ(scan.sensor(0.5, 0.25).profile(), (Drawing{"???#",  //
                                                       "??..",  //
                                                       "?..?",  //
                                                       "..??"}));
  EXPECT_EQ(scan.sensor(0.25, 0.5).profile(), (Drawing{"??.#",  //
                                                       "?..?",  //
                                                       "..??",  //
                                                       ".???"}));
}

TEST(ScanProfile, FirstLinePointsAlongX)
{
  HandScan scan({"o...o", ".....", "..S..", ".....", "o...o"});
  scan.params.sectors = 1;
  scan.object(4.5, 2.5).object(0.5, 2.5).object(2.5, 4.5);
  EXPECT_EQ(scan.profile(), (Drawing{"#?#?#",  //
                                     "?????",  //
                                     "#?..#",  //
                                     "?????",  //
                                     "#???#"}));
}

TEST(ScanProfile, ALineThroughCornersFirstGoesAlongTheAxisClockwiseOfIt)
{
  HandScan scan({"o...o", ".....", "..S..", ".....", "o...o"});
  scan.params.sectors = 8;
  EXPECT_EQ(scan.profile(), (Drawing{"#.??#",  //
                                     "?....",  //
                                     "?...?",  //
                                     "....?",  //
                                     "#??.#"}));
}

TEST(ScanProfile, LinesAreEvenlySpaced)
{
  // at 0, 120 and 240 degrees
  HandScan scan({"o....", ".....", ".S..o", ".....", "o...."});
  scan.params.sectors = 3;
  scan.sensor(1.75, 2.5);
  // the line at 120 degrees is at x = 1 when y = 2.5 ± 1.3, and at x = 0.6 when y = 2.5 ± 2
  EXPECT_EQ(scan.profile(), (Drawing{"#????",  //
                                     "..???",  //
                                     "?...#",  //
                                     "..???",  //
                                     "#????"}));
}

TEST(ScanProfile, OCellsThatNoLineCrossesAreOccupiedAndFreeNothing)
{
  HandScan scan({"..o.", "...o", "S..o"});
  EXPECT_EQ(scan.profile(), (Drawing{"??#?",  //
                                     "???#",  //
                                     "...#"}));
}

TEST(ScanProfile, OneLineThatSaysFreeIsEnough)
{
  // only the line to the east has an object; the cells near the sensor are crossed by many others
  HandScan scan({"....", "S..o", "...."});
  scan.params.sectors = 360;
  EXPECT_EQ(scan.profile().at(1), "...#");
}

TEST(ScanProfile, DefaultLinesAreAtMostACellApartAtMaxRange)
{
  const auto lines = [](double maxRange, double resolution)
  {
    scan::ProfileParams params;
    params.reflectionFilter = false;
    params.minRange = 0.01;
    params.maxRange = maxRange;
    scan::Viewpoint view;
    view.sensorPose = mrpt::poses::CPose3D(0.03, 0.03, 1, 0, 0, 0);
    scan::ScanProfile profile;
    profile.compute({{0.02f, 0, 0}}, view, resolution, params);
    return profile.statistics().lines;
  };
  EXPECT_EQ(lines(20, 0.05), 2516) << "2 pi 400 = 2513.3";
  EXPECT_EQ(lines(5, 1), 32) << "2 pi 5 = 31.4";
  EXPECT_EQ(lines(5.1, 1), 36) << "2 pi 5.1 = 32.04";
  EXPECT_EQ(lines(0.3, 1), 4) << "2 pi 0.3 = 1.9";
}

TEST(ScanProfile, CountsWhatItFinds)
{
  HandScan scan({"..w....", "S..o..b"});
  scan.params.sectors = 4;
  scan.point(1.5, 0.5, 0).point(1.5, 0.5, 1.75);  // floor, and above the robot
  scan::ScanProfile profile = scan.compute();
  const scan::ProfileStatistics& found = profile.statistics();
  EXPECT_EQ(found.points, 6u);
  EXPECT_EQ(found.objectPoints, 2u);
  EXPECT_EQ(found.structurePoints, 2u);
  EXPECT_EQ(found.lines, 4);
  EXPECT_EQ(found.linesWithWall, 1);
  EXPECT_EQ(found.shareWithWall(), 0.25);
  EXPECT_EQ(found.occupiedCells, 2u);
  EXPECT_EQ(found.freeCells, 5u);
  scan.params.reflectionFilter = false;
  profile.compute(scan.points(), scan.view, 1.0, scan.params);
  EXPECT_EQ(profile.statistics().linesWithWall, 0);
  EXPECT_EQ(profile.statistics().shareWithWall(), 0);
}

TEST(ScanProfile, BoundsHoldAllCellsAndNoMore)
{
  HandScan scan({"..o....", "S..o..."});
  scan.sensor(0.5, 0.5);
  const scan::ScanProfile profile = scan.compute();
  EXPECT_TRUE(profile.bounds() == (grid::GridFrame{1.0, 0, 0, 4, 2}));
  const grid::GridFrame& frame = profile.occupied().frame();
  EXPECT_TRUE(frame == profile.free().frame());
  EXPECT_EQ(frame.width, frame.height);
  EXPECT_TRUE(frame.containsKey(0, 0) && frame.containsKey(3, 1));
}

TEST(ScanProfile, SaysNothingBeforeTheFirstScan)
{
  const scan::ScanProfile profile;
  EXPECT_TRUE(profile.bounds().empty());
  EXPECT_EQ(profile.occupied().count(), 0u);
  EXPECT_EQ(profile.free().count(), 0u);
  EXPECT_EQ(profile.statistics().lines, 0);
  EXPECT_EQ(profile.statistics().shareWithWall(), 0);
}

TEST(ScanProfile, CanBeMoved)
{
  scan::ScanProfile first = HandScan({"S..o"}).compute();
  scan::ScanProfile second = std::move(first);
  EXPECT_TRUE(second.occupied().containsKey(3, 0));
  scan::ScanProfile third;
  third = std::move(second);
  EXPECT_TRUE(third.occupied().containsKey(3, 0));
}

}  // namespace
