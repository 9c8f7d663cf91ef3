#include <gtest/gtest.h>
#include <mrpt_mapconv/sim/SampleMaps.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <vector>

namespace
{
using mrpt_mapconv::sim::buildingMap;
using mrpt_mapconv::sim::outdoorMap;
using mrpt_mapconv::sim::OutdoorOptions;

/** '.' unknown, ' ' free, '#' occupied. */
char stateOf(const octomap::OcTree& tree, const octomap::OcTreeNode* node)
{
  if (!node) return '.';
  return tree.isNodeOccupied(node) ? '#' : ' ';
}
char stateAt(const octomap::OcTree& tree, double x, double y, double z)
{
  return stateOf(tree, tree.search(x, y, z));
}

/** The states along z as runs, each named once, from the lowest known voxel to the highest. */
std::string runsAt(const octomap::OcTree& tree, double x, double y)
{
  std::string runs;
  const double res = tree.getResolution();
  for (int k = -10; k < 200; ++k)
  {
    const char state = stateAt(tree, x, y, (k + 0.5) * res);
    if (runs.empty() ? state != '.' : state != runs.back()) runs += state;
  }
  if (!runs.empty() && runs.back() == '.') runs.pop_back();
  return runs;
}

std::string written(const octomap::OcTree& tree)
{
  std::ostringstream out;
  tree.writeBinaryConst(out);
  return out.str();
}

std::size_t countLeaves(const octomap::OcTree& tree, bool occupied)
{
  std::size_t count = 0;
  for (auto it = tree.begin_leafs(); it != tree.end_leafs(); ++it)
    count += tree.isNodeOccupied(*it) == occupied;
  return count;
}

/** As OctoMap would have read it from a `.bt` file: pruned, with clamped values. */
void expectAsReadFromFile(octomap::OcTree& tree)
{
  octomap::OcTree again(1.0);
  std::stringstream file(written(tree));
  ASSERT_TRUE(again.readBinary(file));
  EXPECT_EQ(again.size(), tree.size());
  EXPECT_EQ(again.getResolution(), tree.getResolution());
  auto a = tree.begin_tree();
  for (auto b = again.begin_tree(); b != again.end_tree(); ++a, ++b)
  {
    ASSERT_TRUE(a != tree.end_tree());
    ASSERT_TRUE(a.getKey() == b.getKey());
    ASSERT_EQ(a.getDepth(), b.getDepth());
    ASSERT_EQ(a->getLogOdds(), b->getLogOdds());
  }
  const std::size_t nodes = tree.size();
  tree.prune();
  EXPECT_EQ(tree.size(), nodes);
}

TEST(BuildingMap, HasItsSize)
{
  const auto tree = buildingMap();
  EXPECT_EQ(tree->getResolution(), 0.05);
  double min[3], max[3];
  tree->getMetricMin(min[0], min[1], min[2]);
  tree->getMetricMax(max[0], max[1], max[2]);
  EXPECT_NEAR(max[0] - min[0], 12.0, 0.3);
  EXPECT_NEAR(max[1] - min[1], 8.0, 0.3);
  EXPECT_NEAR(min[2], -0.05, 1e-6);
  EXPECT_NEAR(max[2], 2.65, 1e-6);
}

TEST(BuildingMap, HasItsParts)
{
  const auto tree = buildingMap();
  const auto at = [&tree](double x, double y, double z) { return stateAt(*tree, x, y, z); };
  // the open floor of both rooms, under the ceiling
  EXPECT_EQ(runsAt(*tree, -2.02, -1.02), "# #");
  EXPECT_EQ(runsAt(*tree, 4.02, 0.02), "# #");
  EXPECT_EQ(at(-2.02, -1.02, -0.02), '#');
  EXPECT_EQ(at(-2.02, -1.02, 0.02), ' ');
  EXPECT_EQ(at(-2.02, -1.02, 2.58), ' ');
  EXPECT_EQ(at(-2.02, -1.02, 2.62), '#');
  // the table: free under and above its top
  EXPECT_EQ(runsAt(*tree, -0.62, 0.02), "# # #");
  EXPECT_EQ(at(-0.62, 0.02, 0.68), ' ');
  EXPECT_EQ(at(-0.62, 0.02, 0.72), '#');
  EXPECT_EQ(at(-0.62, 0.02, 0.78), ' ');
  EXPECT_EQ(at(-1.38, -0.38, 0.3), '#') << "leg";
  // the low wall: 2.1 m free above
  EXPECT_EQ(at(1.22, 3.02, 0.48), '#');
  EXPECT_EQ(at(1.22, 3.02, 0.52), ' ');
  EXPECT_EQ(at(1.22, 3.02, 2.58), ' ');
  // the door and its lintel
  EXPECT_EQ(runsAt(*tree, 2.97, 0.92).substr(0, 3), "# #");
  EXPECT_EQ(at(2.97, 0.92, 2.02), ' ');
  EXPECT_EQ(at(2.97, 0.92, 2.07), '#');
  EXPECT_EQ(at(2.97, -0.52, 1.0), '#') << "wall beside the door";
  // the ramp rises 0.2 m per metre to the platform
  EXPECT_EQ(at(7.02, -0.42, 0.03), '#');
  EXPECT_EQ(at(7.02, -0.42, 0.13), ' ');
  EXPECT_EQ(at(7.02, 0.83, 0.27), '#');
  EXPECT_EQ(at(7.02, 0.83, 0.38), ' ');
  EXPECT_EQ(at(7.02, 3.52, 0.58), '#');
  EXPECT_EQ(at(7.02, 3.52, 0.62), ' ');
  // the shelf is higher than a robot's clearance allows under the ceiling
  EXPECT_EQ(at(-1.02, 4.48, 0.2), '#');
  EXPECT_EQ(at(-1.02, 4.48, 1.98), '#');
  EXPECT_EQ(at(-1.02, 4.48, 2.02), ' ');
  // the window
  EXPECT_EQ(at(-0.52, -2.92, 0.88), '#');
  EXPECT_EQ(at(-0.52, -2.92, 0.92), ' ');
  EXPECT_EQ(at(-0.52, -2.92, 2.08), ' ');
  EXPECT_EQ(at(-0.52, -2.92, 2.12), '#');
  EXPECT_EQ(at(-3.02, -2.88, 1.5), '#') << "wall beside the window";
}

TEST(BuildingMap, OutsideAndInsideOfSolidsAreUnknown)
{
  const auto tree = buildingMap();
  EXPECT_EQ(stateAt(*tree, -4.2, 0, 1), '.');
  EXPECT_EQ(stateAt(*tree, 8.2, 0, 1), '.');
  EXPECT_EQ(stateAt(*tree, 0, 0, 2.8), '.');
  EXPECT_EQ(stateAt(*tree, 0, 0, -0.2), '.');
  EXPECT_EQ(stateAt(*tree, 7.02, 3.52, 0.3), '.') << "inside the platform";
  EXPECT_EQ(stateAt(*tree, -3.98, 0, 1), '.') << "inside the outer wall";
}

TEST(BuildingMap, IsAsReadFromAFileAtAnyResolution)
{
  for (const double resolution : {0.05, 0.07, 0.08, 0.1, 0.3})
  {
    SCOPED_TRACE(resolution);
    const auto tree = buildingMap(resolution);
    expectAsReadFromFile(*tree);
    EXPECT_EQ(runsAt(*tree, -2.02, -1.02), "# #");
    EXPECT_EQ(stateAt(*tree, -0.62, 0.02, 0.35), ' ') << "under the table";
    EXPECT_EQ(stateAt(*tree, 1.27, 3.02, 1.2), ' ') << "above the low wall";
  }
}

TEST(BuildingMap, IsTheSameEveryTime)
{
  EXPECT_EQ(written(*buildingMap()), written(*buildingMap()));
}

TEST(BuildingMap, RefusesBadResolutions)
{
  for (const double bad : {0.0, -1.0, 0.001, 2.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(buildingMap(bad), std::invalid_argument) << bad;
}

TEST(OutdoorMap, HasAboutSevenMillionLeaves)
{
  const auto tree = outdoorMap();
  const std::size_t leaves = tree->getNumLeafNodes();
  EXPECT_GE(leaves, 6500000u);
  EXPECT_LE(leaves, 7500000u);
  double min[3], max[3];
  tree->getMetricMin(min[0], min[1], min[2]);
  tree->getMetricMax(max[0], max[1], max[2]);
  EXPECT_NEAR(max[0] - min[0], 200.0, 0.5);
  EXPECT_NEAR(max[1] - min[1], 200.0, 0.5);

  // The ground: the lowest occupied voxel of the columns. Houses and walls stand on it.
  double lowest = 1e9, highest = -1e9;
  for (double x = -99.9; x < 100; x += 2)
    for (double y = -99.9; y < 100; y += 2)
      for (double z = -0.3; z < 12; z += 0.2)
        if (stateAt(*tree, x, y, z) == '#')
        {
          lowest = std::min(lowest, z);
          highest = std::max(highest, z);
          break;
        }
  EXPECT_NEAR(lowest, 0, 0.5);
  EXPECT_GT(highest, 7.0);
}

/** The parts are found by what they look like along z, wherever the dice have put them. */
TEST(OutdoorMap, HasOverhangsHolesAndLeavesOfManySizes)
{
  OutdoorOptions options;
  options.size = 100;
  const auto tree = outdoorMap(options);
  std::size_t plain = 0, overhangs = 0, unseen = 0, free = 0;
  for (double x = -49.9; x < 50; x += 0.4)
    for (double y = -49.9; y < 50; y += 0.4)
    {
      const std::string runs = runsAt(*tree, x, y);
      plain += runs == "# ";
      overhangs += runs.rfind("# #", 0) == 0;
      unseen += runs.empty();
      free += runs.find(' ') != std::string::npos;
    }
  const std::size_t columns = 250 * 250;
  EXPECT_GT(plain, columns / 2);
  EXPECT_GT(overhangs, columns / 100) << "roofs, crowns";
  EXPECT_GT(unseen, columns / 200) << "houses, shadows, holes";
  EXPECT_GT(free, columns * 3 / 4);

  std::set<unsigned> depths;
  for (auto it = tree->begin_leafs(); it != tree->end_leafs(); ++it) depths.insert(it.getDepth());
  EXPECT_GE(depths.size(), 4u);
}

TEST(OutdoorMap, HasABridgeOverItsMiddle)
{
  OutdoorOptions options;
  options.size = 60;
  const auto tree = outdoorMap(options);
  std::size_t over = 0;
  for (double x = -13; x < 13; x += 0.4) over += runsAt(*tree, x + 0.1, 0.9) == "# # ";
  EXPECT_GT(over, 30u);
}

TEST(OutdoorMap, SmallOnesWorkAtAnyResolutionAndAreAsReadFromAFile)
{
  for (const double resolution : {0.07, 0.2, 0.3, 1.0})
    for (const double size : {10.0, 20.0, 33.3})
    {
      SCOPED_TRACE(std::to_string(size) + " m at " + std::to_string(resolution));
      OutdoorOptions options;
      options.size = size;
      options.resolution = resolution;
      const auto tree = outdoorMap(options);
      expectAsReadFromFile(*tree);
      EXPECT_GT(countLeaves(*tree, true), 10u);
      EXPECT_GT(countLeaves(*tree, false), 10u);
    }
}

TEST(OutdoorMap, DependsOnItsSeedOnly)
{
  OutdoorOptions options;
  options.size = 30;
  const std::string first = written(*outdoorMap(options));
  EXPECT_EQ(written(*outdoorMap(options)), first);
  options.seed = 2;
  EXPECT_NE(written(*outdoorMap(options)), first);
}

TEST(OutdoorMap, RefusesBadOptions)
{
  const auto options = [](double size, double resolution)
  {
    OutdoorOptions o;
    o.size = size;
    o.resolution = resolution;
    return o;
  };
  EXPECT_THROW(outdoorMap(options(0, 0.2)), std::invalid_argument);
  EXPECT_THROW(outdoorMap(options(1000, 0.5)), std::invalid_argument);
  EXPECT_THROW(outdoorMap(options(20, 0)), std::invalid_argument);
  EXPECT_THROW(outdoorMap(options(20, std::numeric_limits<double>::quiet_NaN())),
               std::invalid_argument);
  EXPECT_THROW(outdoorMap(options(200, 0.05)), std::invalid_argument);
}
}  // namespace
