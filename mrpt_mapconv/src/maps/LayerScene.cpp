#include <mrpt/img/color_maps.h>
#include <mrpt/opengl/CMesh.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/maps/LayerScene.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::maps
{
namespace
{
struct Range
{
  float min = 0, max = 0;
};

Range rangeOf(const grid::Layer<float>& layer)
{
  Range range{INFINITY, -INFINITY};
  for (const float value : layer.cells())
    if (std::isfinite(value)) range = {std::min(range.min, value), std::max(range.max, value)};
  return range.min <= range.max ? range : Range{};
}

/** A texture of the surface's slopes: steep is red. */
mrpt::img::CImage slopeTexture(const grid::Layer<float>& slope)
{
  constexpr float steepest = 2;  // R_MS in the paper's Table I
  const grid::GridFrame& frame = slope.frame();
  mrpt::img::CImage image(frame.width, frame.height, mrpt::img::CH_RGB);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const float value = slope.at(x, y);
      const auto color = mrpt::img::colormap(
          mrpt::img::cmJET, std::isfinite(value) ? std::min(value / steepest, 1.0f) : 0.0f);
      image.setPixel(x, y, mrpt::img::TColor(color));
    }
  return image;
}

/** A surface through the cells' centres; cells without a height leave a hole. */
mrpt::opengl::CMesh::Ptr surface(const grid::Layer<float>& height, const grid::Layer<float>* slope)
{
  const grid::GridFrame& frame = height.frame();
  const float lowest = rangeOf(height).min;
  // MRPT's mesh has x along the rows of its matrices
  mrpt::math::CMatrixF z(frame.width, frame.height), mask(frame.width, frame.height);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const float value = height.at(x, y);
      mask(x, y) = std::isfinite(value) ? 1.0f : 0.0f;
      z(x, y) = std::isfinite(value) ? value : lowest;
    }
  auto mesh = mrpt::opengl::CMesh::Create();
  const auto half = 0.5 * frame.resolution;
  mesh->setXBounds(static_cast<float>(frame.xMin() + half),
                   static_cast<float>(frame.xMax() - half));
  mesh->setYBounds(static_cast<float>(frame.yMin() + half),
                   static_cast<float>(frame.yMax() - half));
  if (slope)
    mesh->assignImageAndZ(slopeTexture(*slope), z);
  else
  {
    mesh->setZ(z);
    mesh->enableColorFromZ(true, mrpt::img::cmJET);
  }
  mesh->setMask(mask);
  return mesh;
}
}  // namespace

double heightBelow(const freespace::Layers& layers)
{
  return rangeOf(layers.floor).min - layers.frame().resolution;
}

void drawLayers(const freespace::Layers& layers, const TLayerSceneOptions& options,
                mrpt::opengl::CSetOfObjects& scene)
{
  if (layers.frame().width < 2 || layers.frame().height < 2) return;  // no surface
  if (options.showFloor)
  {
    auto floor = surface(layers.floor, options.colorBySlope ? &layers.slope : nullptr);
    floor->setName("floor");
    scene.insert(floor);
  }
  if (options.showCeiling)
  {
    auto ceiling = surface(layers.ceiling, nullptr);
    ceiling->setName("ceiling");
    scene.insert(ceiling);
  }
}

void drawOccupancy(const grid::Layer<float>& occupancy, double z,
                   mrpt::opengl::CSetOfObjects& scene)
{
  mrpt::maps::COccupancyGridMap2D map;
  grid::copyToGridMap(occupancy, map);
  auto plane = mrpt::opengl::CSetOfObjects::Create();
  map.getVisualizationInto(*plane);
  plane->setLocation(0, 0, z);
  plane->setName("occupancy");
  scene.insert(plane);
}

}  // namespace mrpt_mapconv::maps
