#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <octomap/OcTree.h>

namespace mrpt_mapconv::eval
{
/** The fixed projection as OctoMap's server makes it, with OctoMap's own leaf iterator over a box:
 * what a user has today, as a baseline.
 *
 * \param zMin,zMax [m], may be infinite
 * \param layer its cells are written: 1 occupied, 0 free, −1 unknown; its frame is the box's
 * rectangle or holds it
 * \param cells the box's rectangle, of the tree's resolution */
void projectByLeaves(const octomap::OcTree& tree, double zMin, double zMax,
                     const grid::GridFrame& cells, grid::Layer<float>& layer);

}  // namespace mrpt_mapconv::eval
