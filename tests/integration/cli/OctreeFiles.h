#pragma once

#include <octomap/OcTree.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::testing
{
/** A voxel map of 5 × 3 columns with voxels of 0.5 m, whose layers are worked out by hand.
 *
 * Columns from the lowest voxel (z = 0) up: o occupied, f free. x keys are −2 … 2, y keys 1 … 3.
 * \verbatim
 *          x  −2      −1      0       1        2
 * y = 3     offff   offff   offof   ooofff   o
 * y = 2     offff   offff   ofooo   offff
 * y = 1     offff   offff   ooooo   offff    f
 * \endverbatim
 * With minClearance 1 (two voxels), minOccupancy 0.5, slopeWindow 1, maxSlope 2:
 */
struct HandMap
{
  static constexpr double resolution = 0.5;
  static constexpr int width = 5, height = 3;
  static constexpr double xMin = -1.0, yMin = 0.5, xMax = 1.5, yMax = 2.0;

  /** Layers by rows from the lowest y; NaN: no data. */
  static const std::vector<double> floor, ceiling, slope, aerial, ground, evidence;
  static constexpr int free = 10, occupied = 2, unknown = 3;
  static constexpr int steep = 1;               //!< (1, 3)
  static constexpr int steepWithMaxStep09 = 3;  //!< and its neighbours (0, 3) and (1, 2), 1 m lower
  static constexpr int slopeUnknown = 1;        //!< (1, 1): only two floors in its window
  static constexpr double minStep = 2.0;        //!< 2 · 0.5 · 3 / 1.5

  /** Fixed projection of the voxels between 0.5 and 1.5 m. */
  static const std::vector<double> projection;

  static octomap::OcTree tree();
  /** Writes it as a `.bt`. */
  static void write(const std::string& path);
};

/** A tree with one voxel per letter: columns[y][x] as above, lowest voxel at key (x0, y0, 0). */
octomap::OcTree treeOf(double resolution, const std::vector<std::vector<std::string>>& columns,
                       int x0, int y0);
void writeTree(octomap::OcTree tree, const std::string& path);

}  // namespace mrpt_mapconv::testing
