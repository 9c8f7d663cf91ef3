#pragma once

#include <mrpt_mapconv/terrain/TerrainOptions.h>

#include <string>
#include <vector>

#include "input/FieldFlags.h"
#include "output/Json.h"

namespace mapconv
{
/** What the command line says about how terrain is mapped. */
struct TerrainFlags
{
  FieldFlags<mrpt_mapconv::terrain::TerrainGridParams> grid;
  FieldFlags<mrpt_mapconv::terrain::TTerrainInsertionOptions> insertion;
  FieldFlags<mrpt_mapconv::terrain::TTerrainOptions> terrain;
};

/** How terrain is mapped. */
struct TerrainSettings
{
  mrpt_mapconv::terrain::TerrainGridParams grid;
  mrpt_mapconv::terrain::TTerrainInsertionOptions insertion;
  mrpt_mapconv::terrain::TTerrainOptions terrain;
  /** What somebody said of the robot's pose, as it was written: flags, and keys with their file. */
  std::vector<std::string> poseSigmas;
};

/** Reads sections [map], [terrainInsertion] and [terrain] of an ini file, in which flags replace
 * what they stand for; what is in neither keeps its default. Warns about sections and keys that
 * mean nothing here.
 * \param iniFile empty: none
 * \exception std::runtime_error in one line naming the file and what is wrong with it */
TerrainSettings readTerrainSettings(const std::string& iniFile, const TerrainFlags& flags);

/** All settings but the resolution, which is the grid's; named and in the units of the ini file. */
JsonObject settingsJson(const TerrainSettings& settings);
/** Those of them that are not the default, as "key = value, key = value". */
std::string changedText(const TerrainSettings& settings);

}  // namespace mapconv
