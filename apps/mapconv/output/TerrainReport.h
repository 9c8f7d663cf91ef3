#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <cstddef>
#include <string>

#include "output/Json.h"

namespace mapconv
{
/** What a terrain map holds, in numbers. */
struct TerrainCounts
{
  std::size_t cells = 0, leaves = 0, planes = 0, cellsInPlanes = 0, steps = 0;
  double smallestLeaf = 0, largestLeaf = 0;  //!< sides [m]
  double lowestStep = 0, highestStep = 0;    //!< [m]
};

/** \param layers of the map, on a frame with at least one cell */
TerrainCounts countsOf(const mrpt_mapconv::terrain::TerrainMap& map,
                       const mrpt_mapconv::terrain::TerrainLayers& layers);
/** Lines of a summary. */
std::string countsText(const TerrainCounts& counts);
void addCounts(const TerrainCounts& counts, JsonObject& json);

/** Writes a `.3Dscene`: leaves coloured by plane, a legend and a
 * reference grid. Made of MRPT's own objects, so SceneViewer3D opens it without this library.
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writeTerrainScene(const std::string& path, const mrpt_mapconv::terrain::TerrainMap& map,
                       const mrpt_mapconv::terrain::TerrainLayers& layers);

}  // namespace mapconv
