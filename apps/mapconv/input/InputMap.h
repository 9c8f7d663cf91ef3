#pragma once

#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <memory>
#include <optional>
#include <string>

#include "input/ScanFile.h"
#include "output/Progress.h"

namespace octomap
{
class AbstractOcTree;
class AbstractOccupancyOcTree;
}  // namespace octomap

namespace mapconv
{
/** Which voxel map is wanted. */
struct InputRequest
{
  std::string file;                              //!< "-": what is piped in
  std::optional<double> resolution;              //!< of a voxel map that is built from scans [m]
  mrpt_mapconv::observation::RawlogOptions log;  //!< where the poses of a rawlog come from
  mrpt_mapconv::voxel::TVoxelInsertionOptions insertion;  //!< how scans are inserted
};

/** The voxel map that a file holds, or that its scans give. */
class InputMap
{
 public:
  /** Warns where parts of the request or of the file have no effect.
   * \exception std::exception in one line naming the file and what is wrong with it */
  InputMap(const InputRequest& request, Progress& progress);
  ~InputMap();

  const mrpt_mapconv::voxel::VoxelSource& source() const { return *m_source; }
  const octomap::AbstractOccupancyOcTree& octree() const;
  /** What it was made of, e.g. "OctoMap file (OcTree)". */
  const std::string& description() const { return m_description; }

 private:
  void readObject(mrpt_mapconv::files::ObjectFile& file, const InputRequest& request,
                  Progress& progress);
  void readTree(mrpt_mapconv::files::InputStream& stream, const InputRequest& request);
  void buildFromScans(mrpt_mapconv::files::ObjectFile& log, LogKind kind,
                      const InputRequest& request, Progress& progress);

  void useTree(const octomap::AbstractOcTree& tree);

  std::unique_ptr<octomap::AbstractOcTree> m_ownTree;  //!< unless it belongs to m_object
  mrpt::serialization::CSerializable::Ptr m_object;
  const octomap::AbstractOccupancyOcTree* m_tree = nullptr;
  std::unique_ptr<mrpt_mapconv::voxel::VoxelSource> m_source;
  std::string m_description;
};

}  // namespace mapconv
