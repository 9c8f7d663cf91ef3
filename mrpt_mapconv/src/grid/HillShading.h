#pragma once

#include "PictureRaster.h"

namespace mrpt_mapconv::grid::picture
{
/** Darkens the pixels of slopes that turn away from a light in the north-west, 45° above the
 * horizon, and brightens those that face it; level cells keep their colour. Cells without a height,
 * and those beside them, are left as they are.
 * \param raster of the layer, with that zoom */
void shadeHills(const Layer<float>& heights, const Zoom& zoom, Raster& raster);

}  // namespace mrpt_mapconv::grid::picture
