#include <mrpt/opengl/CMesh.h>
#include <mrpt_mapconv/freespace/LayerScene.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/PictureColors.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::freespace
{
namespace
{
float lowest(const grid::Layer<float>& layer)
{
  float low = INFINITY;
  for (const float value : layer.cells())
    if (value < low) low = value;
  return std::isfinite(low) ? low : 0.0f;
}

/** The surface's colours, as in the layers' pictures. MRPT's mesh has x along the rows of its
 * matrices and of its texture. */
mrpt::img::CImage texture(const grid::Layer<float>& values, bool slopes)
{
  namespace picture = grid::picture;
  const auto range = slopes ? picture::slopeRange(values) : picture::heightRange(values);
  const grid::GridFrame& frame = values.frame();
  mrpt::img::CImage image(frame.height, frame.width, mrpt::img::CH_RGB);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const float value = values.at(x, y);
      if (!std::isfinite(value))
        image.setPixel(y, x, picture::kNoDataColor);
      else if (slopes)
        image.setPixel(y, x, picture::slopeColor(range.position(value)));
      else
        image.setPixel(y, x, picture::heightColor(range.position(value)));
    }
  return image;
}

/** A surface through the cells' centres; cells without a height leave a hole. */
mrpt::opengl::CMesh::Ptr surface(const grid::Layer<float>& height,
                                 const grid::Layer<float>& colouredBy, bool slopes)
{
  const grid::GridFrame& frame = height.frame();
  const float filler = lowest(height);
  mrpt::math::CMatrixF z(frame.width, frame.height), mask(frame.width, frame.height);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x)
    {
      const float value = height.at(x, y);
      mask(x, y) = std::isfinite(value) ? 1.0f : 0.0f;
      z(x, y) = std::isfinite(value) ? value : filler;
    }
  auto mesh = mrpt::opengl::CMesh::Create();
  const auto half = 0.5 * frame.resolution;
  mesh->setXBounds(static_cast<float>(frame.xMin() + half),
                   static_cast<float>(frame.xMax() - half));
  mesh->setYBounds(static_cast<float>(frame.yMin() + half),
                   static_cast<float>(frame.yMax() - half));
  mesh->assignImageAndZ(texture(colouredBy, slopes), z);
  mesh->setMask(mask);
  return mesh;
}
}  // namespace

double heightBelow(const freespace::Layers& layers)
{
  return lowest(layers.floor) - layers.frame().resolution;
}

void drawLayers(const freespace::Layers& layers, const TLayerSceneOptions& options,
                mrpt::opengl::CSetOfObjects& scene)
{
  if (layers.frame().width < 2 || layers.frame().height < 2) return;  // no surface
  if (options.showFloor)
  {
    auto floor = options.colorBySlope ? surface(layers.floor, layers.slope, true)
                                      : surface(layers.floor, layers.floor, false);
    floor->setName("floor");
    scene.insert(floor);
  }
  if (options.showCeiling)
  {
    auto ceiling = surface(layers.ceiling, layers.ceiling, false);
    ceiling->setName("ceiling");
    scene.insert(ceiling);
  }
}

void drawOccupancy(const grid::Layer<float>& occupancy, double z, bool showFree,
                   mrpt::opengl::CSetOfObjects& scene)
{
  grid::Layer<float> shown = occupancy;
  if (!showFree)
    std::replace(shown.cells().begin(), shown.cells().end(), grid::kFree, grid::kUnknown);
  mrpt::maps::COccupancyGridMap2D map;
  grid::copyToGridMap(shown, map);
  auto plane = mrpt::opengl::CSetOfObjects::Create();
  map.getVisualizationInto(*plane);
  plane->setLocation(0, 0, z);
  plane->setName("occupancy");
  scene.insert(plane);
}

}  // namespace mrpt_mapconv::freespace
