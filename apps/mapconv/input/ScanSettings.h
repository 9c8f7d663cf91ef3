#pragma once

#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>

#include <string>
#include <vector>

#include "input/FieldFlags.h"
#include "input/NoEffect.h"
#include "output/Json.h"

namespace mapconv
{
/** What the command line says about how scans are inserted. */
struct ScanFlags
{
  FieldFlags<mrpt_mapconv::scan::ScanGridParams> grid;
  FieldFlags<mrpt_mapconv::scan::ProfileParams> profile;
  std::vector<double> object, structure;  //!< ends of the slices [m]; empty: not given
  bool noReflectionFilter = false;
  bool no2D = false;
};

/** How scans are inserted. */
struct ScanSettings
{
  mrpt_mapconv::scan::ScanGridParams grid;
  mrpt_mapconv::scan::TScanInsertionOptions insertion;
  mrpt::maps::COccupancyGridMap2D::TInsertionOptions insertion2D;
  bool lacksStructure = false;  //!< the filter is wanted, but nobody said where; then it is off
};

/** Reads sections [map] and [scanInsertion] of an ini file, in which flags replace what they stand
 * for; what is in neither keeps its default. Warns about sections and keys that mean nothing here.
 * \param iniFile empty: none
 * \param noEffect gets what means something, but not with the rest of the settings
 * \exception UsageError if flags contradict each other, or if the resolution that a flag gives is
 * too fine for maxRange \exception std::runtime_error as readIni(), and if the resolution is too
 * fine for maxRange */
ScanSettings readScanSettings(const std::string& iniFile, const ScanFlags& flags,
                              NoEffect& noEffect);

/** To be asked once it is known that there are 3D scans.
 * \exception UsageError if the reflection filter has no structure slice */
void requireStructure(const ScanSettings& settings);

/** All settings but the resolution, which is the grid's; named and in the units of the ini file. */
JsonObject settingsJson(const ScanSettings& settings);
/** Those of them that are not the default, as "key = value, key = value". */
std::string changedText(const ScanSettings& settings);

}  // namespace mapconv
