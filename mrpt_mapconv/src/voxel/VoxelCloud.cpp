#include <mrpt_mapconv/voxel/VoxelCloud.h>

#include "ReadBlocks.h"

namespace mrpt_mapconv::voxel
{
namespace
{
void appendOccupied(const ColumnBlock& block, double resolution, cloud::PointCloud& cloud)
{
  const auto centreOf = [resolution](std::int32_t key) { return (key + 0.5) * resolution; };
  for (std::int32_t w = 0; w < block.words(); ++w)
    for (std::int32_t c = 0; c < kBlockColumns; ++c)
      for (std::uint64_t left =
               block.occupiedPlane()[static_cast<std::ptrdiff_t>(w) * kBlockColumns + c];
           left != 0; left &= left - 1)
      {
        cloud.x.push_back(centreOf(kBlockSide * block.key().x + c % kBlockSide));
        cloud.y.push_back(centreOf(kBlockSide * block.key().y + c / kBlockSide));
        cloud.z.push_back(centreOf(block.zMin() + 64 * w + __builtin_ctzll(left)));
      }
}
}  // namespace

cloud::PointCloud occupiedCentres(const VoxelSource& source)
{
  cloud::PointCloud cloud;
  readBlocks(source,
             [&](const ColumnBlock& block)
             {
               appendOccupied(block, source.resolution(), cloud);
               return false;
             });
  return cloud;
}

}  // namespace mrpt_mapconv::voxel
