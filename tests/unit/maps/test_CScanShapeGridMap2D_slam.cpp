#include <mrpt/maps/CMultiMetricMap.h>

#include <memory>

#include "ScanShapeFixtures.h"
#include "support/CountAllocations.h"

// What SLAM programs ask of the map: cheap insertions, independent copies, likelihoods, matching.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

TEST(CScanShapeGridMap2DInSlam, ASeriesOfScansNeedsNoMoreMemory)
{
  const Room room{-9, 9, -8, 8, 2.5};
  std::vector<CPose3D> robots;
  std::vector<mrpt::obs::CObservationPointCloud> scans;
  for (int i = 0; i < 6; ++i)
  {
    robots.emplace_back(0.3 * i, 0.2 * i, 0, 0.3 * i, 0, 0);
    scans.push_back(scanOf(room, robots.back()));
  }
  mrpt::obs::CObservationPointCloud empty;
  empty.sensorLabel = "a label that is longer than what a string holds by itself";
  auto map = mapForRooms();
  const auto insertAll = [&]
  {
    for (std::size_t i = 0; i < scans.size(); ++i)
      ASSERT_TRUE(map.insertObservation(scans[i], robots[i]));
  };
  EXPECT_GT(allocationsOf(insertAll), 0u) << "allocations are not counted";
  EXPECT_EQ(allocationsOf(insertAll), 0u);

  scans[1].pointcloud->insertPointFast(std::nanf(""), 1, 1);
  const auto insertOdd = [&]
  {
    ASSERT_TRUE(map.insertObservation(scans[1], robots[1]));
    ASSERT_FALSE(map.insertObservation(scans[2], CPose3D(std::nan(""), 0, 0)));
    ASSERT_FALSE(map.insertObservation(empty, robots[2]));
  };
  EXPECT_GT(allocationsOf(insertOdd), 0u) << "what is said first";
  EXPECT_EQ(allocationsOf(insertOdd), 0u);
}

TEST(CScanShapeGridMap2DInSlam, ACopyIsIndependentAndSmall)
{
  const Room room, larger{-9, 9, -8, 8, 2.5};
  auto map = mapOf(room);
  const auto before = bytes(map);
  CScanShapeGridMap2D copy(map), assigned = mapOf(larger, 0.7);
  assigned = map;
  EXPECT_EQ(copy.lastScan().points, 0u) << "the workspace was copied";
  EXPECT_EQ(assigned.lastScan().points, 0u) << "the scan was inserted into what it was before";
  EXPECT_GT(map.lastScan().points, 0u);
  map.insertObservation(scanOf(larger, CPose3D()), CPose3D());
  for (auto* other : {&copy, &assigned})
  {
    EXPECT_EQ(bytes(*other), before);
    other->insertObservation(scanOf(larger, CPose3D()), CPose3D());
    EXPECT_EQ(bytes(*other), bytes(map));
  }
  // MRPT's maps have some ten small blocks of their own, whatever they hold
  const auto plain = allocationsOf([&] { const mrpt::maps::COccupancyGridMap2D base(map); });
  EXPECT_LT(allocationsOf([&] { const CScanShapeGridMap2D another(map); }), plain + 10);
}

/** Resampling assigns maps to one another: that must not throw away what insertions work with. */
TEST(CScanShapeGridMap2DInSlam, AMapThatIsAssignedToKeepsItsBuffers)
{
  const Room room;
  const auto scan = scanOf(room, CPose3D());
  const auto source = mapOf(room);
  auto map = mapOf(room), fresh = mapOf(room);
  map = source;
  EXPECT_EQ(map.lastScan().points, 0u);
  const auto kept = allocationsOf([&] { map.insertObservation(scan, CPose3D()); });
  CScanShapeGridMap2D copy(source);
  const auto made = allocationsOf([&] { copy.insertObservation(scan, CPose3D()); });
  EXPECT_EQ(kept, 0u);
  EXPECT_GT(made, 10u);
  EXPECT_EQ(bytes(map), bytes(copy));
}

/** Each particle has a map of its own, and all are copied at every resampling. */
TEST(CScanShapeGridMap2DInSlam, WhatOneCopyHasSaidTheOthersDoNotRepeat)
{
  const Room room, high{-3, 3, -2, 2, 9};
  auto map = mapForRooms();
  map.scanInsertionOptions.profile.structureMinZ = 8.8;
  map.scanInsertionOptions.profile.structureMaxZ = 8.9;
  CScanShapeGridMap2D earlier(map), assigned = mapForRooms();
  assigned = map;
  std::size_t said = 0;
  std::vector<std::unique_ptr<WarningsOf>> warnings;
  const auto insertInto = [&](CScanShapeGridMap2D& each)
  {
    each.log().logging_enable_console_output = false;
    warnings.push_back(std::make_unique<WarningsOf>(each));
    ASSERT_TRUE(each.insertObservation(scanOf(high, CPose3D()), CPose3D()));
    ASSERT_FALSE(each.insertObservation(mrpt::obs::CObservationPointCloud(), CPose3D()));
    said += warnings.back()->texts.size();
  };
  insertInto(map);
  EXPECT_EQ(said, 2u);
  CScanShapeGridMap2D later(map);
  for (auto* copy : {&earlier, &assigned, &later}) insertInto(*copy);
  EXPECT_EQ(said, 2u);
  CScanShapeGridMap2D other;
  other.scanInsertionOptions = map.scanInsertionOptions;
  insertInto(other);
  EXPECT_EQ(said, 4u) << "another map has not said anything yet";
}

