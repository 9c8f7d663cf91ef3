#include "GroundMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "GroundSurface.h"

namespace mrpt_mapconv::aerial
{
using grid::Layer;
using grid::LayerKind;

namespace
{
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kMeasured = 1;  // of LayerKind::Evidence: seen

void countPoints(const cloud::PointCloud& cloud, const UsedPoints& used,
                 const std::vector<std::uint8_t>& classification, GroundLayers& layers)
{
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i]) continue;
    const std::size_t cell = cellAt(layers.ground.frame(), cloud.x[i], cloud.y[i]);
    const auto z = static_cast<float>(cloud.z[i]);
    float& highest = layers.surface.cells()[cell];
    if (!(highest >= z)) highest = z;  // also if there is none
    ++layers.allPoints.cells()[cell];
    if (classification[i] != cloud::kGround) continue;
    float& lowest = layers.ground.cells()[cell];
    if (!(lowest <= z)) lowest = z;
    ++layers.groundPoints.cells()[cell];
  }
}

/** Gives cells without a ground point the height of the filter's surface at their centre. */
void fillGround(const Layer<float>& filterSurface, GroundLayers& layers)
{
  const grid::GridFrame& frame = layers.ground.frame();
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const bool isMeasured = layers.groundPoints.at(x, y) > 0;
      layers.evidence.at(x, y) = isMeasured ? kMeasured : grid::kInferredGround;
      if (!isMeasured)
        layers.ground.at(x, y) =
            interpolate(filterSurface, frame.centreOf(frame.x0 + x), frame.centreOf(frame.y0 + y));
    }
}
}  // namespace

GroundLayers mapGround(const cloud::PointCloud& cloud, const UsedPoints& used,
                       const std::vector<std::uint8_t>& classification,
                       const Layer<float>& filterSurface, const grid::GridFrame& frame)
{
  const Layer<float> unknown(frame, kNone), zero(frame, 0);
  GroundLayers layers{unknown, zero, unknown, unknown, zero, zero};
  countPoints(cloud, used, classification, layers);
  fillGround(filterSurface, layers);
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (const float surface = layers.surface.cells()[i]; !std::isnan(surface))
      layers.aboveGround.cells()[i] = std::max(surface - layers.ground.cells()[i], 0.0F);
  return layers;
}

std::vector<grid::StyledLayer> styled(const GroundLayers& layers)
{
  std::vector<grid::StyledLayer> all{
      {"ground", &layers.ground, "Ground", "m", LayerKind::Height},
      {"evidence", &layers.evidence, "Ground: measured, or inferred", "", LayerKind::Evidence},
      {"surface", &layers.surface, "Surface: highest point", "m", LayerKind::Height},
      {"aboveGround", &layers.aboveGround, "Height above ground", "m", LayerKind::Slope},
      {"groundPoints", &layers.groundPoints, "Ground points in a cell", "points", LayerKind::Slope},
      {"allPoints", &layers.allPoints, "Points in a cell", "points", LayerKind::Slope}};
  for (auto& layer : all) layer.hillShaded = layer.name == "ground" || layer.name == "surface";
  return all;
}

}  // namespace mrpt_mapconv::aerial
