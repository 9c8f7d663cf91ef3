#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

namespace mrpt_mapconv::planning
{
/** A ground robot's occupancy layer, in which also those free cells are occupied over whose
 * inferred ground a voxel map shows something in the robot's way, as path::PieceCheck takes it.
 *
 * The line between seen cells says where the ground of an open cell is, however high free space
 * begins there. What is known to be occupied below that, and above the line by more than a robot
 * climbs, does not show in the layer; nor does what hangs low over a line above the floor.
 * \param layers, conversion, voxels as for planRobotPath() */
grid::Layer<float> withInferredObstacles(const freespace::Layers& layers,
                                         const freespace::ConversionParams& conversion,
                                         const voxel::VoxelSource& voxels);

}  // namespace mrpt_mapconv::planning
