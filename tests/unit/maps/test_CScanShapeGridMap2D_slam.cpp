#include <mrpt/maps/CMultiMetricMap.h>

#include "CountAllocations.h"
#include "ScanShapeFixtures.h"

// What SLAM programs ask of the map: cheap insertions, independent copies, likelihoods, matching.

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::maps::fixtures;
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
  auto map = mapForRooms();
  const auto insertAll = [&]
  {
    for (std::size_t i = 0; i < scans.size(); ++i)
      ASSERT_TRUE(map.insertObservation(scans[i], robots[i]));
  };
  EXPECT_GT(allocationsOf(insertAll), 0u) << "allocations are not counted";
  EXPECT_EQ(allocationsOf(insertAll), 0u);
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

/** MRPT's mean-information likelihood inserts the scan that it asks for, in a map that is const. */
TEST(CScanShapeGridMap2DInSlam, A3DScanWhoseLikelihoodIsAskedForIsNotInserted)
{
  auto map = mapOf(Room());
  map.likelihoodOptions.likelihoodMethod = mrpt::maps::COccupancyGridMap2D::lmMeanInformation;
  const auto before = map.getRawMap();
  map.computeObservationLikelihood(scanOf(Room{-9, 9, -9, 9, 2.5}, CPose3D()), CPose3D());
  EXPECT_EQ(map.getRawMap(), before);
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
