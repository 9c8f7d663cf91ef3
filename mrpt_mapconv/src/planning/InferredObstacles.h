#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

namespace mrpt_mapconv::planning
{
/** A ground robot's occupancy layer, in which also those free cells are occupied over whose
 * inferred ground a voxel map shows something in the robot's way, as path::PieceCheck takes it.
 *
 * The line between seen cells, which says where the ground of an open cell is, may lie above the
 * cell's floor. What hangs low over it does then not show in the layer; nor, where steps are not
 * looked for, does what stands on it no higher than a step.
 * \param layers, conversion, voxels as for planRobotPath() */
grid::Layer<float> withInferredObstacles(const freespace::Layers& layers,
                                         const freespace::ConversionParams& conversion,
                                         const voxel::VoxelSource& voxels);

}  // namespace mrpt_mapconv::planning
