#include <mrpt/opengl/CMesh.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/PictureColors.h>

#include <algorithm>
#include <cmath>

namespace mrpt_mapconv::grid
{
namespace
{
float lowest(const Layer<float>& layer)
{
  float low = INFINITY;
  for (const float value : layer.cells())
    if (value < low) low = value;
  return std::isfinite(low) ? low : 0.0f;
}

/** The surface's colours, as in the layers' pictures. MRPT's mesh has x along the rows of its
 * matrices and of its texture. */
mrpt::img::CImage texture(const StyledLayer& styled)
{
  const Layer<float>& values = *styled.layer;
  const bool slopes = styled.kind == LayerKind::Slope;
  const auto range = slopes ? picture::slopeRange(values) : picture::heightRange(values);
  const GridFrame& frame = values.frame();
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
mrpt::opengl::CMesh::Ptr surface(const Layer<float>& height, const StyledLayer& colouredBy)
{
  const GridFrame& frame = height.frame();
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
  mesh->assignImageAndZ(texture(colouredBy), z);
  mesh->setMask(mask);
  return mesh;
}
}  // namespace

void drawSurface(const StyledLayer& height, const StyledLayer& colouredBy,
                 mrpt::opengl::CSetOfObjects& scene)
{
  const GridFrame& frame = height.layer->frame();
  if (frame.width < 2 || frame.height < 2) return;  // no surface
  auto mesh = surface(*height.layer, colouredBy);
  mesh->setName(height.name);
  scene.insert(mesh);
}

double heightBelow(const Layer<float>& height)
{
  return lowest(height) - height.frame().resolution;
}

void drawOccupancy(const Layer<float>& occupancy, double z, bool showFree,
                   mrpt::opengl::CSetOfObjects& scene)
{
  Layer<float> shown = occupancy;
  if (!showFree) std::replace(shown.cells().begin(), shown.cells().end(), kFree, kUnknown);
  mrpt::maps::COccupancyGridMap2D map;
  copyToGridMap(shown, map);
  auto plane = mrpt::opengl::CSetOfObjects::Create();
  map.getVisualizationInto(*plane);
  plane->setLocation(0, 0, z);
  plane->setName("occupancy");
  scene.insert(plane);
}

void drawLayers(const std::vector<StyledLayer>& layers, const Layer<float>& occupancy,
                mrpt::opengl::CSetOfObjects& scene)
{
  double below = 0;
  bool isCovered = false;
  for (const StyledLayer& layer : layers)
  {
    if (layer.kind != LayerKind::Height) continue;
    drawSurface(layer, layer, scene);
    below = isCovered ? std::min(below, heightBelow(*layer.layer)) : heightBelow(*layer.layer);
    isCovered = true;
  }
  drawOccupancy(occupancy, below, !isCovered, scene);
}

}  // namespace mrpt_mapconv::grid
