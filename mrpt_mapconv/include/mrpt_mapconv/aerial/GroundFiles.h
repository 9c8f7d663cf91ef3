#pragma once

#include <mrpt_mapconv/aerial/Ground.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/LayerExport.h>

#include <functional>

namespace mrpt_mapconv::aerial
{
/** Writes the layers of a ground as grid::exportLayers() does, with the parameters as metadata of
 * the GeoTIFF. */
void exportGround(files::OutputDir& out, const GroundLayers& layers, const GroundParams& params,
                  grid::ExportFormats formats, const std::function<void(double)>& progress = {});

}  // namespace mrpt_mapconv::aerial
