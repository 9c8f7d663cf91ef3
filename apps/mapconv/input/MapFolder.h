#pragma once

#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <memory>
#include <string>

namespace octomap
{
class AbstractOcTree;
}

namespace mapconv
{
/** What `mapconv convert` leaves in a folder for other subcommands. */
class MapFolder
{
 public:
  static constexpr const char* kLayers = "layers.tif";
  static constexpr const char* kVoxels = "voxels.bt";

  /** \exception std::exception in one line naming the file and what is wrong with it */
  explicit MapFolder(const std::string& dir);
  ~MapFolder();

  const mrpt_mapconv::freespace::Layers& layers() const { return m_file.layers; }
  const mrpt_mapconv::freespace::ConversionParams& params() const { return m_file.params; }
  /** Where the layers' frame lies: users speak of coordinates with its origin. */
  const mrpt_mapconv::grid::GeoReference& reference() const { return m_file.reference; }
  /** The voxel map that the layers were made of; null if the folder has none any more. */
  const mrpt_mapconv::voxel::VoxelSource* voxels() const { return m_source.get(); }
  const octomap::AbstractOcTree* octree() const { return m_tree.get(); }

 private:
  mrpt_mapconv::freespace::LayersFile m_file;
  std::unique_ptr<octomap::AbstractOcTree> m_tree;
  std::unique_ptr<mrpt_mapconv::voxel::VoxelSource> m_source;
};

}  // namespace mapconv
