#pragma once

#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/grid/StyledLayer.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>

#include <functional>
#include <string>
#include <vector>

namespace mrpt_mapconv::terrain
{
/** All layers in the order of export: height, sigma, plane, leafSide, slope, traversability. */
std::vector<grid::StyledLayer> styled(const TerrainLayers& layers);
/** The picture that explains the method: leaves with outlines, coloured by their planes; cells
 * without a plane in greys. */
grid::StyledLayer styledLeaves(const TerrainLayers& layers);

/** Planes as a table with a header: index, cells, middle, tilt, rms, extent; in m and m/m. */
std::string planesCsv(const std::vector<TerrainPlane>& planes);
/** Steps likewise. */
std::string stepsCsv(const std::vector<TerrainStep>& steps);

/** Writes layers as grid::exportLayers() does, with parameters as metadata of the GeoTIFF, and
 * PREFIXleaves.png (with pictures), PREFIXplanes.csv and PREFIXsteps.csv.
 * \param layers of the map, on a frame with at least one cell */
void exportTerrain(files::OutputDir& out, const TerrainMap& map, const TerrainLayers& layers,
                   grid::ExportFormats formats, const std::function<void(double)>& progress = {});

}  // namespace mrpt_mapconv::terrain
