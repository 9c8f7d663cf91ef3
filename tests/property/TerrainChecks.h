#pragma once

#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <string>

#include "../oracle/TerrainOracle.h"

namespace mrpt_mapconv::test
{
/** The first cells that have another plane than they should. */
std::string differences(const oracle::TerrainLabels& found, const oracle::TerrainLabels& wanted);

/** A map's planes are these, its leaves those by definition. */
void expectPartition(const terrain::TerrainMap& map, const oracle::TerrainLabels& planes,
                     const std::string& what);

/** Cells, planes and leaves are the same, planes to the last bit. */
void expectSameMap(const terrain::TerrainMap& map, const terrain::TerrainMap& wanted);

/** What holds of planes and leaves, whatever the cells: planes are connected, have enough cells,
 * are in the order of their first cells and the least-squares planes of their cells; leaves are
 * those by definition. */
void expectInvariants(const terrain::TerrainMap& map);

}  // namespace mrpt_mapconv::test
