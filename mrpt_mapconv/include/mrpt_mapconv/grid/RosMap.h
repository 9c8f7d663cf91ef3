#pragma once

#include <mrpt_mapconv/grid/GeoReference.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>

namespace mrpt_mapconv::grid
{
/** Writes an occupancy layer as ROS' map_server and nav2 read maps: an image (PGM, P5) and a YAML.
 *
 * Pixels: 0 occupied, 254 free, 205 unknown; the first row is the highest y. The thresholds in the
 * YAML (trinary mode) tell these three apart. Resolution and origin (the lower left corner, in
 * metres of the map frame, to which the reference's origin is added) are printed so that reading
 * gives the same doubles.
 *
 * \param occupancy 0 free, (0, 1] occupied, else unknown; at least one cell
 * \param imageName how the YAML names the image, relative to itself
 * \exception std::invalid_argument for an empty layer
 * \exception std::runtime_error naming the file and the reason if one cannot be written */
void writeRosMap(const std::string& pgmPath, const std::string& yamlPath,
                 const std::string& imageName, const Layer<float>& occupancy,
                 const GeoReference& reference = {});

}  // namespace mrpt_mapconv::grid
