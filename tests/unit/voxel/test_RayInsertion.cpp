#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/RayInsertion.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{
using namespace mrpt_mapconv::voxel;

// log-odds of the default probabilities
constexpr float kMiss = -0.200670695f;  // ln(0.45 / 0.55)
constexpr float kHit = 2.19722458f;     // ln(0.9 / 0.1)

/** A ray of a grid of 1 m, along x in the voxels (·, 0, 0). */
Ray alongX(double from, double to, RayEnd atEnd = RayEnd::Hit)
{
  return {{from, 0.5, 0.5}, {to, 0.5, 0.5}, atEnd};
}

class RayInsertion : public ::testing::Test
{
 protected:
  InsertedRays insert(const std::vector<Ray>& rays) { return insertRays(grid, rays, params); }
  float at(std::int32_t x) const { return grid.logOdds({x, 0, 0}); }

  VoxelGrid grid{1.0};
  RayParams params;
};

TEST_F(RayInsertion, TheStartGetsAMissAndTheEndAHit)
{
  insert({alongX(0.5, 3.5)});
  EXPECT_FLOAT_EQ(kMiss, at(0));
  EXPECT_FLOAT_EQ(kMiss, at(1));
  EXPECT_FLOAT_EQ(kMiss, at(2));
  EXPECT_FLOAT_EQ(kHit, at(3));
  EXPECT_EQ(4u, grid.size());
}

TEST_F(RayInsertion, TheEndMayBeCleared)
{
  insert({alongX(0.5, 1.5, RayEnd::Clear)});
  EXPECT_FLOAT_EQ(kMiss, at(0));
  EXPECT_FLOAT_EQ(kMiss, at(1));
  EXPECT_EQ(2u, grid.size());
}

TEST_F(RayInsertion, TheEndMayBeKept)
{
  insert({alongX(0.5, 1.5, RayEnd::Keep)});
  EXPECT_FLOAT_EQ(kMiss, at(0));
  EXPECT_EQ(1u, grid.size());
  insert({alongX(1.5, 1.5), alongX(0.5, 1.5, RayEnd::Keep)});
  EXPECT_FLOAT_EQ(kHit, at(1));
}

TEST_F(RayInsertion, ARayWithinAVoxelOnlyTreatsItsEnd)
{
  insert({alongX(0.5, 0.5), alongX(1.5, 1.5, RayEnd::Clear), alongX(2.5, 2.5, RayEnd::Keep),
          alongX(3.25, 3.75)});
  EXPECT_FLOAT_EQ(kHit, at(0));
  EXPECT_FLOAT_EQ(kMiss, at(1));
  EXPECT_FALSE(isTouched(at(2)));
  EXPECT_FLOAT_EQ(kHit, at(3));
  EXPECT_EQ(3u, grid.size());
}

TEST_F(RayInsertion, LogOddsAreClampedAndNeverLocked)
{
  const Ray hit = alongX(0.5, 0.5), miss = alongX(0.5, 0.5, RayEnd::Clear);
  insert({hit, hit});
  EXPECT_EQ(3.511f, at(0));
  insert({hit, hit, hit, miss});
  EXPECT_FLOAT_EQ(3.511f + kMiss, at(0));
  insert(std::vector<Ray>(40, miss));
  EXPECT_EQ(-2.0f, at(0));
  insert({hit});
  EXPECT_FLOAT_EQ(-2.0f + kHit, at(0));
}

TEST_F(RayInsertion, RaysAreAppliedAsTheyAreNumbered)
{
  const auto hit = [](double x) { return alongX(x, x); };
  const auto miss = [](double x) { return alongX(x, x, RayEnd::Clear); };
  insert({hit(0.5), hit(0.5), miss(0.5), miss(1.5), hit(1.5), hit(1.5)});
  EXPECT_FLOAT_EQ(3.511f + kMiss, at(0));
  EXPECT_EQ(3.511f, at(1));
}

TEST_F(RayInsertion, SeveralRaysOfAScanUpdateAVoxelSeveralTimes)
{
  insert({alongX(0.5, 1.5), alongX(0.25, 2.5), alongX(0.75, 1.25)});
  EXPECT_FLOAT_EQ(3 * kMiss, at(0));
  EXPECT_FLOAT_EQ(kHit + kMiss + kHit > 3.511f ? 3.511f : 2 * kHit + kMiss, at(1));
}

TEST_F(RayInsertion, LongRaysAreCutAndEndInAMiss)
{
  params.maxRange = 2;
  insert({alongX(0.5, 9.5)});
  EXPECT_FLOAT_EQ(kMiss, at(0));
  EXPECT_FLOAT_EQ(kMiss, at(1));
  EXPECT_FLOAT_EQ(kMiss, at(2));
  EXPECT_EQ(3u, grid.size());
  grid.clear();
  insert({alongX(9.5, 0.5, RayEnd::Keep)});
  EXPECT_FLOAT_EQ(kMiss, at(9));
  EXPECT_FLOAT_EQ(kMiss, at(8));
  EXPECT_FLOAT_EQ(kMiss, at(7));
  EXPECT_EQ(3u, grid.size());
}

