// Scans into bricks against OctoMap's own insertion: the same log-odds, to the bit.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OcTreeCopy.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>

#include "../oracle/BeamOracle.h"
#include "../support/KnownVoxels.h"
#include "RandomBeams.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;

/** The same scans in bricks, by as many threads, and in trees. */
struct Twins
{
  explicit Twins(double resolution)
      : one(resolution), two(resolution), three(resolution), tree(resolution), octomap(resolution)
  {
  }
  explicit Twins(const octomap::OcTree& from)
      : one(voxel::toVoxelGrid(from)), two(one), three(one), tree(from), octomap(from)
  {
  }

  void insert(const observation::SensorPoints& scan, const voxel::TVoxelInsertionOptions& options)
  {
    oracle::insertScan(octomap, scan, options);
    const auto changed = voxel::insertScan(tree, scan, options);
    EXPECT_TRUE(changed.blocks() == voxel::insertScan(one, scan, options, nullptr, 1).blocks());
    EXPECT_TRUE(changed.blocks() == voxel::insertScan(two, scan, options, nullptr, 2).blocks());
    EXPECT_TRUE(changed.blocks() == voxel::insertScan(three, scan, options, nullptr, 3).blocks());
  }
  void expectSame() const
  {
    const auto expected = knownVoxels(octomap);
    EXPECT_TRUE(sameVoxels(knownVoxels(tree), expected));
    EXPECT_TRUE(sameVoxels(knownVoxels(one), expected));
    EXPECT_TRUE(sameVoxels(knownVoxels(two), expected));
    EXPECT_TRUE(sameVoxels(knownVoxels(three), expected));
    EXPECT_EQ(expected.size(), one.size());
  }

  voxel::VoxelGrid one, two, three;
  octomap::OcTree tree, octomap;
};

/** Some scans, sometimes each with other options. */
void insertSome(Rng& rng, RandomBeams& beams, Twins& twins)
{
  auto options = randomInsertion(rng, twins.one.resolution());
  const bool sameModel = chance(rng, 50);
  for (int i = pick(rng, 1, 6); i > 0; --i)
  {
    if (!sameModel) options = randomInsertion(rng, twins.one.resolution());
    SCOPED_TRACE(text(options));
    // few beams are inserted by one thread, whatever was asked for
    twins.insert(beams.scan(chance(rng, 10) ? 3500 : pick(rng, 0, 300)), options);
    if (::testing::Test::HasFailure()) return;
  }
  twins.expectSame();
}

TEST(InsertedBeams, AreThoseOfOctoMap)
{
  for (unsigned seed = 1; seed <= 200 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    RandomBeams beams(rng);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + beams.text());
    Twins twins(beams.resolution());
    insertSome(rng, beams, twins);
  }
}

TEST(InsertedBeams, AreThoseOfOctoMapInTreesOfOtherSensors)
{
  for (unsigned seed = 1001; seed <= 1060 && !HasFailure(); ++seed)
  {
    Rng rng(seed);
    RandomBeams beams(rng);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + beams.text());
    octomap::OcTree tree(beams.resolution());
    addCubes(rng, beams.home(), tree);
    if (chance(rng, 50)) tree.setOccupancyThres(0.7);
    Twins twins(tree);
    twins.expectSame();
    insertSome(rng, beams, twins);
  }
}
}  // namespace
