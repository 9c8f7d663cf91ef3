#pragma once

#include <mrpt/img/CImage.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::grid
{
/** A path that is drawn over a layer, from a ring to a disc. */
struct PicturePath
{
  std::vector<mrpt::math::TPoint2D> points = {};  //!< [m]; empty: none
  std::string label = {};                         //!< what the path is, for the legend
};

/** Draws a layer for a person to look at: title, size, map with axes in metres, legend, scale bar.
 *
 * North is up. Small maps are enlarged, cell by cell, to at least 800 pixels on the long side, maps
 * beyond 2400 are reduced: of the cells that share a pixel an occupied one wins, heights are
 * averaged, of slopes the steepest is shown. Colours of heights span the data without the outermost
 * 0.5 % at either end, those of slopes 0 to the data's 98 %. Where such a layer is not finite it is
 * grey ("no data").
 *
 * \param layer at least one cell
 * \param shown the part of the layer that is drawn; without cells: its shownFrame()
 * \exception std::invalid_argument for an empty layer, or a StyledLayer::freeFor on another frame
 */
mrpt::img::CImage drawLayer(const StyledLayer& layer, const PicturePath& path = {},
                            const GridFrame& shown = {});

/** Draws a layer as drawLayer() does, into a PNG file.
 *
 * \param file must end in ".png"
 * \exception std::invalid_argument as drawLayer(), or for another ending
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writeLayerPng(const std::string& file, const StyledLayer& layer, const PicturePath& path = {},
                   const GridFrame& shown = {});

/** For a PNG that MRPT has written, which does not say whether it could.
 * \exception std::runtime_error naming the file and the system's reason, unless it is complete */
void requireCompletePng(const std::string& file);

}  // namespace mrpt_mapconv::grid
