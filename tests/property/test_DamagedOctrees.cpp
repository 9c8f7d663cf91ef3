#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/OcTree.h>

#include <stdexcept>

#include "RandomMap.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;

/** The message of the error with which an action ends; empty without one. */
template <class Action>
std::string errorOf(const Action& action)
{
  try
  {
    action();
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

/** Damage that readOctree() finds, readVoxelGrid() finds, too, and calls it the same. */
TEST(DamagedOctrees, AreTheSameErrorsReadAsBricksAndAsATree)
{
  Rng rng(5);
  octomap::OcTree sample(0.1);
  for (int i = 0; i < 200; ++i)
    sample.setNodeValue(oracle::octomapKey(pick(rng, -40, 40), pick(rng, -40, 40), pick(rng, 0, 2)),
                        static_cast<float>(uniform(rng, -2, 3)));
  const auto whole = voxel::fullOctree(sample);
  const auto id = whole.find("OcTree\nsize");
  int damaged = 0, readable = 0;
  for (unsigned round = 0; round < 3000; ++round)
  {
    auto bytes = whole;
    if (chance(rng, 10)) bytes.resize(rng() % bytes.size());
    for (int hits = pick(rng, 1, 3); hits > 0 && !bytes.empty(); --hits)
    {
      const std::size_t at = rng() % bytes.size();
      if (at < id || at >= id + 6)
        bytes[at] = static_cast<char>(rng());  // its type is another matter
    }
    std::unique_ptr<octomap::AbstractOcTree> tree;
    std::optional<voxel::VoxelGrid> grid;
    const auto expected = errorOf([&] { tree = voxel::readOctree(bytes, "damaged"); });
    const auto message = errorOf([&] { grid = voxel::readVoxelGrid(bytes, "damaged", 100); });
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    if (!tree)
    {
      ++damaged;
      EXPECT_FALSE(grid);
      EXPECT_EQ(message, expected);
      continue;
    }
    if (!grid)  // a leaf that has become huge, or a voxel
    {
      EXPECT_TRUE(message.find("maxMemory") != std::string::npos ||
                  message.find("resolution") != std::string::npos)
          << message;
      continue;
    }
    ++readable;
    const auto& octree = dynamic_cast<const octomap::OcTree&>(*tree);
    for (auto leaf = octree.begin_leafs(); leaf != octree.end_leafs(); ++leaf)
    {
      const auto key = leaf.getIndexKey();
      ASSERT_EQ(grid->logOdds({key[0] - 32768, key[1] - 32768, key[2] - 32768}),
                leaf->getLogOdds());
    }
  }
  EXPECT_GT(damaged, 100);
  EXPECT_GT(readable, 100);
}

}  // namespace
