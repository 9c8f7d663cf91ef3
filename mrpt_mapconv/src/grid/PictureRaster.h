#pragma once

#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/grid/PictureColors.h>
#include <mrpt_mapconv/grid/PlaneColors.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <vector>

namespace mrpt_mapconv::grid::picture
{
/** How cells become pixels: each is enlarged, or several share one. One of the two is 1. */
struct Zoom
{
  int enlarge = 1;  //!< pixels per cell
  int reduce = 1;   //!< cells per pixel

  double pixelsPerCell() const { return static_cast<double>(enlarge) / reduce; }
};
/** At least 800 and, beyond 2400 cells, at most 2400 pixels on the long side. */
Zoom zoomFor(const GridFrame& frame);

/** The mean of the finite cells of a block, ends excluded; NaN if there are none. */
double meanOf(const Layer<float>& layer, int x0, int x1, int y0, int y1);

/** Pixels of a map, the first row the highest y. */
struct Raster
{
  int width = 0, height = 0;
  std::vector<TColor> pixels;
};

/** Colours averages of cells (reduced) or cells. */
Raster rasterOfHeights(const Layer<float>& layer, const ColorRange& range, const Zoom& zoom);
/** Colours the largest of the cells that share a pixel. */
Raster rasterOfSlopes(const Layer<float>& layer, const ColorRange& range, const Zoom& zoom);
/** Of the cells that share a pixel the last look shows, see OccupancyLook. */
Raster rasterOfOccupancy(const StyledLayer& styled, const Zoom& zoom);

/** Of the cells that share a pixel the one with the highest number shows. */
Raster rasterOfEvidence(const Layer<float>& layer, const Zoom& zoom);
/** Of the cells that share a pixel the first one with a plane shows, or else, where there is
 * StyledLayer::shade, their mean height. \param bare the heights' range */
Raster rasterOfPlanes(const StyledLayer& styled, const PlaneColors& colors, const ColorRange& bare,
                      const Zoom& zoom);

}  // namespace mrpt_mapconv::grid::picture
