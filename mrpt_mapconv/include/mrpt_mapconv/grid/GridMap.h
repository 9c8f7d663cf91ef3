#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>

namespace mrpt_mapconv::grid
{
/** Checks that MRPT's grids, which keep their limits as floats, can hold a frame.
 * \exception std::runtime_error if they would round it to another one (a map very far from the
 * origin, an odd resolution) */
void checkGridMapFrame(const GridFrame& frame);

/** Copies an occupancy layer into an MRPT grid map of the same frame, replacing what it holds;
 * cell values as in rawGridCell(). Of a shifted frame the grid has the limits, too; whatever sets
 * its size anew puts them on multiples of the resolution.
 *
 * \param occupancy 0 free, (0, 1] occupied, else unknown; at least one cell
 * \exception std::invalid_argument for an empty layer
 * \exception std::runtime_error if MRPT, which keeps the limits as floats, would round the frame to
 * another one (a map very far from the origin) */
void copyToGridMap(const Layer<float>& occupancy, mrpt::maps::COccupancyGridMap2D& map);

/** Writes an occupancy layer as a `.gridmap` file, a compressed, serialized
 * mrpt::maps::COccupancyGridMap2D, as MRPT's programs read it (without this library's plugin).
 * They put a grid's limits on multiples of its resolution: of a frame that is shifted by half a
 * cell, each cell is written as 2 x 2 of half the size.
 *
 * \exception std::invalid_argument, std::runtime_error as copyToGridMap()
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writeGridMap(const std::string& path, const Layer<float>& occupancy);

}  // namespace mrpt_mapconv::grid
