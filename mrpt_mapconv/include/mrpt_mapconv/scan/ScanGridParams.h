#pragma once

#include <mrpt_mapconv/grid/Resolution.h>
#include <mrpt_mapconv/params/Fields.h>

namespace mrpt_mapconv::scan
{
/** How a grid that scans are inserted into begins, and how large it may become. */
struct ScanGridParams
{
  double resolution = 0.05;   //!< size of a cell [m]
  double maxGridCells = 4e8;  //!< a scan that would make the grid larger is refused

  template <class S, class V>
  static void visit(S& p, V&& v)
  {
    v("resolution", p.resolution, "m", "size of a cell", params::flag("M"));
    v("maxGridCells", p.maxGridCells, "cells",
      "a scan that would make the grid larger is an error");
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const
  {
    grid::requireResolution(resolution);
    params::require(maxGridCells >= 1, "maxGridCells", maxGridCells, ">= 1");
  }
};

}  // namespace mrpt_mapconv::scan
