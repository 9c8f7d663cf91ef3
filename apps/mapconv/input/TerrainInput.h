#pragma once

#include <mrpt_mapconv/observation/ScanLog.h>

#include <optional>
#include <string>

#include "input/CloudInput.h"
#include "input/GeoOptions.h"
#include "input/NoEffect.h"
#include "input/ScanFile.h"
#include "input/TerrainBuilder.h"
#include "output/Progress.h"

namespace mapconv
{
/** What a terrain map is to be made of. */
struct TerrainRequest
{
  std::string file;                              //!< "-": what is piped in
  mrpt_mapconv::observation::RawlogOptions log;  //!< where the poses of a rawlog come from
  GeoOptions geo;                                //!< where the map lies
  TrajectoryOptions trajectory;                  //!< of a cloud
  std::string columns;                           //!< names of a text's columns; of a cloud
};

/** The 3D scans of a log, or a cloud with the trajectory of its sensor. */
class TerrainInput
{
 public:
  /** \exception std::runtime_error in one line naming the file and what is wrong with it */
  TerrainInput(const TerrainRequest& request, NoEffect& noEffect, Progress& progress);

  /** Inserts all scans; those of a cloud are its points in the order of time, see
   * observation::CloudScans. Warns of points that the trajectory does not cover.
   * \exception std::exception naming file and scan */
  void insertInto(TerrainBuilder& builder, Progress& progress) const;

  /** Where its frame lies. */
  const mrpt_mapconv::grid::GeoReference& reference() const { return m_reference; }
  const std::string& description() const { return m_description; }

 private:
  void insertCloud(TerrainBuilder& builder, Progress& progress) const;

  std::string m_name;
  TrajectoryOptions m_trajectory;
  std::optional<ScanFile> m_log;
  std::optional<SeenCloud> m_cloud;
  mrpt_mapconv::grid::GeoReference m_reference;
  std::string m_description;
};

}  // namespace mapconv
