// Floors with evidence: what is known of the ground, and what is inferred, clause by clause.
#include <gtest/gtest.h>
#include <mrpt_mapconv/freespace/Conversion.h>

#include "EvidencePlan.h"

namespace
{
using namespace mrpt_mapconv;
using freespace::ConversionParams;
using freespace::Layers;
using test::across;
using test::HandMap;
using test::Plan;

/** At 0.1 m a step of 2 voxels (0.2 m); gaps in metres. */
ConversionParams seen(double maxGap, double maxHiddenGap, double maxStep = 0.2)
{
  auto params = ConversionParams::paper();
  params.floorFrom = freespace::FloorFrom::Seen;
  params.minClearance = 0.5;
  params.maxSlope = 1000;
  params.maxStep = maxStep;
  params.maxGap = maxGap;
  params.maxHiddenGap = maxHiddenGap;
  return params;
}

/** Supports in voxels; `-` is none. */
void expectSupport(const Plan& plan, const ConversionParams& params, const Plan& expected)
{
  test::expectPlan(plan, 0.1, params, &Layers::support, 0.1, expected);
}
void expectRow(const std::string& row, const ConversionParams& params, const std::string& expected)
{
  expectSupport(across(row), params, across(expected));
}

float evidenceOf(const std::string& column, const ConversionParams& params)
{
  HandMap map(0.1);
  map.occupied(1, 0, 0, 1).column(0, 0, 0, column);
  return map.convert(params).evidence.at(0, 0);
}

// ---- none, seen, open, wall

TEST(Evidence, IsWhatIsRightUnderTheLowestKeptRun)
{
  const ConversionParams params = seen(0.6, 0.2);  // a run needs five voxels
  EXPECT_EQ(evidenceOf("#fffff", params), 1) << "occupied";
  EXPECT_EQ(evidenceOf(".fffff", params), 3) << "unknown";
  EXPECT_EQ(evidenceOf("#.fffff", params), 3) << "unknown, though something is deeper";
  EXPECT_EQ(evidenceOf("fffff", params), 3) << "the map's lowest voxels";
  EXPECT_EQ(evidenceOf(".ffff#fffff", params), 1) << "the run underneath is too low to be kept";
  EXPECT_EQ(evidenceOf("#ffff.fffff", params), 3) << "the run underneath is too low to be kept";
  EXPECT_EQ(evidenceOf("#fffff.fffff", params), 1) << "the lowest kept run counts";
  EXPECT_EQ(evidenceOf(".fffff#fffff", params), 3) << "the lowest kept run counts";
  EXPECT_EQ(evidenceOf("#ffff", params), 4) << "no kept run";
  EXPECT_EQ(evidenceOf("....#", params), 4);
  EXPECT_EQ(evidenceOf(".ffff.", params), 0) << "no kept run, nothing occupied";
}

TEST(Evidence, InferredCellsHaveANumberOfTheirOwn)
{
  test::expectPlan(across("s0 o0 s0 # o0 . s0"), 0.1, seen(0.6, 0.2), &Layers::evidence, 1,
                   across("1 2 1 4 3 0 1"));
}

TEST(Evidence, SeenGroundIsSupport)
{
  expectRow("s0 s-3 . # s7 . s1", seen(0.6, 0.2), "0 -3 - - 7 - 1");
}

TEST(Evidence, TheFloorsLayerStaysAsItIs)
{
  const Plan plan = across("s0 o1 s0 o4 o5 # s2");
  ConversionParams params = seen(0.6, 0.2);
  test::expectPlan(plan, 0.1, params, &Layers::floor, 0.1, across("0 1 0 4 5 - 2"));
  params.floorFrom = freespace::FloorFrom::LowestFree;
  test::expectPlan(plan, 0.1, params, &Layers::floor, 0.1, across("0 1 0 4 5 - 2"));
  test::expectPlan(plan, 0.1, params, &Layers::support, 0.1, across("0 1 0 4 5 - 2"));
}

// ---- the line

TEST(Evidence, SupportIsOnTheStraightLine)
{
  expectRow("s0 o0 o1 o1 s2 . .", seen(0.6, 0.2), "0 0.5 1 1.5 2 - -");
  expectRow("s-2 o-2 o-2 o-2 s-4 . .", seen(0.6, 0.2), "-2 -2.5 -3 -3.5 -4 - -");
}

TEST(Evidence, AgainstSeenGroundOnOneSideOnlyNothingIsInferred)
{
  expectRow("s0 o0 o0 o0 . . .", seen(0.6, 0.2), "0 - - - . . .");
  expectRow("o0 o0 s0 o0 s0 o0 o0", seen(0.6, 0.2), "- - 0 0 0 - -");
}

TEST(Evidence, TheNearestSeenCellsAreTaken)
{
  // those behind them, too far from each other in height here, play no part
  expectRow("s9 s0 o0 o0 s0 s9 .", seen(0.6, 0.2), "9 0 0 0 0 9 -");
  // and nothing helps if the nearest do not do
  expectRow("s0 s9 o0 o0 s0 . .", seen(0.6, 0.2), "0 9 - - 0 - -");
}

TEST(Evidence, NoLineLeadsThroughAWall)
{
  expectRow("s0 o0 o0 # o0 o0 s0", seen(0.6, 0.2), "0 - - - - - 0");
  expectRow("s0 o0 o0 . o0 o0 s0", seen(0.6, 0.2), "0 0 0 - 0 0 0");
}

TEST(Evidence, LinesLeadAlongRowsColumnsAndDiagonals)
{
  // one diagonal here; plans are tried turned and mirrored, too
  expectSupport({"s0 . . . . . .",  //
                 ". o0 . . . . .",  //
                 ". . o0 . . . .",  //
                 ". . . o1 . . .",  //
                 ". . . . s2 . .",  //
                 ". . . . . . .",   //
                 ". . . . . . s9"},
                seen(0.6, 0.2),
                {"0 - - - - - -",    //
                 "- 0.5 - - - - -",  //
                 "- - 1 - - - -",    //
                 "- - - 1.5 - - -",  //
                 "- - - - 2 - -",    //
                 "- - - - - - -",    //
                 "- - - - - - 9"});
  // a knight's move away is on no axis
  expectSupport({". s0 . . . . .",  //
                 ". . . . . . .",   //
                 ". . o0 . . . .",  //
                 ". . . . . . .",   //
                 ". . . s0 . . .",  //
                 ". . . . . . .",   //
                 ". . . . . . ."},
                seen(0.6, 0.2), across(". . . . . . ."));
}

TEST(Evidence, AWallStopsADiagonalOnlyWhereItStands)
{
  // beside the diagonal a wall does not matter, on it it does
  expectSupport({"s0 # . . . . s0",  //
                 "# o0 # . . o0 .",  //
                 ". # s0 . # . .",   //
                 ". . . . . . .",    //
                 ". . # . s0 . .",   //
                 ". o0 . . . o0 .",  //
                 "s0 . . . . . s0"},
                seen(0.6, 0.2),
                {"0 - . . . . 0",  //
                 "- 0 - . . - .",  //
                 ". . 0 . - . .",  //
                 ". . . . . . .",  //
                 ". . - . 0 . .",  //
                 ". - . . . 0 .",  //
                 "0 . . . . . 0"});
}

// ---- (a) to (d)

TEST(Evidence, ATheTwoSupportsDifferByAtMostAStep)
{
  expectRow("s0 o0 s2 . . . .", seen(0.6, 0.2), "0 1 2 - - - -");
  expectRow("s0 o1 s3 . . . .", seen(0.6, 0.2), "0 - 3 - - - -");
  expectRow("s0 o1 s3 . . . .", seen(0.6, 0.2, 0.3), "0 1.5 3 - - - -");
  // 0.3/0.1 is a little less than 3 in double
  expectRow("s0 o1 s4 . . . .", seen(0.6, 0.2, 0.39), "0 - 4 - - - -");
}

TEST(Evidence, AWithoutMaxStepAStepIsTwentyCentimetresOrOneVoxel)
{
  expectRow("s0 o0 s2 . . . .", seen(0.6, 0.2, 0), "0 1 2 - - - -");
  expectRow("s0 o1 s3 . . . .", seen(0.6, 0.2, 0), "0 - 3 - - - -");
  for (const auto& [resolution, step] : {std::pair{0.05, 4}, {0.07, 2}, {0.2, 1}, {0.5, 1}})
  {
    const std::string high = "s" + std::to_string(step), higher = "s" + std::to_string(step + 1);
    const ConversionParams params = seen(6 * resolution, 2 * resolution, 0);
    test::expectPlan(across("s0 o2 " + high + " . " + higher + " o2 s0"), resolution, params,
                     &Layers::evidence, 1, across("1 2 1 0 1 3 1"));
  }
}

TEST(Evidence, BTheLineIsAtMostOneVoxelAboveTheFloor)
{
  // gaps of 2 cells, longer than maxHiddenGap
  const ConversionParams params = seen(0.6, 0.1);
  expectRow("s2 o2 s2 . s2 o1 s2", params, "2 2 2 - 2 2 2");
  expectRow("s2 o0 s2 . s2 o3 s2", params, "2 - 2 - 2 2 2");
  // a line at 1.5
  expectRow("s1 o1 s2 . s1 o0 s2", params, "1 1.5 2 - 1 - 2");
}

TEST(Evidence, BOrAStepWhereTheGapIsShort)
{
  const ConversionParams params = seen(0.6, 0.2);
  expectRow("s2 o1 s2 . s2 o0 s2", params, "2 2 2 - 2 2 2");
  expectRow("s3 o1 s3 . s3 o0 s3", params, "3 3 3 - 3 - 3");
  expectRow("s2 o1 o1 s2 . . .", params, "2 2 2 2 - - -");
  expectRow("s2 o0 o1 s2 . . .", params, "2 - 2 2 - - -");
}

TEST(Evidence, BButNeverLessThanOneVoxel)
{
  const ConversionParams params = seen(0.6, 0.2, 0.05);  // not a whole voxel
  expectRow("s2 o1 s2 . s2 o0 s2", params, "2 2 2 - 2 - 2");
  expectRow("s2 o2 s3 . . . .", params, "2 - 3 - - - -");
}

TEST(Evidence, CGapsAreNotLongerThanMaxGap)
{
  const ConversionParams params = seen(0.4, 0.2);
  expectRow("s0 o0 o0 o0 s0 . .", params, "0 0 0 0 0 - -");
  expectRow("s0 o0 o0 o0 o0 s0 .", params, "0 - - - - 0 -");
  expectRow("s0 o0 o0 o0 o0 s0 .", seen(0.5, 0.2), "0 0 0 0 0 0 -");
  // what is unknown between belongs to the gap
  expectRow("s0 . o0 . . s0 .", params, "0 - - - - 0 -");
}

TEST(Evidence, CWhereMoreThanAStepCouldHideTheyAreNotLongerThanMaxHiddenGap)
{
  const ConversionParams params = seen(0.6, 0.2);
  expectRow("s0 o2 o2 s0 . . .", params, "0 0 0 0 - - -");
  expectRow("s0 o3 o2 s0 . . .", params, "0 - 0 0 - - -");
  expectRow("s0 o9 s0 . s0 o9 .", params, "0 0 0 - 0 - -");
  expectRow("s0 o3 o9 s0 . . .", seen(0.6, 0.3), "0 0 0 0 - - -");
  // lines at 2/3 and 4/3: a floor of 3 is 2 1/3 and 1 2/3 above them
  expectRow("s0 o3 o3 s2 . . .", params, "0 - 1.328125 2 - - -");
}

TEST(Evidence, CADiagonalGapIsItsLength)
{
  const Plan plan{"s0 . . . . . .",  //
                  ". o9 . . . . .",  //
                  ". . s0 . . . .",  //
                  ". . . o0 . . .",  //
                  ". . . . o0 . .",  //
                  ". . . . . s0 .",  //
                  ". . . . . . ."};
  const auto expected = [](const std::string& hidden, const std::string& open)
  {
    return Plan{"0 . . . . . .",
                ". " + hidden + " . . . . .",
                ". . 0 . . . .",
                ". . . " + open + " . . .",
                ". . . . " + open + " . .",
                ". . . . . 0 .",
                ". . . . . . ."};
  };
  // 2·sqrt(2) = 2.828 cells, 3·sqrt(2) = 4.243
  expectSupport(plan, seen(0.42, 0.28), expected("-", "-"));
  expectSupport(plan, seen(0.43, 0.28), expected("-", "0"));
  expectSupport(plan, seen(0.42, 0.29), expected("0", "-"));
}

TEST(Evidence, DNoOpenCellBetweenIsMoreThanTwoVoxelsBelowTheLine)
{
  // the deep cell itself is more than a voxel below the line
  expectRow("s2 o2 o0 o2 s2 . .", seen(0.6, 0.2), "2 2 - 2 2 - -");
  expectRow("s2 o2 o-1 o2 s2 . .", seen(0.6, 0.2), "2 - - - 2 - -");
  expectRow("s2 o2 . o2 s2 . .", seen(0.6, 0.2), "2 2 - 2 2 - -");
  // the line counts where the deep cell is: 1.5 there, 0.5 and 1 at the others
  expectRow("s0 o0 o0 o0 s2 . .", seen(0.6, 0.2), "0 0.5 1 - 2 - -");
  expectRow("s0 o0 o0 o-1 s2 . .", seen(0.6, 0.2), "0 - - - 2 - -");
  expectRow("s0 o-1 o0 o1 s2 . .", seen(0.6, 0.2), "0 - 1 1.5 2 - -");
}

TEST(Evidence, DOrThanAStepWhereThatIsMore)
{
  expectRow("s4 o4 o1 o4 s4 . .", seen(0.6, 0.2, 0.3), "4 4 - 4 4 - -");
  expectRow("s4 o4 o0 o4 s4 . .", seen(0.6, 0.2, 0.3), "4 - - - 4 - -");
  // the cell itself is one of them: three voxels do for (b) and (d), four for neither
  expectRow("s3 o1 s3 . s3 o0 s3", seen(0.6, 0.2, 0.3), "3 3 3 - 3 3 3");
  expectRow("s3 o1 s3 . s3 o-1 s3", seen(0.6, 0.2, 0.3), "3 3 3 - 3 - 3");
}

// ---- which line

TEST(Evidence, TheSmallestGapWins)
{
  const Plan plan{". . . s0 . . .",    //
                  ". . . . . . .",     //
                  ". . . . . . .",     //
                  ". . s1 o1 s1 . .",  //
                  ". . . . . . .",     //
                  ". . . s0 . . .",    //
                  ". . . . . . ."};
  expectSupport(plan, seen(0.6, 0.2), across(". . 1 1 1 . ."));
  // unless it does not count
  Plan steep = plan;
  steep[3] = ". . s0 o0 s3 . .";
  expectSupport(steep, seen(0.6, 0.2), across(". . 0 0 3 . ."));
}

TEST(Evidence, AGapOfTwoDiagonalCellsIsLongerThanTwoAndShorterThanThree)
{
  const auto plan = [](const std::string& beside, const std::string& row)
  {
    return Plan{
        ". . . . . . .", ". . . . . . .", ". . s1 " + beside + " . . .", row, ". . . . s1 . .",
        ". . . . . . .", ". . . . . . ."};
  };
  expectSupport(plan(".", ". . s0 o1 s0 . ."), seen(0.6, 0.2), across(". . 0 0 0 . ."));
  expectSupport(plan(".", ". . s0 o1 . s0 ."), seen(0.6, 0.2), across(". . 0 1 . 0 ."));
}

TEST(Evidence, OfEqualGapsTheLowerLineWins)
{
  const Plan straight{". . . . . . .",     //
                      ". . . . . . .",     //
                      ". . . s2 . . .",    //
                      ". . s1 o1 s1 . .",  //
                      ". . . s1 . . .",    //
                      ". . . . . . .",     //
                      ". . . . . . ."};
  expectSupport(straight, seen(0.6, 0.2), across(". . 1 1 1 . ."));
  const Plan diagonal{". . . . . . .",    //
                      ". . . . . . .",    //
                      ". . s1 . s1 . .",  //
                      ". . . o1 . . .",   //
                      ". . s0 . s1 . .",  //
                      ". . . . . . .",    //
                      ". . . . . . ."};
  expectSupport(diagonal, seen(0.6, 0.2), across(". . . 0.5 . . ."));
}

// ---- rounding

TEST(Evidence, SupportIsRoundedToA64thOfAVoxel)
{
  // 64/3 = 21.33 and 128/3 = 42.67; 64/5 = 12.8, 25.6, 38.4, 51.2
  expectRow("s0 o0 o0 s1 . . .", seen(0.6, 0.2), "0 0.328125 0.671875 1 - - -");
  expectRow("s0 o0 o0 o0 o0 s1 .", seen(0.6, 0.2), "0 0.203125 0.40625 0.59375 0.796875 1 -");
  expectRow("s-1 o0 o0 s0 . . .", seen(0.6, 0.2), "-1 -0.671875 -0.328125 0 - - -");
}

/** Only gaps of 128 cells have halves of 64ths. */
TEST(Evidence, HalvesAreRoundedUp)
{
  for (const int begin : {0, -1, -9})
  {
    HandMap map(1.0);
    for (int kx = 0; kx <= 128; ++kx) map.free(kx, 0, begin, begin + 12);
    map.occupied(0, 0, begin - 1, begin).occupied(128, 0, begin, begin + 1);
    ConversionParams params = seen(128, 1, 1);
    const grid::Layer<float> support = map.convert(params).support;
    for (int kx = 0; kx <= 128; ++kx)
      EXPECT_EQ(support.at(kx, 0), static_cast<float>(begin + (kx + 1) / 2 / 64.0)) << kx;
  }
}

// ---- (e) what is known to be in the way

TEST(Evidence, ENothingHigherThanAStepStandsThere)
{
  expectRow("s0 o12/-3/-1 s0 . . . .", seen(0.6, 0.2), "0 0 0 - - - -");
  expectRow("s0 o12/0/2 s0 . . . .", seen(0.6, 0.2), "0 0 0 - - - -");
  expectRow("s0 o12/0/3 s0 . . . .", seen(0.6, 0.2), "0 - 0 - - - -");
  expectRow("s0 o12/0/3 s0 . . . .", seen(0.6, 0.2, 0.3), "0 0 0 - - - -");
  expectRow("s0 o12/10/11 s0 . . . .", seen(0.6, 0.2), "0 - 0 - - - -");
}

TEST(Evidence, EWhereStepsAreNotLookedForThatIsOneVoxel)
{
  expectRow("s0 o12/0/1 s0 . . . .", seen(0.6, 0.2, 0), "0 0 0 - - - -");
  expectRow("s0 o12/0/2 s0 . . . .", seen(0.6, 0.2, 0), "0 - 0 - - - -");
}

TEST(Evidence, EHeightsCountFromTheLine)
{
  expectRow("s0 o12/0/3 o12/0/3 s2 . . .", seen(0.6, 0.4), "0 - 1.328125 2 - - -");
}

TEST(Evidence, ENothingHangsLowerThanMinClearance)
{
  // a cell one voxel lower than the line, free for five or six voxels; five are needed
  expectRow("s0 o-1/4/5 s0 . . . .", seen(0.6, 0.2), "0 - 0 - - - -");
  expectRow("s0 o-1/5/6 s0 . . . .", seen(0.6, 0.2), "0 0 0 - - - -");
}

TEST(Evidence, EWhatIsOnOneCellIsNoWallForOthers)
{
  expectRow("s0 o0 o12/5/8 o0 s0 . .", seen(0.6, 0.4), "0 0 - 0 0 - -");
}

}  // namespace
