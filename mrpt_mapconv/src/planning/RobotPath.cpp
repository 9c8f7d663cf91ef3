#include <mrpt_mapconv/planning/RobotPath.h>

#include <stdexcept>
#include <string>

#include "RobotPlanner.h"

namespace mrpt_mapconv::planning
{
RobotPath planRobotPath(const freespace::Layers& layers,
                        const freespace::ConversionParams& conversion, const RobotPathQuery& query,
                        const voxel::VoxelSource* voxels)
{
  if (query.mostAttempts < 1)
    throw std::invalid_argument("plan: mostAttempts = " + std::to_string(query.mostAttempts) +
                                " is not valid: it must be at least 1");
  return RobotPlanner(layers, conversion, query, voxels).plan();
}

}  // namespace mrpt_mapconv::planning
