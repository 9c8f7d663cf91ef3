// Whatever scans are inserted into, the map is the same.
#include <mrpt/maps/CMultiMetricMap.h>

#include <random>

#include "FreeSpaceMapFixtures.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::fixtures;
using voxel::VoxelEngine;

namespace
{
/** Maps that get the same scans: by OctoMap, into blocks, and now by the one, now by the other. */
class Maps
{
 public:
  explicit Maps(unsigned seed) : m_random(seed)
  {
    freespace::TConversionOptions options;
    options.params.minClearance = 0.6;
    options.robot = pick(2) == 0 ? freespace::Robot::Ground : freespace::Robot::Aerial;
    const bool pruning = pick(3) != 0;
    for (auto* map : all())
    {
      map->setConversionOptions(options);
      map->voxelInsertionOptions.pruning = pruning;
    }
    m_octomap.voxelInsertionOptions.voxelEngine = VoxelEngine::Octomap;
    m_blocks.voxelInsertionOptions.voxelEngine = VoxelEngine::Blocks;
  }

  std::string change()
  {
    switch (pick(8))
    {
      case 0:
        for (auto* map : all()) map->clear();
        return "clear";
      case 1:
        for (auto* map : all()) streamed(*map);
        return "stream";
      case 2:
        for (auto* map : all()) copied(*map);
        return "copy";
      case 3:
        setThreshold();
        return "threshold";
      default:
        return insert();
    }
  }

  void expectSame()
  {
    for (auto* map : {&m_blocks, &m_mixed})
    {
      expectSameBits(m_octomap.layers(), map->layers());
      expectSameBits(m_octomap.exactLayers(), map->exactLayers());
      EXPECT_EQ(m_octomap.getRawMap(), map->getRawMap());
      EXPECT_EQ(m_octomap.isEmpty(), map->isEmpty());
      EXPECT_TRUE(m_octomap.voxelMap().fullOctree() == map->voxelMap().fullOctree());
      EXPECT_EQ(m_octomap.asString(), map->asString());
    }
  }
  void expectSameFiles()
  {
    const TempDir dir;
    m_octomap.saveMetricMapRepresentationToFile(dir.file("octomap"));
    m_blocks.saveMetricMapRepresentationToFile(dir.file("blocks"));
    EXPECT_TRUE(readBytes(dir.file("octomap.ot")) == readBytes(dir.file("blocks.ot")));
    // but for the option they are the same object
    for (auto* map : all())
    {
      map->voxelInsertionOptions.voxelEngine = VoxelEngine::Blocks;
      map->insertObservation(roomScan(1), mrpt::poses::CPose3D(1, 1, 1));
    }
    EXPECT_TRUE(bytes(m_octomap) == bytes(m_blocks));
    EXPECT_TRUE(bytes(m_octomap) == bytes(m_mixed));
  }

 private:
  std::array<CFreeSpaceGridMap2D*, 3> all() { return {&m_octomap, &m_blocks, &m_mixed}; }
  int pick(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }

  std::string insert()
  {
    m_mixed.voxelInsertionOptions.voxelEngine =
        pick(2) == 0 ? VoxelEngine::Octomap : VoxelEngine::Blocks;
    const auto scan = roomScan(pick(6));
    const mrpt::poses::CPose3D pose(0.7 * pick(5), 0.3 * pick(5), 1, 0.1 * pick(20), 0, 0);
    for (auto* map : all()) EXPECT_TRUE(map->insertObservation(scan, pose));
    return "insert";
  }
  void setThreshold()
  {
    const double threshold = 0.5 + 0.1 * pick(3);
    for (auto* map : all()) map->voxelInsertionOptions.occupancyThres = threshold;
  }
  /** As MRPT copies the maps of particles. */
  static void streamed(CFreeSpaceGridMap2D& map)
  {
    mrpt::maps::CMultiMetricMap all;
    all.maps.push_back(std::make_shared<CFreeSpaceGridMap2D>(map));
    const mrpt::maps::CMultiMetricMap copy(all);
    map = *copy.mapByClass<CFreeSpaceGridMap2D>();
  }
  static void copied(CFreeSpaceGridMap2D& map)
  {
    const CFreeSpaceGridMap2D copy(map);
    map.insertObservation(roomScan(5), mrpt::poses::CPose3D(9, 9, 1));
    map = copy;
  }

  std::mt19937 m_random;
  CFreeSpaceGridMap2D m_octomap{0.2}, m_blocks{0.2}, m_mixed{0.2};
};
}  // namespace

TEST(CFreeSpaceGridMap2D_engines, GiveTheSameLayersGridsAndFiles)
{
  for (unsigned seed = 1; seed <= 12 && !::testing::Test::HasFailure(); ++seed)
  {
    Maps maps(seed);
    std::string done;
    for (int step = 0; step < 10 && !::testing::Test::HasFailure(); ++step)
    {
      done += maps.change() + " ";
      SCOPED_TRACE("seed " + std::to_string(seed) + ": " + done);
      maps.expectSame();
    }
    maps.expectSameFiles();
  }
}

TEST(CFreeSpaceGridMap2D_engines, TheOctreeIsKeptUntilTheNextScan)
{
  CFreeSpaceGridMap2D map(0.2);
  map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1));
  const auto* tree = &map.octree();
  map.getRawMap();
  map.exactLayers();
  bytes(map);
  EXPECT_EQ(tree, &map.octree());
  const std::size_t nodes = tree->size();
  map.insertObservation(roomScan(3), mrpt::poses::CPose3D(2, 1, 1));
  EXPECT_GT(map.octree().size(), nodes);
}

TEST(CFreeSpaceGridMap2D_engines, AScanThatExceedsMaxMemoryIsRefusedAndTheMapStaysAsItWas)
{
  CFreeSpaceGridMap2D map(0.02);
  map.voxelInsertionOptions.maxMemory = 1;
  const auto before = bytes(map);
  const auto message =
      messageOf([&] { map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1)); });
  EXPECT_TRUE(contains(message, "maxMemory = 1 MB")) << message;
  EXPECT_TRUE(before == bytes(map));
  map.voxelInsertionOptions.maxMemory.reset();
  EXPECT_TRUE(map.insertObservation(roomScan(0), mrpt::poses::CPose3D(0, 0, 1)));
}
