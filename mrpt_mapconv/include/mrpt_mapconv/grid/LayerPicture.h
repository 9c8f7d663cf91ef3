#pragma once

#include <mrpt/img/CImage.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::grid
{
/** What the values of a layer mean, and so how they are coloured. */
enum class PictureKind
{
  Height,     //!< heights; colours span the data without the outermost 0.5 % at either end
  Slope,      //!< slopes; colours span 0 to the data's 98 %
  Occupancy,  //!< 0 free, (0, 1] occupied, else unknown
};

struct PictureStyle
{
  std::string title;
  std::string unit;  //!< of the values, printed at the colour bar; not used for occupancy
  PictureKind kind = PictureKind::Height;
  /** Drawn over the map [m], from a ring to a disc; empty: none. */
  std::vector<mrpt::math::TPoint2D> path = {};
  std::string pathLabel = {};  //!< what the path is, for the legend
};

/** Draws a layer for a person to look at: title, size, map with axes in metres, legend, scale bar.
 *
 * North is up. Small maps are enlarged, cell by cell, to at least 800 pixels on the long side, maps
 * beyond 2400 are reduced: of the cells that share a pixel an occupied one wins, heights are
 * averaged, of slopes the steepest is shown. Where the layer is not finite it is grey ("no data").
 *
 * \param layer at least one cell
 * \param aerial only for Occupancy, on the same frame: occupied cells that are free in this layer
 * are shown as "too steep or too high a step (free for a flying robot)"
 * \exception std::invalid_argument for an empty layer or an aerial layer on another frame */
mrpt::img::CImage drawLayer(const Layer<float>& layer, const PictureStyle& style,
                            const Layer<float>* aerial = nullptr);

/** Draws a layer as drawLayer() does, into a PNG file.
 *
 * \param path must end in ".png"
 * \exception std::invalid_argument as drawLayer(), or for another ending
 * \exception std::runtime_error naming the file and the reason if it cannot be written */
void writeLayerPng(const std::string& path, const Layer<float>& layer, const PictureStyle& style,
                   const Layer<float>* aerial = nullptr);

}  // namespace mrpt_mapconv::grid
