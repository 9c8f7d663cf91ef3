#pragma once

#include <mrpt/serialization/CSerializable.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/voxel/VoxelInsertion.h>
#include <mrpt_mapconv/voxel/VoxelMap.h>
#include <mrpt_mapconv/voxel/VoxelSource.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/CloudInput.h"
#include "input/GeoOptions.h"
#include "input/NoEffect.h"
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
  std::string iniFile;                           //!< where settings are from; empty: none
  std::optional<double> resolution;              //!< of a voxel map that is built from scans [m]
  int threads = 0;                               //!< that build it; 0: all cores
  mrpt_mapconv::observation::RawlogOptions log;  //!< where the poses of a rawlog come from
  GeoOptions geo;                                //!< where the map lies
  TrajectoryOptions trajectory;                  //!< of a cloud
  std::string columns;                           //!< names of a text's columns; of a cloud
  mrpt_mapconv::voxel::TVoxelInsertionOptions insertion;  //!< how scans are inserted
  std::vector<std::string> insertionKeys;  //!< of `insertion`, those that iniFile changes
  NoEffect noEffect;                       //!< what else was asked for in vain
};

/** The voxel map that a file holds, or that its scans give. occupancyThres goes for both, as far as
 * the file holds probabilities. */
class InputMap
{
 public:
  /** Warns, in one line, of those parts of the request that have no effect on this file.
   * \exception std::exception in one line naming the file and what is wrong with it */
  InputMap(const InputRequest& request, Progress& progress);
  ~InputMap();

  const mrpt_mapconv::voxel::VoxelSource& source() const { return *m_source; }
  /** Writes the voxels as a `.bt` file, see voxel::writeOctreeFile(). */
  void writeOctree(const std::string& path) const;
  /** Where its frame lies. */
  const mrpt_mapconv::grid::GeoReference& reference() const { return m_reference; }
  /** What it was made of, e.g. "OctoMap file (OcTree)". */
  const std::string& description() const { return m_description; }

 private:
  void read(const InputRequest& request, Progress& progress);
  void readObject(mrpt_mapconv::files::ObjectFile& file, const InputRequest& request,
                  Progress& progress);
  void readTree(mrpt_mapconv::files::InputStream& stream, const InputRequest& request);
  void buildFromCloud(mrpt_mapconv::files::InputStream& stream, const InputRequest& request,
                      Progress& progress);
  void buildFromScans(mrpt_mapconv::files::ObjectFile& log, LogKind kind,
                      const InputRequest& request, Progress& progress);

  void useTree(const octomap::AbstractOcTree& tree);
  void applyThreshold(const InputRequest& request);

  NoEffect m_noEffect;
  std::optional<mrpt_mapconv::voxel::VoxelMap> m_built;  //!< of scans
  std::unique_ptr<octomap::AbstractOcTree> m_ownTree;    //!< unless it belongs to m_object
  mrpt::serialization::CSerializable::Ptr m_object;
  const octomap::AbstractOccupancyOcTree* m_tree = nullptr;
  std::unique_ptr<mrpt_mapconv::voxel::VoxelSource> m_source;
  mrpt_mapconv::grid::GeoReference m_reference;
  std::string m_description;
};

}  // namespace mapconv
