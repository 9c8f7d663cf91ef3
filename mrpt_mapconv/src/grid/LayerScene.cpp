#include <mrpt/opengl/CMesh.h>
#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/PictureColors.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "OccupancyLook.h"

namespace mrpt_mapconv::grid
{
namespace
{
using picture::OccupancyLook;
using picture::TColor;

float lowest(const Layer<float>& layer)
{
  float low = INFINITY;
  for (const float value : layer.cells())
    if (value < low) low = value;
  return std::isfinite(low) ? low : 0.0f;
}

/** The looks of an occupancy layer that a surface shows instead of its height. */
constexpr OccupancyLook kMarked[] = {OccupancyLook::Steep, OccupancyLook::Drop,
                                     OccupancyLook::Frontier};
/** How much of white is in the colours of heights that are inferred. */
constexpr double kTint = 0.6;

TColor tinted(const TColor& color)
{
  const auto mix = [](std::uint8_t c) { return static_cast<std::uint8_t>(c + kTint * (255 - c)); };
  return {mix(color.R), mix(color.G), mix(color.B)};
}

/** The colour of each cell of a surface, as in the layers' pictures. */
class SurfaceColors
{
 public:
  SurfaceColors(const Layer<float>& height, const StyledLayer& colouredBy)
      : m_by(colouredBy),
        m_values(colouredBy.kind == LayerKind::Occupancy ? height : *colouredBy.layer),
        m_range(colouredBy.kind == LayerKind::Slope ? picture::slopeRange(m_values)
                                                    : picture::heightRange(m_values))
  {
  }

  TColor at(std::int32_t x, std::int32_t y) const
  {
    const float value = m_values.at(x, y);
    if (!std::isfinite(value)) return picture::kNoDataColor;
    const double position = m_range.position(static_cast<double>(value));
    if (m_by.kind == LayerKind::Slope) return picture::slopeColor(position);
    const TColor ofHeight = picture::heightColor(position);
    if (m_by.kind != LayerKind::Occupancy) return ofHeight;
    const OccupancyLook look = picture::lookOf(m_by, x, y);
    if (std::count(std::begin(kMarked), std::end(kMarked), look) > 0) return colorOf(look);
    return look == OccupancyLook::Inferred ? tinted(ofHeight) : ofHeight;
  }

 private:
  const StyledLayer& m_by;
  const Layer<float>& m_values;
  picture::ColorRange m_range;
};

/** MRPT's mesh has x along the rows of its matrices and of its texture. */
mrpt::img::CImage texture(const Layer<float>& height, const StyledLayer& colouredBy)
{
  const SurfaceColors colors(height, colouredBy);
  const GridFrame& frame = height.frame();
  mrpt::img::CImage image(frame.height, frame.width, mrpt::img::CH_RGB);
  for (std::int32_t y = 0; y < frame.height; ++y)
    for (std::int32_t x = 0; x < frame.width; ++x) image.setPixel(y, x, colors.at(x, y));
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
  mesh->assignImageAndZ(texture(height, colouredBy), z);
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

void drawLegend(const StyledLayer& occupancy, mrpt::opengl::COpenGLViewport& view)
{
  constexpr int kMargin = 10, kLine = 20;  // pixels
  mrpt::opengl::TFontParams font;
  font.vfont_scale = 14;
  font.draw_shadow = true;
  std::size_t lines = 0;
  const auto add = [&](OccupancyLook look, const TColor& color, const std::string& meaning)
  {
    if (!picture::hasLook(occupancy, look)) return;
    font.color = mrpt::img::TColorf(color);
    view.addTextMessage(kMargin, kMargin + kLine * static_cast<double>(lines), meaning, lines,
                        font);
    ++lines;
  };
  for (const OccupancyLook look : kMarked) add(look, colorOf(look), meaningOf(look));
  add(OccupancyLook::Inferred, tinted(picture::heightColor(0)),
      "pale: ground inferred from what was seen around");
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
