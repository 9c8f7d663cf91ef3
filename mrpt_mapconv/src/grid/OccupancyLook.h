#pragma once

#include <mrpt_mapconv/grid/PictureColors.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

namespace mrpt_mapconv::grid::picture
{
/** How a cell of an occupancy layer looks; of the cells that share a pixel the last one shows, so
 * that what warns is not lost in large maps.
 * Without StyledLayer::freeFor there are only occupied, free and unknown. */
enum class OccupancyLook
{
  Unknown,
  Free,
  Inferred,
  Frontier,
  Steep,
  Occupied,
  Drop
};

OccupancyLook lookOf(const StyledLayer& occupancy, std::int32_t x, std::int32_t y);
/** Whether any cell looks like that. */
bool hasLook(const StyledLayer& occupancy, OccupancyLook look);
const TColor& colorOf(OccupancyLook look);
/** For a legend. */
const char* meaningOf(OccupancyLook look);

}  // namespace mrpt_mapconv::grid::picture
