#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/OccupancyCell.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "HillShading.h"
#include "OccupancyLook.h"
#include "PictureAxes.h"
#include "PictureLegend.h"
#include "PictureRaster.h"
#include "PlanePicture.h"

namespace mrpt_mapconv::grid
{
namespace
{
using namespace picture;

/** The map's pixels and what explains them. */
struct Content
{
  Raster raster;
  std::vector<LegendItem> legend;
  bool noData = false;
};

void addRange(Content& content, const Metrics& metrics, const ColorRange& range,
              const std::string& unit, TColor (*colorOf)(double))
{
  content.noData = range.empty;
  if (!range.empty) content.legend.push_back(colorBar(metrics, range, unit, colorOf));
  content.legend.push_back(swatch(metrics, kNoDataColor, "no data"));
  if (range.clippedLow() || range.clippedHigh())
    content.legend.push_back(note(metrics, "colours leave out the outermost values; values from " +
                                               number(range.dataMin, 2) + " to " +
                                               number(range.dataMax, 2) + " " + unit));
}

Content heightContent(const StyledLayer& styled, const Zoom& zoom, const Metrics& metrics)
{
  const Layer<float>& layer = *styled.layer;
  const ColorRange range = heightRange(layer);
  Content content;
  content.raster = rasterOfHeights(layer, range, zoom);
  addRange(content, metrics, range, styled.unit, heightColor);
  if (styled.hillShaded && !range.empty)
  {
    shadeHills(layer, zoom, content.raster);
    content.legend.push_back(note(metrics, "slopes are shaded as by light from the north-west"));
  }
  return content;
}

Content slopeContent(const Layer<float>& layer, const std::string& unit, const Zoom& zoom,
                     const Metrics& metrics)
{
  const ColorRange range = slopeRange(layer);
  Content content;
  content.raster = rasterOfSlopes(layer, range, zoom);
  addRange(content, metrics, range, unit, slopeColor);
  return content;
}

Content occupancyContent(const StyledLayer& styled, const Zoom& zoom, const Metrics& metrics)
{
  const auto& cells = styled.layer->cells();
  Content content;
  content.raster = rasterOfOccupancy(styled, zoom);
  content.noData = std::none_of(cells.begin(), cells.end(),
                                [](float value) { return isFree(value) || isOccupied(value); });
  using Look = OccupancyLook;
  const auto add = [&](Look look)
  { content.legend.push_back(swatch(metrics, colorOf(look), meaningOf(look))); };
  const auto addIfThere = [&](Look look)
  {
    if (hasLook(styled, look)) add(look);
  };
  add(Look::Free);
  addIfThere(Look::Inferred);
  add(Look::Occupied);
  add(Look::Unknown);
  if (!styled.freeFor) return content;
  add(Look::Steep);
  addIfThere(Look::Drop);
  addIfThere(Look::Frontier);
  return content;
}

Content evidenceContent(const Layer<float>& layer, const Zoom& zoom, const Metrics& metrics)
{
  Content content;
  content.raster = rasterOfEvidence(layer, zoom);
  content.noData = std::none_of(layer.cells().begin(), layer.cells().end(),
                                [](float value) { return value > 0; });
  for (const EvidenceLook& look : kEvidenceLooks)
    content.legend.push_back(swatch(metrics, look.color, look.meaning));
  return content;
}

Content planeContent(const StyledLayer& styled, const Zoom& zoom, const Metrics& metrics)
{
  PlanePicture picture = drawPlanes(styled, zoom, metrics);
  return {std::move(picture.raster), std::move(picture.legend), picture.noData};
}

Content contentOf(const StyledLayer& styled, const Zoom& zoom, const Metrics& metrics)
{
  switch (styled.kind)
  {
    case LayerKind::Slope:
      return slopeContent(*styled.layer, styled.unit, zoom, metrics);
    case LayerKind::Occupancy:
      return occupancyContent(styled, zoom, metrics);
    case LayerKind::Evidence:
      return evidenceContent(*styled.layer, zoom, metrics);
    case LayerKind::Plane:
      return planeContent(styled, zoom, metrics);
    case LayerKind::Height:
      break;
  }
  return heightContent(styled, zoom, metrics);
}

/** "60 x 40 cells of 0.1 m; corners (-1.50, 2.00) and (4.50, 6.00) m" */
std::string describe(const GridFrame& frame)
{
  const int decimals = std::max(2, decimalsOf(frame.resolution));
  const auto corner = [decimals](double x, double y)
  { return "(" + number(x, decimals) + ", " + number(y, decimals) + ")"; };
  std::string cell = number(frame.resolution, 6);
  cell.erase(cell.find_last_not_of('0') + 1);
  if (cell.back() == '.') cell.pop_back();
  return std::to_string(frame.width) + " x " + std::to_string(frame.height) + " cells of " + cell +
         " m, corners " + corner(frame.xMin(), frame.yMin()) + " and " +
         corner(frame.xMax(), frame.yMax()) + " m";
}

void drawNoData(Canvas& canvas, int x, int y, int width, int height)
{
  const Metrics& m = canvas.metrics();
  const std::string text = "no data";
  const int textWidth = m.textWidth(text, Font::Title), textHeight = m.textHeight(Font::Title);
  if (textWidth > width || textHeight > height) return;  // the legend says it, too
  canvas.text(x + (width - textWidth) / 2, y + (height - textHeight) / 2, text, kInk, Font::Title);
}

/** Where a map's metres lie on a canvas. */
struct MapPlace
{
  const GridFrame& frame;
  double pixelsPerCell;
  int x, y, height;  // of the map's pixels

