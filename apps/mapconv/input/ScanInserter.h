#pragma once

#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/observation/ScanLog.h>

#include <cstddef>
#include <map>
#include <string>

#include "input/ScanSettings.h"

namespace mapconv
{
/** What became of a series of scans. */
struct InsertionFigures
{
  struct Skipped
  {
    std::size_t count = 0;
    std::string why;  //!< of the first one
  };

  std::size_t scans3D = 0, scans2D = 0;  //!< that were inserted
  std::size_t points = 0;                //!< of scans3D
  double seconds3D = 0;                  //!< that inserting scans3D took, decoding included [s]
  double wallShares = 0;                 //!< sum over scans3D
  /** By the map's kind of reason, which is empty for scans that it is told to leave out. */
  std::map<std::string, Skipped> skipped;

  std::size_t skips() const;
  /** Those of them that nobody asked for. */
  std::size_t unwantedSkips() const;
  double scansPerSecond() const;
  double pointsPerSecond() const;
  /** Mean over scans3D of the share of azimuths with a wall. */
  double meanWallShare() const;
};

/** Inserts scans into a map one after another, and keeps account of it. The map's warnings are
 * printed, but for those of skipped scans, which the account sums up. */
class ScanInserter
{
 public:
  explicit ScanInserter(const ScanSettings& settings);
  ScanInserter(const ScanInserter&) = delete;
  ScanInserter& operator=(const ScanInserter&) = delete;

  /** \exception std::exception for bad options, damaged scans and a grid that would be too large */
  void insert(const mrpt_mapconv::observation::PosedObservation& scan);

  const mrpt_mapconv::CScanShapeGridMap2D& map() const { return m_map; }
  const ScanSettings& settings() const { return m_settings; }
  const InsertionFigures& figures() const { return m_figures; }

 private:
  void count(const mrpt::obs::CObservation& obs, double seconds);
  void countSkip();

  ScanSettings m_settings;
  mrpt_mapconv::CScanShapeGridMap2D m_map;
  InsertionFigures m_figures;
};

}  // namespace mapconv
