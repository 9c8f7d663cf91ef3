#include "output/InfoOctree.h"

#include <mrpt/core/format.h>
#include <mrpt_mapconv/voxel/OctreeFile.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <array>

#include "output/FreeSpaceAdvice.h"

namespace mapconv
{
namespace
{
struct Leaves
{
  std::size_t free = 0, occupied = 0;
};

template <class Tree>
bool countLeaves(const octomap::AbstractOcTree& any, Leaves& leaves)
{
  const auto* tree = dynamic_cast<const Tree*>(&any);
  if (!tree) return false;
  for (auto it = tree->begin_leafs(), end = tree->end_leafs(); it != end; ++it)
    ++(tree->isNodeOccupied(*it) ? leaves.occupied : leaves.free);
  return true;
}

Leaves leavesOf(const octomap::AbstractOcTree& tree)
{
  Leaves leaves;
  countLeaves<octomap::OcTree>(tree, leaves) || countLeaves<octomap::ColorOcTree>(tree, leaves) ||
      countLeaves<octomap::OcTreeStamped>(tree, leaves);
  return leaves;
}

void describeBox(const octomap::AbstractOcTree& tree, InfoReport& report)
{
  if (tree.size() == 0) return;
  std::array<double, 3> min{}, max{};
  tree.getMetricMin(min[0], min[1], min[2]);
  tree.getMetricMax(max[0], max[1], max[2]);
  std::string text;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::string axis(1, "xyz"[i]);
    report.json.add(axis + "Min", min[i]).add(axis + "Max", max[i]);
    text += mrpt::format("%s%s %.2f to %.2f", i == 0 ? "" : ", ", axis.c_str(), min[i], max[i]);
  }
  report.line("known", text + " m");
}
}  // namespace

void describeOctree(const octomap::AbstractOcTree& tree, InfoReport& report)
{
  const Leaves leaves = leavesOf(tree);
  report.json.add("treeType", tree.getTreeType()).add("resolution", tree.getResolution());
  report.json.add("nodes", tree.size()).add("leaves", leaves.free + leaves.occupied);
  report.json.add("freeLeaves", leaves.free).add("occupiedLeaves", leaves.occupied);
  report.json.add("memoryBytes", tree.memoryUsage());
  report.line("tree type", tree.getTreeType());
  report.line("resolution", jsonNumber(tree.getResolution()) + " m");
  report.line("leaves", mrpt::format("%zu (%zu free, %zu occupied) of %zu nodes",
                                     leaves.free + leaves.occupied, leaves.free, leaves.occupied,
                                     tree.size()));
  if (leaves.free == 0 && leaves.occupied > 0) report.line("free space", kNoFreeVoxel);
  describeBox(tree, report);
  report.line("memory", mrpt::format("%.1f MB", static_cast<double>(tree.memoryUsage()) / 1e6));
}

void describeOctreeFile(mrpt_mapconv::files::InputStream& stream, InfoReport& report)
{
  const auto tree = mrpt_mapconv::voxel::readOctree(stream);
  report.json.add("kind", "octree");
  report.line("kind", "OctoMap file");
  describeOctree(*tree, report);
}

}  // namespace mapconv
