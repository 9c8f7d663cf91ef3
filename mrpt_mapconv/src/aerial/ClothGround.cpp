#include <cmath>
#include <utility>

#include "Cloth.h"
#include "EmptyCells.h"
#include "GroundSurface.h"
#include "LowestPoints.h"
#include "SlopeSmoothing.h"

namespace mrpt_mapconv::aerial
{
namespace
{
constexpr std::int32_t kMargin = 2;  // of cloth beyond the cloud, as published [particles]

grid::Layer<float> toleranceOf(const grid::Layer<float>& ground, const GroundParams& params)
{
  constexpr double kSlopeReach = 2;  // [m]; what is smaller is no slope but something on it
  const auto reach = static_cast<std::int32_t>(std::ceil(kSlopeReach / ground.frame().resolution));
  grid::Layer<float> tolerance = slopeOf(ground, reach);
  for (float& cell : tolerance.cells())
    cell = static_cast<float>(params.heightThreshold + params.heightScale * cell);
  return tolerance;
}
}  // namespace

GroundSurface clothGround(const cloud::PointCloud& cloud, const UsedPoints& used,
                          const GroundParams& params, int threads)
{
  const grid::GridFrame frame =
      frameAround(cloud, used, {params.clothResolution, "clothResolution", kCentred, kMargin});
  const grid::Layer<float> measured = heightsOfCells(cloud, used, frame, params.collision);
  grid::Layer<float> surface = measured;
  fillEmptyCells(surface, threads);

  Cloth cloth(surface, params, threads);
  bool hasSettled = cloth.settle() < params.maxIterations;
  if (params.slopeSmoothing)
  {
    drawOn(cloth, measured, params, threads);
    hasSettled = cloth.settle() < params.maxIterations;
  }
  grid::Layer<float> ground = cloth.heights();
  grid::Layer<float> tolerance = toleranceOf(ground, params);
  return {std::move(ground), std::move(tolerance), hasSettled};
}

}  // namespace mrpt_mapconv::aerial
