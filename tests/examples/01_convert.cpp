// Example 1: a voxel map becomes 2D layers.
//
// Take any OctoMap tree, say how tall and how clumsy the robot is, and get one image-like layer per
// question: where is the floor, where the ceiling, how steep is it, where may a robot fly or drive?
// The example makes its own small map, writes three kinds of files into the current folder, and
// ends with 1 if the layers are not what one would work out by hand.
#include <mrpt_mapconv/freespace/Conversion.h>
#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/grid/CellKey.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/RosMap.h>
#include <mrpt_mapconv/voxel/OctreeSource.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <iostream>

using namespace mrpt_mapconv;

namespace
{
/** 4 x 3 m of floor at z = 0 with 2 m of air above it, and in the middle a crate of 1 x 1 x 0.5 m.
 */
octomap::OcTree roomWithCrate()
{
  octomap::OcTree tree(0.1);
  for (int ix = 0; ix < 40; ++ix)
    for (int iy = 0; iy < 30; ++iy)
    {
      const double x = 0.1 * ix + 0.05, y = 0.1 * iy + 0.05;  // the voxels' centres
      const int top = ix >= 15 && ix < 25 && iy >= 10 && iy < 20 ? 5 : 0;
      tree.updateNode(x, y, 0.1 * top - 0.05, true);  // what one would stand on
      for (int iz = top; iz < 20; ++iz) tree.updateNode(x, y, 0.1 * iz + 0.05, false);
    }
  return tree;
}

/** The value of a layer at a place in metres. */
float at(const grid::Layer<float>& layer, double x, double y)
{
  const grid::GridFrame& frame = layer.frame();
  return layer.at(grid::cellKey(x, frame.resolution) - frame.x0,
                  grid::cellKey(y, frame.resolution) - frame.y0);
}
}  // namespace

int main()
{
  const octomap::OcTree tree = roomWithCrate();  // or voxel::readOctreeFile("map.bt")

  // Every voxel map is read through a VoxelSource; this one wraps OctoMap's trees.
  const voxel::OctreeSource<octomap::OcTree> source(tree);

  // The robot. What is not set keeps its default; see share/doc/parameters.md for all of them.
  freespace::ConversionParams params;
  params.minClearance = 0.8;  // it needs 0.8 m of free space above the floor
  params.maxStep = 0.2;       // and drives over steps of up to 0.2 m

  const freespace::Layers layers = freespace::convert(source, params);

  freespace::writeLayersTiff("layers.tif", layers, params);  // all of them, for GIS and mapconv
  grid::writeGridMap("ground.gridmap", layers.ground);       // a plain COccupancyGridMap2D
  grid::writeRosMap("ground.pgm", "ground.yaml", "ground.pgm", layers.ground);

  // Heights are those of the voxels' faces, so they can be told to a hair.
  const float floor = at(layers.floor, 0.55, 1.55), crate = at(layers.floor, 2.05, 1.55);
  const bool fliesOverCrate = grid::isFree(at(layers.aerial, 2.05, 1.55));
  const bool drivesOntoCrate = grid::isFree(at(layers.ground, 1.55, 1.55));  // its rim
  const bool drivesBeside = grid::isFree(at(layers.ground, 0.55, 1.55));
  std::cout << "floor " << floor << " m, on the crate " << crate << " m\n"
            << "over the crate: flying " << (fliesOverCrate ? "yes" : "no") << ", driving "
            << (drivesOntoCrate ? "yes" : "no") << '\n';

  const bool right = std::abs(floor) < 1e-6f && std::abs(crate - 0.5f) < 1e-6f && fliesOverCrate &&
                     !drivesOntoCrate && drivesBeside;
  if (!right) std::cerr << "that is not what the room looks like\n";
  return right ? 0 : 1;
}