TEST_F(RayInsertion, ARayOfJustTheLargestRangeIsNotCut)
{
  params.maxRange = 2;
  insert({alongX(0.5, 2.5)});
  EXPECT_FLOAT_EQ(kHit, at(2));
}

TEST_F(RayInsertion, EndsAreSnappedToTheNearestOf256PartsOfAVoxel)
{
  insert({alongX(0.5, 2 - 0.4 / 256)});
  EXPECT_FLOAT_EQ(kHit, at(2));
  grid.clear();
  insert({alongX(0.5, 2 - 0.6 / 256)});
  EXPECT_FLOAT_EQ(kHit, at(1));
  EXPECT_FALSE(isTouched(at(2)));
}

TEST_F(RayInsertion, RaysThatAreNotFiniteAreSkippedAndCounted)
{
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const auto inserted = insert({alongX(nan, 1.5),
                                alongX(0.5, 1.5),
                                alongX(0.5, infinite),
                                {{0.5, 0.5, -infinite}, {0.5, 0.5, 0.5}},
                                {{0.5, 0.5, 0.5}, {0.5, nan, 0.5}}});
  EXPECT_EQ(1u, inserted.rays);
  EXPECT_EQ(4u, inserted.notFinite);
  EXPECT_EQ(2u, inserted.updates);
  EXPECT_EQ(2u, grid.size());
}

TEST_F(RayInsertion, AHitOfAHalfMakesAVoxelKnown)
{
  params.probHit = 0.5;
  insert({alongX(1.5, 1.5)});
  EXPECT_TRUE(isTouched(at(1)));
  EXPECT_EQ(0.0f, at(1));
  EXPECT_EQ(1u, grid.size());
}

TEST_F(RayInsertion, ALimitOfMinusZeroMakesVoxelsKnown)
{
  params.minLogOdds = -0.0;
  insert({alongX(0.5, 1.5, RayEnd::Clear)});
  EXPECT_EQ(2u, grid.size());
  grid.clear();
  params.minLogOdds = -1e-60;  // as a float −0
  insert({alongX(0.5, 1.5, RayEnd::Clear)});
  EXPECT_EQ(2u, grid.size());
  grid.clear();
  params = {};
  params.maxLogOdds = -0.0;
  insert({alongX(0.5, 1.5)});
  EXPECT_EQ(2u, grid.size());
}

TEST_F(RayInsertion, CountsUpdates)
{
  EXPECT_EQ(4u, insert({alongX(0.5, 3.5)}).updates);
  EXPECT_EQ(3u, insert({alongX(0.5, 3.5, RayEnd::Keep)}).updates);
  EXPECT_EQ(7u, insert({alongX(3.5, 0.5), alongX(0.5, 2.5, RayEnd::Clear)}).updates);
  EXPECT_EQ(0u, insert({}).updates);
}

TEST_F(RayInsertion, TellsTheColumnsOfTheBricksOnTheWay)
{
  const auto columns = insert({alongX(-1.5, 17.5)}).columns;
  EXPECT_EQ(3u * 16 * 16, columns.size());
  for (const std::int32_t x : {-16, 0, 15, 31})
  {
    EXPECT_TRUE(columns.contains(x, 0)) << x;
    EXPECT_TRUE(columns.contains(x, 15)) << x;
  }
  EXPECT_FALSE(columns.contains(-17, 0));
  EXPECT_FALSE(columns.contains(32, 0));
  EXPECT_FALSE(columns.contains(0, -1));
  EXPECT_FALSE(columns.contains(0, 16));
}

TEST_F(RayInsertion, NoRaysChangeNothing)
{
  const auto inserted = insert({});
  EXPECT_EQ(0u, inserted.rays);
  EXPECT_TRUE(inserted.columns.empty());
  EXPECT_EQ(0u, grid.heapBytes());
}

TEST_F(RayInsertion, ABrickThatBecomesAllTheSameIsKeptAsOneValue)
{
  std::vector<Ray> rays;
  for (int y = 0; y < 16; ++y)
    for (int z = 0; z < 16; ++z)
      rays.push_back({{0.5, y + 0.5, z + 0.5}, {15.5, y + 0.5, z + 0.5}, RayEnd::Clear});
  insert(rays);
  EXPECT_EQ(4096u, grid.size());
  EXPECT_EQ(VoxelGrid::Table::bytesOfRegion(), grid.heapBytes());
  insert({alongX(3.5, 3.5)});
  EXPECT_FLOAT_EQ(kMiss + kHit, at(3));
  EXPECT_FLOAT_EQ(kMiss, at(4));
}
}  // namespace
