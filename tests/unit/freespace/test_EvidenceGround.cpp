// The ground layer by evidence: slopes and steps of supports, drop edges, frontiers.
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

/** At 0.1 m a step of 2 voxels (0.2 m), so that drop edges begin at more than 3. */
ConversionParams seen(double maxStep = 0.2)
{
  auto params = ConversionParams::paper();
  params.floorFrom = freespace::FloorFrom::Seen;
  params.minClearance = 0.1;
  params.maxSlope = 1000;
  params.maxStep = maxStep;
  params.maxGap = 6;
  params.maxHiddenGap = 0.2;
  return params;
}

void expectGround(const Plan& plan, const ConversionParams& params, const Plan& expected,
                  double resolution = 0.1)
{
  test::expectPlan(plan, resolution, params, &Layers::ground, 1, expected);
}
void expectRow(const std::string& row, const ConversionParams& params, const std::string& expected,
               double resolution = 0.1)
{
  expectGround(across(row), params, across(expected), resolution);
}

Layers layersOf(const Plan& plan, const ConversionParams& params)
{
  HandMap map(0.1);
  test::drawPlan(plan, 0, map);
  return map.convert(params);
}

// ---- slope

TEST(EvidenceGround, SlopesAreFittedOverSupports)
{
  ConversionParams params = seen(0);
  params.slopeWindow = 1;
  params.maxSlope = 0.6;
  // floors of open cells play no part: the supports rise by half a voxel per cell
  const Plan plan{". . . . . . .",     //
                  ". . . . . . .",     //
                  "s0 o1 s1 . . . .",  //
                  "s0 o2 s1 . . . .",  //
                  "s0 o1 s1 . . . .",  //
                  ". . . . . . .",     //
                  ". . . . . . ."};
  test::expectPlan(plan, 0.1, params, &Layers::slope, 1, across("0.5 0.5 0.5 . . . ."));
  expectGround(plan, params, across("0 0 0 . . . ."));
  params.maxSlope = 0.49;
  expectGround(plan, params, across("1 1 1 . . . ."));
}

TEST(EvidenceGround, CellsWithoutSupportHaveNoSlopeAndPlayNoPartInOthers)
{
  ConversionParams params = seen(0);
  params.slopeWindow = 1;
  const Plan plan{". . . . . . .",     //
                  ". . . . . . .",     //
                  "s0 s1 o9 . . . .",  //
                  "s0 s1 o9 . . . .",  //
                  "s0 s1 o9 . . . .",  //
                  ". . . . . . .",     //
                  ". . . . . . ."};
  test::expectPlan(plan, 0.1, params, &Layers::slope, 1, across("1 1 - - . . ."));
}

// ---- steps

TEST(EvidenceGround, StepsAreThoseOfSupports)
{
  // floors differ by 9, supports do not
  expectRow("s0 o9 s0 . . . .", seen(), "0 0 0 . . . .");
  // floors do not, supports do: 3 of the inferred cell and 0 beside it
  expectGround({". . . . . . .",    //
                ". . . . . . .",    //
                ". . s3 . . . .",   //
                ". s0 o1 . . . .",  //
                ". . s3 . . . .",   //
                ". . . . . . .",    //
                ". . . . . . ."},
               seen(), across(". 1 . . . . ."));
  expectRow("s0 s2 s4 s7 . . .", seen(), "0 0 1 1 . . .");
}

TEST(EvidenceGround, AnInferredCellMakesAStepByFractionsOfAVoxel)
{
  // inferred at 2 1/3 and 2 2/3, beside 0 and 0: more than 2, though no floor is
  const Plan plan{". . . . . . .",    //
                  ". . . s2 . . .",   //
                  ". . . o2 . . .",   //
                  ". . s0 o2 . . .",  //
                  ". . . s3 . . .",   //
                  ". . . . . . .",    //
                  ". . . . . . ."};
  expectGround(plan, seen(), across(". . 1 1 . . ."));
  // inferred at 2 exactly
  const Plan level{". . . . . . .",    //
                   ". . . . . . .",    //
                   ". . . s2 . . .",   //
                   ". . s0 o2 . . .",  //
                   ". . . s2 . . .",   //
                   ". . . . . . .",    //
                   ". . . . . . ."};
  expectGround(level, seen(), across(". . 0 0 . . ."));
}

TEST(EvidenceGround, StepsGoByDiagonalsToo)
{
  expectGround({". . . . . . .",   //
                ". . . . . . .",   //
                ". . s3 . . . .",  //
                ". . . s0 . . .",  //
                ". . . . . . .",   //
                ". . . . . . .",   //
                ". . . . . . ."},
               seen(), across(". . . 1 . . ."));
}

// ---- drop edges

TEST(EvidenceGround, AFloorDeeperThanAStepAndAVoxelMakesADropEdge)
{
  expectRow("s9 o6 . . . . .", seen(), "0 -1 . . . . .");
  expectRow("s9 o5 . . . . .", seen(), "1 -1 . . . . .");
  expectRow("s9 o6 . . . . .", seen(0.19), "1 -1 . . . . .");
  // higher ones make none
  expectRow("s0 o9 . . . . .", seen(), "0 -1 . . . . .");
}