/** A callback may hold what does not live as long as a copy. */
TEST(CScanShapeGridMap2DInSlam, ACopyHasALoggerOfItsOwn)
{
  auto map = mapForRooms();
  const WarningsOf warnings(map);
  CScanShapeGridMap2D copy(map), assigned;
  const WarningsOf ofAssigned(assigned);
  assigned = map;
  EXPECT_TRUE(copy.log().logging_enable_console_output);
  for (auto* each : {&copy, &assigned})
  {
    each->log().logging_enable_console_output = false;
    each->log().logStr(mrpt::system::LVL_WARN, "a test");
  }
  EXPECT_TRUE(warnings.texts.empty());
  EXPECT_EQ(ofAssigned.texts.size(), 1u) << "a map that is assigned to keeps its own";
}

TEST(CScanShapeGridMap2DInSlam, AParticlesCopyIsTheSameMap)
{
  mrpt::maps::CMultiMetricMap particle;
  particle.maps.push_back(std::make_shared<CScanShapeGridMap2D>(mapOf(Room())));
  const mrpt::maps::CMultiMetricMap copy(particle);
  const auto original = particle.mapByClass<CScanShapeGridMap2D>();
  const auto copied = copy.mapByClass<CScanShapeGridMap2D>();
  ASSERT_TRUE(copied);
  ASSERT_NE(copied, original);
  EXPECT_EQ(bytes(*copied), bytes(*original));
}

TEST(CScanShapeGridMap2DInSlam, TheLikelihoodIsThatOfTheLastMapAndBestAtTheRightPlace)
{
  const Room room{-4, 5, -3, 3.5, 2.5};
  const CPose3D robot(0.5, 0.3, 0, 0.2, 0, 0);
  const auto scan = scan2DOf(room, robot);
  for (const bool cached : {true, false})
  {
    auto map = mapForRooms(0.05);
    map.setSize(-20, 20, -20, 20, 0.05f);  // so that it does not grow
    map.likelihoodOptions.enableLikelihoodCache = cached;
    map.computeObservationLikelihood(scan, robot);  // fills the cache from the empty map
    ASSERT_TRUE(map.insertObservation(scanOf(room, robot), robot));
    const double right = map.computeObservationLikelihood(scan, robot);
    for (const auto& wrong : {CPose3D(1, 0.3, 0, 0.2, 0, 0), CPose3D(0.5, -0.4, 0, 0.2, 0, 0),
                              CPose3D(0.5, 0.3, 0, 0.5, 0, 0)})
      EXPECT_GT(right, map.computeObservationLikelihood(scan, wrong)) << wrong << ' ' << cached;
  }
}

/** MRPT's mean-information likelihood inserts the scan that it asks for, in a map that is const. It
 * counts none of a 2D scan's rays, so that the result is -inf in its own grid as well. */
TEST(CScanShapeGridMap2DInSlam, AScanWhoseLikelihoodIsAskedForIsNotInserted)
{
  auto map = mapOf(Room());
  map.maxGridCells = 1e6;
  map.likelihoodOptions.likelihoodMethod = mrpt::maps::COccupancyGridMap2D::lmMeanInformation;
  mrpt::maps::COccupancyGridMap2D own(-20, 20, -20, 20, 0.1f);
  own.likelihoodOptions.likelihoodMethod = map.likelihoodOptions.likelihoodMethod;
  const auto before = bytes(map);
  const Room large{-9, 9, -9, 9, 2.5};
  map.computeObservationLikelihood(scanOf(large, CPose3D()), CPose3D());
  auto scan = scan2DOf(large, CPose3D());
  const double expected = own.computeObservationLikelihood(scan, CPose3D());
  EXPECT_EQ(map.computeObservationLikelihood(scan, CPose3D()), expected);
  scan.setScanRange(7, -HUGE_VALF);
  for (const double x : {0.0, 1e5, 1e12, std::nan("")})
    EXPECT_EQ(map.computeObservationLikelihood(scan, CPose3D(x, 0, 0)), expected) << x;
  EXPECT_EQ(bytes(map), before);
  EXPECT_FALSE(map.updateInfoChangeOnly.enabled);
}

TEST(CScanShapeGridMap2DInSlam, PointsAreMatchedWithItsWalls)
{
  const auto map = mapOf(Room());
  mrpt::maps::CSimplePointsMap points;
  for (int i = -15; i <= 15; ++i) points.insertPoint(3.1f, 0.1f * static_cast<float>(i), 0);
  mrpt::maps::TMatchingParams params;
  params.maxDistForCorrespondence = 0.3f;
  mrpt::tfest::TMatchingPairList pairs;
  mrpt::maps::TMatchingExtraResults extra;
  map.determineMatching2D(&points, CPose2D(), pairs, params, extra);
  EXPECT_GT(pairs.size(), 10u);
}
