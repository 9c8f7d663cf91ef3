// Maps with both engines against a plain octree that gets the same.
#include <gtest/gtest.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>

#include <cmath>
#include <limits>

#include "../oracle/BeamOracle.h"
#include "../support/KnownVoxels.h"
#include "RandomBeams.h"

namespace
{
using namespace mrpt_mapconv;
using namespace mrpt_mapconv::test;
using voxel::TVoxelInsertionOptions;
using voxel::VoxelMap;

/** A map, and an octree to which the same is done. */
class Twins
{
 public:
  explicit Twins(Rng& rng)
      : m_rng(rng), m_beams(rng), m_map(m_beams.resolution()), m_twin(m_beams.resolution())
  {
  }

  void change()
  {
    switch (pick(m_rng, 0, 11))
    {
      case 0:
        m_done += "clear ";
        m_map.clear();
        return m_twin.clear();
      case 1:
        return setOctree();
      case 2:
        return copy();
      case 3:
        return move();
      case 4:
        return stream();
      case 5:
        return setModel();
      case 6:
        m_done += "octree ";
        m_map.octree();
        return;
      case 7:
        return refuse();
      default:
        return insert();
    }
  }

  void expectSame() const
  {
    SCOPED_TRACE(m_beams.text() + ": " + m_done);
    // a copy, since asking for the octree makes it
    const VoxelMap copy(m_map);
    EXPECT_TRUE(sameVoxels(copy.octree(), m_twin));
    EXPECT_TRUE(copy.fullOctree() == m_map.fullOctree());
    EXPECT_TRUE(voxel::fullOctree(copy.octree()) == m_map.fullOctree());
    EXPECT_EQ(copy.octree().getResolution(), m_twin.getResolution());
    EXPECT_FLOAT_EQ(copy.octree().getOccupancyThresLog(), m_twin.getOccupancyThresLog());
    EXPECT_EQ(m_map.empty(), m_twin.size() == 0);
    const voxel::OctreeSource<octomap::OcTree> source(m_twin);
    EXPECT_EQ(m_map.hasFree(), voxel::hasFreeVoxel(source));
    EXPECT_EQ(voxel::knownVoxels(*m_map.source()), voxel::knownVoxels(source));
  }

 private:
  TVoxelInsertionOptions options()
  {
    auto options = finiteInsertion(m_rng, m_beams.resolution());
    options.voxelEngine =
        chance(m_rng, 50) ? voxel::VoxelEngine::Octomap : voxel::VoxelEngine::Blocks;
    return options;
  }
  void insert()
  {
    m_done += "insert ";
    const auto scan = m_beams.scan(pick(m_rng, 0, 150));
    auto used = options();
    if (chance(m_rng, 20)) used.maxMemory = 1;
    const auto bytes = m_map.fullOctree();
    try
    {
      m_map.insertScan(scan, used, nullptr, {}, pick(m_rng, 1, 3));
      oracle::insertScan(m_twin, scan, used);
    }
    catch (const std::runtime_error&)
    {
      m_done += "(not) ";
      EXPECT_TRUE(used.maxMemory);
      EXPECT_TRUE(bytes == m_map.fullOctree());
    }
  }
  /** A bad pose, or somebody who does not want the scan. */
  void refuse()
  {
    m_done += "refuse ";
    auto scan = m_beams.scan(20);
    const bool badPose = chance(m_rng, 50);
    if (badPose) scan.sensorPose.y(std::numeric_limits<double>::infinity());
    EXPECT_ANY_THROW(m_map.insertScan(scan, options(), nullptr,
                                      [](const grid::GridFrame&) { throw std::bad_alloc(); }));
  }
  void setOctree()
  {
    m_done += "setOctree ";
    if (chance(m_rng, 50)) m_twin.clear();
    addCubes(m_rng, m_beams.home(), m_twin);
    auto tree = std::make_unique<octomap::OcTree>(m_twin);
    const auto* address = tree.get();
    m_map.setOctree(std::move(tree));
    EXPECT_EQ(address, &m_map.octree());
  }
  void copy()
  {
    m_done += "copy ";
    VoxelMap copy(m_map);
    m_map.insertScan(m_beams.scan(10), options());
    if (chance(m_rng, 50))
      m_map = copy;
    else
      std::swap(m_map, copy);
  }
  void move()
  {
    m_done += "move ";
    VoxelMap moved(std::move(m_map));
    m_map = std::move(moved);
  }
  void stream()
  {
    m_done += "stream ";
    VoxelMap read(m_beams.resolution());
    if (chance(m_rng, 50)) read.insertScan(m_beams.scan(10), options());
    read.setModel(m_map.model());
    read.setFullOctree(m_map.fullOctree(), "stored", m_beams.resolution());
    m_map = std::move(read);
  }
  void setModel()
  {
    m_done += "setModel ";
    const auto model = options();
    m_map.setModel(model);
    model.applyTo(m_twin);
  }

  Rng& m_rng;
  RandomBeams m_beams;
  VoxelMap m_map;
  octomap::OcTree m_twin;
  std::string m_done;
};

TEST(VoxelMap, HoldsTheVoxelsOfATreeThatGetsTheSame)
{
  for (unsigned seed = 1; seed <= 80 && !HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    Twins twins(rng);
    for (int step = 0; step < 12 && !HasFailure(); ++step)
    {
      twins.change();
      twins.expectSame();
    }
  }
}

}  // namespace
