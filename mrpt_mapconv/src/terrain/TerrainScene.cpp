#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt_mapconv/grid/PlaneColors.h>
#include <mrpt_mapconv/params/Text.h>
#include <mrpt_mapconv/terrain/TerrainScene.h>

#include <algorithm>
#include <array>
#include <limits>

namespace mrpt_mapconv::terrain
{
namespace
{
using mrpt::math::TPoint3D;
using mrpt::math::TPoint3Df;
using mrpt::opengl::CSetOfTriangles;

/** The corners of a leaf, counterclockwise from the lower one. */
using Corners = std::array<TPoint3D, 4>;

Corners cornersOf(const TerrainLeaf& leaf, const TerrainMap& map)
{
  const double size = map.resolution();
  const double x0 = (leaf.x - 0.5) * size, x1 = x0 + leaf.side * size;
  const double y0 = (leaf.y - 0.5) * size, y1 = y0 + leaf.side * size;
  Corners corners{{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}};
  for (TPoint3D& corner : corners)
    corner.z =
        leaf.plane < 0
            ? leaf.height
            : map.planes().at(static_cast<std::size_t>(leaf.plane)).heightAt(corner.x, corner.y);
  return corners;
}

void addSquare(const Corners& corners, const mrpt::img::TColor& color, CSetOfTriangles& out)
{
  const auto corner = [&](std::size_t i) { return TPoint3Df(corners.at(i)); };
  for (const auto& [a, b, c] : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}})
  {
    mrpt::opengl::TTriangle triangle(corner(a), corner(b), corner(c));
    triangle.setColor(color);
    out.insertTriangle(triangle);
  }
}

/** Above their leaf, as far as viewers with coarse depths need to tell them apart. */
void addOutline(Corners corners, double cellSize, mrpt::opengl::CSetOfLines& out)
{
  const double above = 0.2 * cellSize;
  for (TPoint3D& corner : corners) corner.z += above;
  for (std::size_t i = 0; i < corners.size(); ++i)
    out.appendLine(corners[i], corners[(i + 1) % corners.size()]);
}

/** The range of the heights of leaves without a plane, for their greys. */
struct Greys
{
  double low = std::numeric_limits<double>::infinity(), high = -low;

  explicit Greys(const std::vector<TerrainLeaf>& leaves)
  {
    for (const TerrainLeaf& leaf : leaves)
      if (leaf.plane < 0)
      {
        low = std::min(low, leaf.height);
        high = std::max(high, leaf.height);
      }
  }
  mrpt::img::TColor of(double height) const
  {
    return grid::picture::bareColor(high > low ? (height - low) / (high - low) : 0.5);
  }
};

std::vector<TerrainLeaf> allLeaves(const TerrainMap& map)
{
  const grid::GridFrame frame = map.frame();
  if (frame.empty()) return {};
  return map.leavesIn(frame.xMin(), frame.yMin(), frame.xMax(), frame.yMax());
}
}  // namespace

void drawLeaves(const TerrainMap& map, const grid::Layer<float>& planes,
                const TTerrainSceneOptions& options, mrpt::opengl::CSetOfObjects& scene)
{
  const std::vector<TerrainLeaf> leaves = allLeaves(map);
  const grid::picture::PlaneColors colors(planes);
  const Greys greys(leaves);
  auto inPlanes = CSetOfTriangles::Create(), cells = CSetOfTriangles::Create();
  auto outlines = mrpt::opengl::CSetOfLines::Create();
  inPlanes->setName("planes");
  cells->setName("cells");
  outlines->setName("outlines");
  outlines->setColor_u8(40, 40, 40);
  outlines->setLineWidth(1.0f);
  for (const TerrainLeaf& leaf : leaves)
  {
    const Corners corners = cornersOf(leaf, map);
    if (leaf.plane < 0)
    {
      addSquare(corners, greys.of(leaf.height), *cells);
      continue;
    }
    addSquare(corners, colors.of(leaf.plane), *inPlanes);
    if (options.showOutlines) addOutline(corners, map.resolution(), *outlines);
  }
  if (!inPlanes->getTrianglesCount() && !cells->getTrianglesCount()) return;
  if (options.showLeaves)
  {
    scene.insert(inPlanes);
    scene.insert(cells);
  }
  if (options.showOutlines) scene.insert(outlines);
}

void drawLegend(const TerrainMap& map, mrpt::opengl::COpenGLViewport& view)
{
  mrpt::opengl::TFontParams font;
  font.vfont_scale = 14;
  font.draw_shadow = true;
  font.color = mrpt::img::TColorf(1, 1, 1);
  view.addTextMessage(10, 10,
                      params::counted(map.planes().size(), "plane") +
                          ", whose colours only tell neighbours apart; grey: no plane",
                      0, font);
}

}  // namespace mrpt_mapconv::terrain
