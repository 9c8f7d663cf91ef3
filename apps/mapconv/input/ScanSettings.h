#pragma once

#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>

#include <optional>
#include <string>
#include <vector>

#include "output/Json.h"

namespace mapconv
{
/** What the command line says about how scans are inserted. */
struct ScanFlags
{
  std::optional<double> resolution;  //!< [m]
  std::string model;                 //!< empty: not given
  std::vector<double> structure;     //!< ends of the structure slice [m]; empty: not given
  bool noReflectionFilter = false;
  bool no2D = false;
};

/** How scans are inserted. */
struct ScanSettings
{
  double resolution = 0.05;   //!< size of a cell [m]
  double maxGridCells = 4e8;  //!< a scan that would make the grid larger is an error
  mrpt_mapconv::scan::TScanInsertionOptions insertion;
  mrpt::maps::COccupancyGridMap2D::TInsertionOptions insertion2D;
};

/** Reads sections [map] and [insertion] of an ini file, in which flags replace what they stand for;
 * what is in neither keeps its default. Warns about sections and keys that mean nothing here.
 * \param iniFile empty: none
 * \exception UsageError if the reflection filter has no structure slice, or if the resolution that
 * a flag gives is too fine for maxRange \exception std::runtime_error as readIni(), and if the
 * resolution is too fine for maxRange */
ScanSettings readScanSettings(const std::string& iniFile, const ScanFlags& flags);

/** All settings but the resolution, which is the grid's; named and in the units of the ini file. */
JsonObject settingsJson(const ScanSettings& settings);
/** Those of them that are not the default, as "key = value, key = value". */
std::string changedText(const ScanSettings& settings);

}  // namespace mapconv
