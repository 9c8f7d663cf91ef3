#pragma once

#include <mrpt_mapconv/grid/StyledLayer.h>

#include <vector>

#include "PictureLegend.h"
#include "PictureRaster.h"

namespace mrpt_mapconv::grid::picture
{
/** How a layer of LayerKind::Plane looks. */
struct PlanePicture
{
  Raster raster;
  std::vector<LegendItem> legend;
  bool noData = false;
};

/** Of the cells that share a pixel the first one with a plane shows. Squares that are at least
 * four pixels wide have outlines. */
PlanePicture drawPlanes(const StyledLayer& styled, const Zoom& zoom, const Metrics& metrics);

}  // namespace mrpt_mapconv::grid::picture
