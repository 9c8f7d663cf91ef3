#include "output/Scene.h"

#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt_mapconv/files/ObjectWriter.h>
#include <mrpt_mapconv/freespace/DropEdges.h>
#include <mrpt_mapconv/freespace/FreeSpaceScene.h>

#include <algorithm>
#include <cmath>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
using freespace::Layers;
using grid::GridFrame;

/** Lines on whole multiples of their distance, around the map; 1 m apart unless the map is large.
 */
mrpt::opengl::CGridPlaneXY::Ptr referenceGrid(const GridFrame& frame, double z)
{
  const double side = std::max(frame.xMax() - frame.xMin(), frame.yMax() - frame.yMin());
  constexpr double kMostLines = 100;
  const double step = std::max(1.0, std::pow(10.0, std::ceil(std::log10(side / kMostLines))));
  const auto down = [step](double v)
  { return static_cast<float>(step * std::floor(v / step - 1)); };
  const auto up = [step](double v) { return static_cast<float>(step * std::ceil(v / step + 1)); };
  auto plane = mrpt::opengl::CGridPlaneXY::Create(down(frame.xMin()), up(frame.xMax()),
                                                  down(frame.yMin()), up(frame.yMax()),
                                                  static_cast<float>(z), static_cast<float>(step));
  plane->setColor_u8(0xA0, 0xA0, 0xA0);
  plane->setName("grid");
  return plane;
}

/** Looks at the map's middle from the south, from above, with all of it in view. */
void setCamera(mrpt::opengl::COpenGLScene& scene, const GridFrame& frame, double z)
{
  const double width = frame.xMax() - frame.xMin(), depth = frame.yMax() - frame.yMin();
  auto& camera = scene.getViewport()->getCamera();
  camera.setPointingAt(mrpt::math::TPoint3D(frame.xMin() + width / 2, frame.yMin() + depth / 2, z));
  camera.setZoomDistance(static_cast<float>(std::max(2.0, 1.1 * std::hypot(width, depth))));
  camera.setAzimuthDegrees(-90);
  camera.setElevationDegrees(50);
}

mrpt::opengl::COpenGLScene sceneOf(const Layers& layers, const freespace::ConversionParams& params)
{
  const double below = grid::heightBelow(layers.floor);
  auto objects = mrpt::opengl::CSetOfObjects::Create();
  const auto edges = freespace::dropEdges(layers, params);
  const auto ground = grid::findLayer(layers.styled(edges), "ground");
  freespace::drawGround(layers, {}, ground, *objects);
  grid::drawOccupancy(layers.ground, below, false, *objects);

  auto scene = sceneWith(objects, layers.frame(), below);
  grid::drawLegend(ground, *scene.getViewport());
  return scene;
}

}  // namespace

mrpt::opengl::COpenGLScene sceneWith(const mrpt::opengl::CSetOfObjects::Ptr& objects,
                                     const GridFrame& frame, double z)
{
  mrpt::opengl::COpenGLScene scene;
  scene.insert(referenceGrid(frame, z - frame.resolution));
  scene.insert(objects);
  setCamera(scene, frame, z);
  return scene;
}

void writeScene(const std::string& path, const Layers& layers,
                const freespace::ConversionParams& params)
{
  files::writeObject(path, sceneOf(layers, params));
}

}  // namespace mapconv
