#pragma once

#include <mrpt_mapconv/cloud/PointCloud.h>
#include <mrpt_mapconv/grid/Layer.h>
#include <mrpt_mapconv/sim/Scenario.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mrpt_mapconv::eval
{
/** A cloud whose ground is known. */
struct LabelledCloud
{
  cloud::PointCloud cloud;
  std::vector<std::uint8_t> truth;  //!< of each point kGround or kUnclassified

  std::size_t groundPoints() const;
};

/** What the 3D sensors of a scenario see on its way, at the robot's true poses. Ground points are
 * those that a body returned which is ground (sim::Primitive::isGround()).
 * \param every how manyth scan is taken, ≥ 1 \param progress told the share that is done; may be
 * empty */
LabelledCloud simulateCloud(const sim::Scenario& scenario, std::uint64_t seed, int every = 1,
                            const std::function<void(double)>& progress = {});

/** A cloud in a file, and its ground points in another one, as the samples of the ISPRS comparison
 * of ground filters are (Sithole and Vosselman 2004): a point is ground if the other file has one
 * with just its coordinates.
 * \exception std::runtime_error naming the file if one cannot be read */
LabelledCloud readLabelledCloud(const std::string& file, const std::string& groundFile);

/** Height of a world's ground at the centres of cells [m]; NaN where there is none. */
grid::Layer<float> trueGround(const sim::World& world, const grid::GridFrame& frame);

}  // namespace mrpt_mapconv::eval
