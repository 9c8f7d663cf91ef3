#pragma once

#include <mrpt_mapconv/aerial/GroundParams.h>
#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mrpt_mapconv::aerial
{
/** The map of a ground, on one frame around all points that were used. Heights are those of the
 * cloud, less its origin [m]. */
struct GroundLayers
{
  /** The lowest ground point of the cell; without one, the height at its centre between those that
   * are nearest of the filter's surface: four particles of the cloth, or four cells of smrf. */
  grid::Layer<float> ground;
  grid::Layer<float> evidence;     //!< 1: a ground point was measured, 2: none was
  grid::Layer<float> surface;      //!< the highest point; NaN: the cell has none
  grid::Layer<float> aboveGround;  //!< surface less ground, at least 0 [m]; NaN likewise
  grid::Layer<float> groundPoints, allPoints;  //!< how many the cell has
};

/** The ground below a cloud. */
struct Ground
{
  /** For each point kGround or kUnclassified; the latter also for those that were not used, but
   * noise (classes 7 and 18) keeps its class. */
  std::vector<std::uint8_t> classification;
  GroundLayers layers;
  double filterResolution = 0;  //!< between the cloth's particles, or smrf's cells [m]
  double pointDistance = 0;     //!< of used points, on average [m]
  bool hasSettled = true;       //!< false: maxIterations ended before the cloth rested
  std::size_t groundPoints = 0;
  std::size_t unusedPoints = 0;  //!< withheld, noise, or without finite coordinates
  std::size_t lowPoints = 0;     //!< too low to be ground, see GroundParams::lowPointRadius
};

/** Finds the ground points of a cloud and makes the map of it. The same for any number of threads
 * (0 = all cores).
 * \exception std::invalid_argument for invalid parameters
 * \exception std::runtime_error in one line if no point can be used, or the cloud is so wide that
 * there would be too many cells */
Ground findGround(const cloud::PointCloud& cloud, const GroundParams& params, int threads = 0);

/** The layers, with what files and pictures say about them. */
std::vector<grid::StyledLayer> styled(const GroundLayers& layers);

}  // namespace mrpt_mapconv::aerial
