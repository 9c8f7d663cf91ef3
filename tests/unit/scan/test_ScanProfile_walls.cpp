// The wall of a line and the structural cut of section 1, worked out by hand.
#include "HandScan.h"

namespace
{
using namespace mrpt_mapconv;
using test::Drawing;
using test::HandScan;
using test::radians;

/** What a row of cells becomes, with the default tolerance of one cell. */
std::string cut(const std::string& row) { return HandScan({row}).row(); }

std::string cut(const std::string& row, double tolerance)
{
  HandScan scan({row});
  scan.params.structureTolerance = tolerance;
  return scan.row();
}

TEST(ScanProfileWalls, PapersFigure4DataBeyondAWallIsCut)
{
  EXPECT_EQ(cut("S..o..b..o.o"), "...#..#?????");
  EXPECT_EQ(cut("S..o..w..o.o"), "...#????????") << "nothing hit below the structure";
}

TEST(ScanProfileWalls, NothingIsCutWithoutTheFilter)
{
  HandScan scan({"S..o..b..o.o"});
  scan.params.reflectionFilter = false;
  EXPECT_EQ(scan.row(), "...#..#..#.#");
  scan.params.structureMinZ = scan.params.structureMaxZ = scan::ProfileParams::kUnset;
  EXPECT_EQ(scan.row(), "...#..#..#.#");
}

TEST(ScanProfileWalls, AnAzimuthWithoutAWallIsNotCut)
{
  EXPECT_EQ(cut("o..o.S..b..o"), "#..#....#???") << "the wall is to the east only";
}

TEST(ScanProfileWalls, DefaultToleranceIsOneCell)
{
  EXPECT_EQ(cut("S..w...."), "????????");
  EXPECT_EQ(cut("S..wo..."), "...?#???") << "the wall's surface may be a cell behind its top";
  EXPECT_EQ(cut("S..w.o.."), "????????");
  EXPECT_EQ(cut("S..boo.."), "...##???");
}

TEST(ScanProfileWalls, ToleranceIsInMetresBetweenCentres)
{
  EXPECT_EQ(cut("S..booo.", 0), "...#????");
  EXPECT_EQ(cut("S..booo.", 0.99), "...#????");
  EXPECT_EQ(cut("S..booo.", 1), "...##???");
  EXPECT_EQ(cut("S..booo.", 2.5), "...###??");
  EXPECT_EQ(cut("S..wooo.", 0), "????????");
}

TEST(ScanProfileWalls, FreeIsWrittenOnlyBeforeTheWall)
{
  // the gap in the wall at 4 and what lies between valid cells behind the wall stay unknown
  EXPECT_EQ(cut("S..w.o.o", 4), "...??#?#");
  EXPECT_EQ(cut("S..b.o.o", 4), "...#?#?#");
}

TEST(ScanProfileWalls, NearestWallCounts)
{
  EXPECT_EQ(cut("S..w..b."), "????????");
  EXPECT_EQ(cut("S..b..b."), "...#????");
}

TEST(ScanProfileWalls, GhostBehindAPaneFreesNothingAtOrBeyondThePane)
{
  // a lintel above the pane at 4, no return from the pane itself, a ghost behind it
  EXPECT_EQ(cut("S...w..o."), "?????????");
  EXPECT_EQ(cut("S.o.w..o."), "..#??????");
  EXPECT_EQ(cut("S...wo..o"), "....?#???") << "at the pane's far side, within the tolerance";
}

TEST(ScanProfileWalls, GhostsBehindALongPane)
{
  // everything in the lower room is seen, nothing of what is mirrored into the upper one
  HandScan scan({".o...o.",  //
                 "...o...",  //
                 ".......",  //
                 "wwwwwww",  //
                 ".......",  //
                 "o..S..o"});
  scan.params.sectors = 720;
  const Drawing found = scan.profile();
  for (const int row : {0, 1, 2, 3})
    EXPECT_EQ(found.at(static_cast<std::size_t>(row)), "???????") << "row " << row;
  EXPECT_EQ(found.at(5), "#.....#");
  scan.params.reflectionFilter = false;
  EXPECT_EQ(scan.profile().at(1).at(3), '#');
  EXPECT_EQ(scan.profile().at(2).at(3), '.') << "the ghost opens a way through the pane";
}

TEST(ScanProfileWalls, NoLineSlipsDiagonallyThroughAWall)
{
  // the wall's cells meet at corners, and the line at 45 degrees goes through one of them; points
  // are where no azimuth gap reaches
  for (const double y : {0.5, 0.40625, 0.59375})
  {
    SCOPED_TRACE(y);
    HandScan scan({"....o",  //
                   ".....",  //
                   ".....",  //
                   ".....",  //
                   "....."});
    scan.params.sectors = 8;
    scan.params.structureGap = radians(0.5);
    scan.structure(3.75, 0.75).structure(2.75, 1.25).structure(1.25, 2.75).structure(0.25, 3.75);
    scan.sensor(0.5, y);
    EXPECT_EQ(scan.profile(), Drawing(5, "?????"));
    scan.params.reflectionFilter = false;
    EXPECT_EQ(scan.profile().at(0).at(4), '#');
  }
}

TEST(ScanProfileWalls, LinesMeetCornersAlongTheAxisTheyAreMoreAlong)
{
  // a line of its own leads from the middle of (0, 0) to that of (3, 1), through the corner (2, 1)
  const auto isCutBy = [](double x, double y)
  {
    HandScan scan({"....", "...o", "S..."});
    scan.params.structureGap = 0;
    scan.params.structureTolerance = 0;
    return scan.structure(x, y).profile().at(1) == "????";
  };
  EXPECT_TRUE(isCutBy(2.75, 0.25)) << "it goes on along x";
  EXPECT_FALSE(isCutBy(1.25, 1.75)) << "and not along y";
  // likewise to (1, 3), through the corner (1, 2)
  const auto isSteepCutBy = [](double x, double y)
  {
    HandScan scan({".o", "..", "..", "S."});
    scan.params.structureGap = 0;
    scan.params.structureTolerance = 0;
    return scan.structure(x, y).profile().at(0) == "??";
  };
  EXPECT_TRUE(isSteepCutBy(0.25, 2.75)) << "it goes on along y";
  EXPECT_FALSE(isSteepCutBy(1.75, 1.25)) << "and not along x";
}

/** Whether an object at 7 m to the east is cut by one structure point at an azimuth [degrees] and
 * a distance [m], on a line that does not cross the point's cell. */
bool isCutAt(double azimuth, double gap, double step = 0, double distance = 5)
{
  HandScan scan(
      {"........", "........", "........", "S......o", "........", "........", "........"});
  scan.params.structureGap = gap < 0 ? -1 : radians(gap);
  scan.view.azimuthStep = radians(step);
  scan.structure(0.5 + distance * std::cos(radians(azimuth)),
                 3.5 + distance * std::sin(radians(azimuth)));
  return scan.profile().at(3) == "????????";
}

TEST(ScanProfileWalls, StructurePointsWithinTheGapAreAWall)
{
  for (const double azimuth : {20.0, -20.0})
  {
    EXPECT_TRUE(isCutAt(azimuth, 20.1)) << azimuth;
    EXPECT_FALSE(isCutAt(azimuth, 19.9)) << azimuth;
  }
  EXPECT_FALSE(isCutAt(160, 20.1)) << "behind the sensor";
  EXPECT_TRUE(isCutAt(20, 20.1, 90)) << "a given gap does not depend on the sensor";
  EXPECT_FALSE(isCutAt(20, 19.9, 90));
}

TEST(ScanProfileWalls, WallInTheGapIsAsFarAsItsCell)
{
  // the point's cell is (5, 2) at a distance of √(25 + 4) = 5.39 m: cells up to 6.39 m stay
  HandScan scan({"........", "........", "S....ooo"});
  scan.params.structureGap = radians(30);
  scan.structure(5.75, 2.25);
  EXPECT_EQ(scan.profile().at(2), ".....##?");
  scan.params.structureTolerance = 0;
  EXPECT_EQ(scan.profile().at(2), ".....#??");
}

TEST(ScanProfileWalls, AzimuthsAreThoseOfPointsNotOfCells)
{
  // within the cell (4, 1), whose middle is at 14 degrees
  HandScan scan({"........", "S......o"});
  scan.params.structureGap = radians(8);
  EXPECT_EQ(HandScan(scan).structure(4.5, 1.0).profile().at(1), "????????") << "7.1 degrees";
  EXPECT_EQ(HandScan(scan).structure(4.5, 1.25).profile().at(1), ".......#") << "10.6 degrees";
}

TEST(ScanProfileWalls, AzimuthsAreComparedAroundTheCircle)
{
  for (const double y : {0.9375, 0.0625})
  {
    // the line to the west is at 180 degrees, points are at ±178.4 degrees in rows above and below
    HandScan scan({"........", "o......S", "........"});
    scan.params.structureGap = radians(8);
    scan.sensor(7.5, 1 + y).structure(2.5, y > 0.5 ? 2.0625 : 0.9375);
    EXPECT_EQ(scan.profile().at(1), "????????") << y;
    scan.params.structureGap = radians(1);
    EXPECT_EQ(scan.profile().at(1), "#.......") << y;
  }
}

TEST(ScanProfileWalls, DefaultGapIsHalfTheAzimuthStepButAtLeastHalfADegree)
{
  /** A structure point 10 m to the east, in the next row, at an azimuth [degrees]. */
  const auto isCut = [](double azimuth, double azimuthStep)
  {
    HandScan scan({"................", "S..............o"});
    scan.view.azimuthStep = radians(azimuthStep);
    scan.sensor(0.5, 0.96875).structure(10.5, 0.96875 + 10 * std::tan(radians(azimuth)));
    return scan.profile().at(1) == "????????????????";
  };
  EXPECT_TRUE(isCut(0.49, 0)) << "step not known";
  EXPECT_FALSE(isCut(0.51, 0));
  EXPECT_TRUE(isCut(0.49, 0.35));
  EXPECT_FALSE(isCut(0.51, 0.35));
  EXPECT_TRUE(isCut(0.99, 2));
  EXPECT_FALSE(isCut(1.01, 2));
}

TEST(ScanProfileWalls, StructureRightAboveTheSensorHasNoAzimuth)
{
  // its cell, the sensor's own, is crossed by every line
  HandScan scan({"S.o."});
  EXPECT_EQ(scan.structure(0.5, 0.5).row(), "????");
  scan.params.structureTolerance = 2;
  EXPECT_EQ(scan.row(), "??#?");
  EXPECT_EQ(scan.compute().statistics().linesWithWall, 4);
}

TEST(ScanProfileWalls, StructureHasNoLeastRange)
{
  HandScan scan({"S.w..o"});
  scan.params.minRange = 4;
  EXPECT_EQ(scan.row(), "??????");
}

TEST(ScanProfileWalls, StructureHasNoGreatestRange)
{
  // the structure point is 4.71 m away, beyond maxRange, but the middle of its cell only 4.12 m,
  // that of the object's cell 5 m
  HandScan scan({"......", "S....."});
  scan.params.maxRange = 4.6;
  scan.params.structureGap = radians(19);
  scan.params.structureTolerance = 0.5;
  scan.object(5.03125, 0.5);
  EXPECT_EQ(scan.profile().at(1), ".....#");
  scan.structure(4.96875, 1.96875);
  EXPECT_EQ(scan.compute().statistics().linesWithWall, 1);
  EXPECT_EQ(scan.profile().at(1), "??????");
}

TEST(ScanProfileWalls, OCellValidOnOneLineStaysThoughCutOnAnother)
{
  // lines at 18 degrees and more have their wall at (2, 1), those at 7 … 11 degrees pass by it
  HandScan scan({".....", "..w.o", "S...."});
  scan.params.sectors = 20;
  EXPECT_EQ(scan.profile().at(1), "?????");
  scan.params.sectors = 360;
  EXPECT_EQ(scan.profile().at(1).at(4), '#');
}

TEST(ScanProfileWalls, OCellsThatNoLineCrossesAreCutByTheWallBeforeThem)
{
  EXPECT_EQ(HandScan({"...o", "....", "..o.", "S..."}).profile().at(0), "???#");
  EXPECT_EQ(HandScan({"....o", ".....", ".....", "...b.", "....w", "S...."}).profile(),
            (Drawing{"????#", "?????", "?????", "???#?", "?????", "?????"}))
      << "on another azimuth: the line to the object leaves row 2 at x = 2.5";
  EXPECT_EQ(HandScan({"....o", "...o.", "..b..", "S...."}).profile().at(0), "?????");
  // a wall that the cell's own line does not cross, but whose point is near it
  HandScan scan({".....", "...o.", ".....", "S...."});
  scan.structure(1.25, 2.125);
  EXPECT_EQ(scan.profile().at(1), "???#?") << "the point is at 65 degrees, the cell at 34";
  scan.params.structureGap = radians(32);
  EXPECT_EQ(scan.profile().at(1), "?????");
}

TEST(ScanProfileWalls, ClosestPointIsCutLikewise)
{
  const auto closest = [](const std::string& row, double tolerance)
  {
    HandScan scan({row});
    scan.params.model = scan::Model::ClosestPoint;
    scan.params.structureTolerance = tolerance;
    return scan.row();
  };
  EXPECT_EQ(closest("S..o..b..o", 1), "...#??????");
  EXPECT_EQ(closest("S.....b..o", 1), "......#???");
  EXPECT_EQ(closest("S.....w..o", 1), "??????????");
  EXPECT_EQ(closest("S..w.o..o.", 3), "...??#????");
}

TEST(ScanProfileWalls, ShareOfLinesWithAWall)
{
  HandScan scan({"..w..", ".....", "w.S.b", ".....", "....."});
  const scan::ScanProfile profile = scan.compute();
  EXPECT_EQ(profile.statistics().lines, 4);
  EXPECT_EQ(profile.statistics().linesWithWall, 3);
  EXPECT_EQ(profile.statistics().shareWithWall(), 0.75);
}

TEST(ScanProfileWalls, WallsBehindObjectsCountInTheShareWhateverTheModel)
{
  // the line to the north-east crosses the wall's cell far from the azimuth of the wall's point
  HandScan scan({".....", ".....", ".....", ".....", "S...."});
  scan.params.sectors = 8;
  scan.sensor(0.5, 0.4375).object(2.5, 2.5).structure(4.9375, 4.0625);
  EXPECT_EQ(scan.compute().statistics().linesWithWall, 1);
  scan.params.model = scan::Model::ClosestPoint;
  EXPECT_EQ(scan.compute().statistics().linesWithWall, 1);
}

}  // namespace
