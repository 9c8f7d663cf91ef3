#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>

namespace mrpt_mapconv::freespace
{
/** Which cells are occupied in the ground layer because they are drop edges: 1, else 0.
 *
 * With floorFrom = seen, and unless maxStep is 0, a cell with support is a drop edge if one comes
 * from it, in one of 8 directions, over open cells without support only, to a cell whose floor lies
 * more than maxStep and a voxel below its support: one of these, or the first other cell after
 * them, whose centre is at most 1 m away. For pictures: it takes about as long as the ground layer
 * itself. \param layers as converted with these parameters */
grid::Layer<float> dropEdges(const Layers& layers, const ConversionParams& params);

}  // namespace mrpt_mapconv::freespace
