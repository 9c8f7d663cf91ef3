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
}

GroundSurface clothGround(const cloud::PointCloud& cloud, const UsedPoints& used,
                          const GroundParams& params, int threads)
{
  const grid::GridFrame frame =
      frameAround(cloud, used, {params.clothResolution, "clothResolution", kCentred, kMargin});
  const grid::Layer<float> measured = heightsOfCells(cloud, used, frame, params.collision);
  grid::Layer<float> surface = measured;
  fillEmptyCells(surface, threads);

  Cloth cloth(surface, params, threads);
  cloth.settle();
  if (params.slopeSmoothing)
  {
    drawOn(cloth, measured, params, threads);
    cloth.settle();
  }
  return {cloth.heights(), {frame, static_cast<float>(params.heightThreshold)}};
}

}  // namespace mrpt_mapconv::aerial