  int xOf(double metres) const
  {
    return x + static_cast<int>((metres - frame.xMin()) / frame.resolution * pixelsPerCell);
  }
  int yOf(double metres) const
  {
    return y + height - 1 -
           static_cast<int>((metres - frame.yMin()) / frame.resolution * pixelsPerCell);
  }
};

void drawPath(Canvas& canvas, const std::vector<mrpt::math::TPoint2D>& path, const MapPlace& place)
{
  if (path.empty()) return;
  const Metrics& m = canvas.metrics();
  const auto x = [&](std::size_t i) { return place.xOf(path[i].x); };
  const auto y = [&](std::size_t i) { return place.yOf(path[i].y); };
  for (std::size_t i = 1; i < path.size(); ++i)
    canvas.line(x(i - 1), y(i - 1), x(i), y(i), m.of(3), kPathColor);
  const std::size_t last = path.size() - 1;
  canvas.disc(x(last), y(last), m.of(7), kPathColor);
  canvas.disc(x(0), y(0), m.of(7), kPathColor);
  canvas.disc(x(0), y(0), m.of(4), kPaper);
}

void checkLayers(const StyledLayer& styled)
{
  if (!styled.layer || styled.layer->frame().empty())
    throw std::invalid_argument("picture: the layer has no cells");
  for (const auto* beside :
       {styled.freeFor, styled.evidence, styled.drops, styled.shade, styled.squares})
    if (beside && beside->frame() != styled.layer->frame())
      throw std::invalid_argument(
          "picture: the aerial layer, or one that goes with it, is on another frame than the "
          "layer");
}

/** Part of a layer, and of those that go with it. */
class Part
{
 public:
  Part(const StyledLayer& whole, const GridFrame& frame)
      : m_styled(whole), m_layer(whole.layer->onFrame(frame, unknownCell(whole.kind)))
  {
    m_styled.layer = &m_layer;
    if (whole.shade) m_styled.shade = &(m_shade = whole.shade->onFrame(frame, NAN));
    if (whole.squares) m_styled.squares = &(m_squares = whole.squares->onFrame(frame, NAN));
    if (!whole.freeFor) return;
    m_freeFor = whole.freeFor->onFrame(frame, kUnknown);
    m_styled.freeFor = &m_freeFor;
    if (whole.evidence) m_styled.evidence = &(m_evidence = whole.evidence->onFrame(frame, 0));
    if (whole.drops) m_styled.drops = &(m_drops = whole.drops->onFrame(frame, 0));
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  const StyledLayer& styled() const { return m_styled; }

 private:
  StyledLayer m_styled;
  Layer<float> m_layer, m_freeFor, m_evidence, m_drops, m_shade, m_squares;
};

/** Draws all of a layer, which may be part of a map. */
mrpt::img::CImage drawAll(const StyledLayer& styled, const PicturePath& path, const GridFrame& map)
{
  const Layer<float>& layer = *styled.layer;
  const Zoom zoom = zoomFor(layer.frame());
  const double pixelsPerCell = zoom.pixelsPerCell();
  const int longSide =
      static_cast<int>(std::max(layer.frame().width, layer.frame().height) * pixelsPerCell);
  constexpr int kLargePicture = 1500;  // seen as a whole on a screen, it is shown at half its size
  const Metrics m(longSide > kLargePicture ? 2 : 1);
  Content content = contentOf(styled, zoom, m);
  if (!path.points.empty()) content.legend.push_back(swatch(m, kPathColor, path.label));
  const Axes axes(m, layer.frame(), pixelsPerCell);
  const std::string description =
      describe(map) + (layer.frame() == map ? "" : "; shown is what is known");

  const int margin = m.of(24), gap = m.of(14);
  const int mapWidth = content.raster.width, mapHeight = content.raster.height;
  int inner = std::max({axes.leftMargin() + mapWidth + axes.rightMargin(), m.textWidth(description),
                        m.textWidth(styled.title, Font::Title), m.of(520)});
  for (const LegendItem& item : content.legend) inner = std::max(inner, item.width);

  std::vector<LegendItem> items = content.legend;
  items.push_back(scaleBar(m, pixelsPerCell / layer.frame().resolution, m.of(160)));
  const Legend legend(m, std::move(items), inner);

  const int titleY = margin;
  const int descriptionY = titleY + m.textHeight(Font::Title) + m.of(6);
  const int mapY = descriptionY + 5 * m.textHeight() / 2 + 2 * gap;
  const int legendY = mapY + mapHeight + axes.bottomMargin() + m.of(20);
  const int axesWidth = axes.leftMargin() + mapWidth + axes.rightMargin();
  const int mapX = margin + (inner - axesWidth) / 2 + axes.leftMargin();

  Canvas canvas(inner + 2 * margin, legendY + legend.height() + margin, m);
  canvas.text(margin, titleY, styled.title, kInk, Font::Title);
  canvas.text(margin, descriptionY, description, kFaintInk);
  canvas.raster(mapX, mapY, content.raster);
  axes.draw(canvas, mapX, mapY, mapWidth, mapHeight);
  drawPath(canvas, path.points, {layer.frame(), pixelsPerCell, mapX, mapY, mapHeight});
  if (content.noData) drawNoData(canvas, mapX, mapY, mapWidth, mapHeight);
  legend.draw(canvas, margin, legendY);
  return canvas.image();
}

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** Whether the file ends as every complete PNG does: by the checksum of its IEND chunk. */
bool isCompletePng(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  char tail[8] = {};
  file.seekg(-static_cast<std::streamoff>(sizeof(tail)), std::ios::end);
  file.read(tail, sizeof(tail));
  return file && std::string(tail, sizeof(tail)) == "IEND\xAE\x42\x60\x82";
}
}  // namespace

mrpt::img::CImage drawLayer(const StyledLayer& styled, const PicturePath& path,
                            const GridFrame& shown)
{
  checkLayers(styled);
  const GridFrame& whole = styled.layer->frame();
  const GridFrame frame = shown.empty() ? shownFrame({styled}) : shown;
  if (frame == whole) return drawAll(styled, path, whole);
  const Part part(styled, frame);
  return drawAll(part.styled(), path, whole);
}

void writeLayerPng(const std::string& file, const StyledLayer& layer, const PicturePath& path,
                   const GridFrame& shown)
{
  if (!endsWith(file, ".png"))
    throw std::invalid_argument("picture '" + file + "': the name must end in .png");
  const mrpt::img::CImage image = drawLayer(layer, path, shown);
  files::writeFile(file, {});  // gives the system's own reason; MRPT only says whether it worked
  image.saveToFile(file);
  requireCompletePng(file);
}

void requireCompletePng(const std::string& file)
{
  if (!isCompletePng(file)) files::throwUnwritten(file, "the PNG is incomplete");
}

}  // namespace mrpt_mapconv::grid
