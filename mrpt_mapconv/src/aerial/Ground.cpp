#include <mrpt_mapconv/aerial/Ground.h>

#include <algorithm>

#include "../grid/Parallel.h"
#include "GroundMap.h"
#include "GroundSurface.h"
#include "LowPoints.h"

namespace mrpt_mapconv::aerial
{
namespace
{
std::size_t countOf(const std::vector<std::uint8_t>& values, std::uint8_t value)
{
  return static_cast<std::size_t>(std::count(values.begin(), values.end(), value));
}

/** Points that lie below the surface are ground, too. Noise keeps its class. */
std::vector<std::uint8_t> classify(const cloud::PointCloud& cloud, const UsedPoints& used,
                                   const GroundSurface& surface, int threads)
{
  std::vector<std::uint8_t> classes(cloud.size(), cloud::kUnclassified);
  grid::inParallel(cloud.size(), threads,
                   [&](std::size_t begin, std::size_t end)
                   {
                     for (std::size_t i = begin; i < end; ++i)
                     {
                       if (isNoise(cloud, i)) classes[i] = cloud.classification[i];
                       if (!used[i]) continue;
                       const double x = cloud.x[i], y = cloud.y[i];
                       const float above =
                           static_cast<float>(cloud.z[i]) - interpolate(surface.height, x, y);
                       if (above <= interpolate(surface.tolerance, x, y))
                         classes[i] = cloud::kGround;
                     }
                   });
  return classes;
}
}  // namespace

Ground findGround(const cloud::PointCloud& cloud, const GroundParams& params, int threads)
{
  params.check();
  const UsedPoints usable = usablePoints(cloud);
  const grid::GridFrame frame = frameAround(cloud, usable, {params.cellSize, "cellSize"});
  UsedPoints used = usable;
  leaveOutLowPoints(cloud, params, threads, used);
  const GroundSurface surface = params.groundFilter == GroundFilter::Csf
                                    ? clothGround(cloud, used, params, threads)
                                    : morphologicalGround(cloud, used, params, threads);
  Ground ground;
  ground.classification = classify(cloud, used, surface, threads);
  ground.layers = mapGround(cloud, used, ground.classification, surface.height, frame);
  ground.filterResolution = surface.height.frame().resolution;
  ground.pointDistance = meanDistance(cloud, used);
  ground.hasSettled = surface.hasSettled;
  ground.groundPoints = countOf(ground.classification, cloud::kGround);
  ground.unusedPoints = countOf(usable, 0);
  ground.lowPoints = countOf(used, 0) - ground.unusedPoints;
  return ground;
}

}  // namespace mrpt_mapconv::aerial
