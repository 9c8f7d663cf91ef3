#pragma once

#include <mrpt_mapconv/observation/CloudScans.h>
#include <mrpt_mapconv/observation/SayOnceLog.h>
#include <mrpt_mapconv/observation/ScanLog.h>
#include <mrpt_mapconv/observation/SensorPoints.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "input/TerrainSettings.h"
#include "output/Console.h"

namespace mapconv
{
/** What became of a series of scans. */
struct TerrainFigures
{
  std::size_t scans = 0;                            //!< 3D scans that were inserted
  std::size_t withCovariance = 0;                   //!< of them, whose pose has one in the log
  std::size_t scans2D = 0;                          //!< left out
  std::size_t points = 0;                           //!< inserted
  std::size_t beyondLimits = 0, outsideWindow = 0;  //!< points left out
  std::map<std::string, std::size_t> skipped;       //!< 3D scans, by the reason

  std::size_t skips() const;
};

/** Inserts scans into a terrain map one after another, and keeps account of it. */
class TerrainBuilder
{
 public:
  explicit TerrainBuilder(const TerrainSettings& settings);

  /** \exception std::exception for damaged scans, points too far away and layers that would be too
   * large @{ */
  void insert(const mrpt_mapconv::observation::PosedObservation& scan);
  void insert(const mrpt_mapconv::observation::CloudScan& scan);
  /** @} */
  /** Finds planes and leaves. \param threads 0 = all cores */
  void finish(int threads) { m_map.update(threads); }

  const mrpt_mapconv::terrain::TerrainMap& map() const { return m_map; }
  const TerrainSettings& settings() const { return m_settings; }
  const TerrainFigures& figures() const { return m_figures; }

 private:
  void insert(const mrpt_mapconv::observation::SensorPoints& points,
              const std::optional<mrpt_mapconv::observation::HeightCovariance>& poseCovariance);
  void skip(const std::string& why) { ++m_figures.skipped[why]; }

  TerrainSettings m_settings;
  mrpt_mapconv::terrain::TerrainMap m_map;
  TerrainFigures m_figures;
  mrpt_mapconv::observation::SensorPoints m_points;  //!< of a scan; its memory is kept
  ConsoleLog m_log;
  mrpt_mapconv::observation::SayOnceLog m_warnings;
};

}  // namespace mapconv
