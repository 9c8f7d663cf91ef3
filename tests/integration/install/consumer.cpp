#include <mrpt_mapconv/maps/CFreeSpaceGridMap2D.h>
#include <octomap/OcTree.h>

int main()
{
  octomap::OcTree tree(0.5);
  for (int z = -1; z < 4; ++z) tree.updateNode(0.1, 0.1, 0.5 * z + 0.1, z < 0);
  mrpt_mapconv::CFreeSpaceGridMap2D map;
  map.setVoxelMap(tree);
  return map.getRawMap().at(0) == 127 ? 0 : 1;  // one free cell, over ground that was seen
}
