#include <cmath>
#include <limits>

#include "DiscOpening.h"
#include "EmptyCells.h"
#include "GroundSurface.h"
#include "LowestPoints.h"

namespace mrpt_mapconv::aerial
{
using grid::Layer;

namespace
{
constexpr double kPitSlope = 5;  // of cells that are too low [m/m], as published

void forget(Layer<float>& heights, const std::vector<bool>& cells)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i]) heights.cells()[i] = std::numeric_limits<float>::quiet_NaN();
}

/** Marks the cells that `after` has lower than `before` by more than a height [m]. */
void markLowered(const Layer<float>& before, const Layer<float>& after, double height,
                 std::vector<bool>& cells)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (before.cells()[i] - after.cells()[i] > height) cells[i] = true;
}

/** Marks single cells that lie far below those around: objects on the surface turned over. */
void markPits(const Layer<float>& surface, int threads, std::vector<bool>& cells)
{
  Layer<float> turned = surface;
  for (float& z : turned.cells()) z = -z;
  markLowered(turned, openWithDisc(turned, 1, threads), kPitSlope * surface.frame().resolution,
              cells);
}

void markObjects(Layer<float> surface, const GroundParams& params, int threads,
                 std::vector<bool>& cells)
{
  const auto largest =
      static_cast<std::int32_t>(std::ceil(params.smrfWindow / params.smrfCell - 1e-9));
  for (std::int32_t radius = 1; radius <= largest; ++radius)
  {
    Layer<float> opened = openWithDisc(surface, radius, threads);
    markLowered(surface, opened, params.smrfSlope * radius * params.smrfCell, cells);
    surface = std::move(opened);
  }
}

}  // namespace

GroundSurface morphologicalGround(const cloud::PointCloud& cloud, const UsedPoints& used,
                                  const GroundParams& params, int threads)
{
  const grid::GridFrame frame = frameAround(cloud, used, {params.smrfCell, "smrfCell", kCentred});
  Layer<float> ground = heightsOfCells(cloud, used, frame);
  Layer<float> surface = ground;
  fillEmptyCells(surface, threads);
  std::vector<bool> others(frame.size());
  markPits(surface, threads, others);
  forget(surface, others);
  fillEmptyCells(surface, threads);
  markObjects(surface, params, threads, others);
  forget(ground, others);
  fillEmptyCells(ground, threads);

  Layer<float> tolerance = slopeOf(ground, 1);
  for (float& cell : tolerance.cells())
    cell = static_cast<float>(params.smrfThreshold + params.smrfScale * cell);
  return {std::move(ground), std::move(tolerance)};
}

}  // namespace mrpt_mapconv::aerial
