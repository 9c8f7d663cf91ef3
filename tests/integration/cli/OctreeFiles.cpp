#include "OctreeFiles.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace mrpt_mapconv::testing
{
namespace
{
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
}

const std::vector<double> HandMap::floor = {0.5, 0.5, kNone, 0.5, kNone,  //
                                            0.5, 0.5, kNone, 0.5, kNone,  //
                                            0.5, 0.5, 0.5,   1.5, kNone};
const std::vector<double> HandMap::ceiling = {2.5, 2.5, kNone, 2.5, kNone,  //
                                              2.5, 2.5, kNone, 2.5, kNone,  //
                                              2.5, 2.5, 1.5,   3.0, kNone};
// (1, 2): four floors; b = 0.5 and a = 5/6 voxels per cell by hand, doubled to m/m
// (0, 3): five floors; a = 1/4, b = 1/3. (1, 3): three floors; a = b = 1.
const std::vector<double> HandMap::slope = {0,     0, kNone,     kNone,
                                            kNone,  //
                                            0,     0, kNone,     std::sqrt(1.0 + 25.0 / 9.0),
                                            kNone,  //
                                            0,     0, 5.0 / 6.0, std::sqrt(8.0),
                                            kNone};
// (0, 1): full height of its neighbours. (0, 2): 3 of 4 voxels of (−1, 1)'s range.
// (2, 3): its only voxel lies below all ranges.
const std::vector<double> HandMap::aerial = {0, 0, 1,    0, -1,  //
                                             0, 0, 0.75, 0, -1,  //
                                             0, 0, 0,    0, -1};
const std::vector<double> HandMap::ground = {0, 0, 1,    0, -1,  //
                                             0, 0, 0.75, 0, -1,  //
                                             0, 0, 0,    1, -1};
// Seen but for: walls at (0, 1), (0, 2) and (2, 3), nothing at (2, 1), whose free voxel is too low
// a range, and at (2, 2).
const std::vector<double> HandMap::evidence = {1, 1, 4, 1, 0,  //
                                               1, 1, 4, 1, 0,  //
                                               1, 1, 1, 1, 4};
const std::vector<double> HandMap::projection = {0, 0, 1, 0, -1,  //
                                                 0, 0, 1, 0, -1,  //
                                                 0, 0, 0, 1, -1};

octomap::OcTree HandMap::tree()
{
  return treeOf(resolution,
                {{"offff", "offff", "ooooo", "offff", "f"},
                 {"offff", "offff", "ofooo", "offff", ""},
                 {"offff", "offff", "offof", "ooofff", "o"}},
                -2, 1);
}

void HandMap::write(const std::string& path) { writeTree(tree(), path); }

octomap::OcTree treeOf(double resolution, const std::vector<std::vector<std::string>>& columns,
                       int x0, int y0)
{
  octomap::OcTree tree(resolution);
  constexpr int kOrigin = 32768;
  const auto key = [](std::size_t i, int first)
  { return static_cast<octomap::key_type>(static_cast<int>(i) + first + kOrigin); };
  for (std::size_t y = 0; y < columns.size(); ++y)
    for (std::size_t x = 0; x < columns[y].size(); ++x)
      for (std::size_t z = 0; z < columns[y][x].size(); ++z)
        if (const char c = columns[y][x][z]; c == 'o' || c == 'f')
          tree.setNodeValue(octomap::OcTreeKey(key(x, x0), key(y, y0), key(z, 0)),
                            c == 'o' ? 2.0F : -2.0F);
  return tree;
}

void writeTree(octomap::OcTree tree, const std::string& path)
{
  if (!tree.writeBinary(path)) throw std::runtime_error("cannot write " + path);
}

}  // namespace mrpt_mapconv::testing
