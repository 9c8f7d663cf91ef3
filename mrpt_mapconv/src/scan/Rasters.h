#pragma once

#include <mrpt_mapconv/scan/CellBits.h>

namespace mrpt_mapconv::scan
{
/** What is known of the cells in a square around the sensor. Lines go along the rows: those that go
 * along columns use a second set of rasters, in which x and y are exchanged. */
struct Rasters
{
  CellBits object, wall;    //!< the cells O and W
  CellBits any;             //!< the cells of either
  CellBits occupied, free;  //!< what the lines say; the free ones with object cells among them

  void reset(const grid::GridFrame& square);
  /** Makes `any` of the other two. */
  void findAny();
  /** Adds what the lines along columns say. */
  void mergeTransposed(const Rasters& columns);
};

}  // namespace mrpt_mapconv::scan