TEST(EvidenceGround, ADropEdgeLooksOverOpenCellsWithoutSupport)
{
  expectRow("s9 o9 o8 o5 . . .", seen(), "1 -1 -1 -1 . . .");
  expectRow("s9 o9 . o5 . . .", seen(), "0 -1 . -1 . . .");
  expectRow("s9 o9 # o5 . . .", seen(), "0 -1 . -1 . . .");
  expectRow("s9 s9 o9 o5 . . .", seen(), "0 1 -1 -1 . . .");
  // not over those with support, although they are open, too
  expectRow("s9 o8 s9 o5 . . .", seen(), "0 0 1 -1 . . .");
}

TEST(EvidenceGround, TheFirstOtherCellCountsToo)
{
  expectRow("s9 o9 o9 s5 . . .", seen(), "1 -1 -1 0 . . .");
  expectRow("s9 o9 o9 s6 . . .", seen(), "0 -1 -1 0 . . .");
  // but not what is behind it
  expectRow("s9 o9 o9 s6 o0 . .", seen(), "0 -1 -1 1 -1 . .");
}

TEST(EvidenceGround, TheFirstOtherCellMayBeTheNeighbour)
{
  // inferred at 1 over a floor of -1, between two seen cells at 1: no step beside 3, but one might
  // come down to -1 there
  const auto plan = [](const std::string& middle)
  {
    return Plan{". . . . . . .",  ". . . . . . .", ". . . s1 . . .", ". . s3 " + middle + " . . .",
                ". . . s1 . . .", ". . . . . . .", ". . . . . . ."};
  };
  expectGround(plan("o-1"), seen(), across(". . 1 0 . . ."));
  expectGround(plan("o0"), seen(), across(". . 0 0 . . ."));
}

TEST(EvidenceGround, ADropEdgeLooksOneMetreFar)
{
  // 5 · 0.2 m is a metre, 6 · 0.2 m is more; a step is 0.4 m
  expectRow("s9 o9 o9 o9 o9 o5 .", seen(0.4), "1 -1 -1 -1 -1 -1 .", 0.2);
  expectRow("s9 o9 o9 o9 o9 o9 o5", seen(0.4), "0 -1 -1 -1 -1 -1 -1", 0.2);
  // 1/0.07 = 14.3 cells are beyond the plan, so one voxel of 1 m, and of more
  expectRow("s9 o5 . . . . .", seen(2), "1 -1 . . . . .", 1.0);
  expectRow("s9 o5 . . . . .", seen(2.2), "0 -1 . . . . .", 1.1);
}

TEST(EvidenceGround, OnADiagonalTheWayIsLonger)
{
  // at 0.25 m: 2 · 0.354 m and 3 · 0.354 m
  const auto plan = [](const std::string& second, const std::string& third)
  {
    return Plan{". . . . . . .",
                ". . . . . . .",
                ". . . . . . .",
                "s9 . . . . . .",
                ". o9 . . . . .",
                ". . " + second + " . . . .",
                ". . . " + third + " . . ."};
  };
  expectGround(plan("o5", "o9"), seen(0.5), across("1 . . . . . ."), 0.25);
  expectGround(plan("o9", "o5"), seen(0.5), across("0 . . . . . ."), 0.25);
  expectRow("s9 o9 o9 o9 o5 . .", seen(0.5), "1 -1 -1 -1 -1 . .", 0.25);
}

TEST(EvidenceGround, ADropIsMeasuredFromTheSupport)
{
  // the inferred cell in the middle: support 5, floor 4, beside a floor of 1
  expectGround({". . . . . . .",    //
                ". . . . . . .",    //
                ". . . s5 . . .",   //
                ". . . o4 o1 . .",  //
                ". . . s5 . . .",   //
                ". . . . . . .",    //
                ". . . . . . ."},
               seen(), across(". . . 1 -1 . ."));
}

TEST(EvidenceGround, WithoutMaxStepThereAreNeitherStepsNorDropEdges)
{
  expectRow("s9 o0 o0 . s9 s0 .", seen(0), "0 -1 -1 . 0 0 .");
}

// ---- frontiers and the rest

TEST(EvidenceGround, FrontiersAreUnknownForAGroundRobotAndCounted)
{
  const Plan plan = across("s0 o0 s0 o1 o2 # s2");
  const ConversionParams params = seen();
  expectGround(plan, params, across("0 0 0 -1 -1 1 0"));
  test::expectPlan(plan, 0.1, params, &Layers::aerial, 1, across("0 0 0 0 0 1 0"));
  const freespace::LayerStatistics counts = freespace::statistics(layersOf(plan, params));
  EXPECT_EQ(counts.frontier, 2u);
  EXPECT_EQ(counts.inferred, 1u);
  EXPECT_EQ(counts.free, 6u);
  EXPECT_EQ(counts.steep, 0u);
}

TEST(EvidenceGround, LowestFreeKnowsNoFrontiers)
{
  ConversionParams params = seen();
  params.floorFrom = freespace::FloorFrom::LowestFree;
  const Plan plan = across("s0 o0 s0 o3 o4 # s2");
  expectGround(plan, params, across("0 0 1 1 0 1 0"));
  const freespace::LayerStatistics counts = freespace::statistics(layersOf(plan, params));
  EXPECT_EQ(counts.frontier, 0u);
  EXPECT_EQ(counts.inferred, 0u);
}

}  // namespace
