#include "output/PathScene.h"

#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt_mapconv/files/ObjectWriter.h>
#include <mrpt_mapconv/freespace/FreeSpaceScene.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/grid/PictureColors.h>
#include <octomap/OcTree.h>

#include <algorithm>

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
/** The occupied leaves whose top is not above zMax, coloured by height. */
mrpt::opengl::COctoMapVoxels::Ptr occupiedVoxels(const octomap::OcTree& tree, double zMax)
{
  struct Leaf
  {
    octomap::point3d centre;
    double side;
  };
  std::vector<Leaf> leaves;
  double low = zMax, high = -1e9;
  for (auto it = tree.begin_leafs(), end = tree.end_leafs(); it != end; ++it)
  {
    const double top = it.getZ() + it.getSize() / 2;
    if (!tree.isNodeOccupied(*it) || top > zMax) continue;
    leaves.push_back({it.getCoordinate(), it.getSize()});
    low = std::min(low, top);
    high = std::max(high, top);
  }
  auto voxels = mrpt::opengl::COctoMapVoxels::Create();
  voxels->setVisualizationMode(mrpt::opengl::COctoMapVoxels::FIXED);
  voxels->enableLights(true);
  voxels->resizeVoxelSets(1);
  voxels->reserveVoxels(0, leaves.size());
  const double span = std::max(high - low, 1e-3);
  for (const auto& [centre, side] : leaves)
    voxels->push_back_Voxel(0, {mrpt::math::TPoint3Df(centre.x(), centre.y(), centre.z()), side,
                                grid::picture::heightColor((centre.z() + side / 2 - low) / span)});
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  tree.getMetricMin(x0, y0, z0);
  tree.getMetricMax(x1, y1, z1);
  voxels->setBoundingBox({x0, y0, z0}, {x1, y1, z1});
  voxels->sort_voxels_by_z();
  voxels->setName("voxels");
  return voxels;
}

mrpt::opengl::CSphere::Ptr ball(const mrpt::math::TPoint3D& place, double radius,
                                const mrpt::img::TColor& color, const std::string& name)
{
  auto sphere = mrpt::opengl::CSphere::Create(static_cast<float>(radius));
  sphere->setColor_u8(color);
  sphere->setLocation(place);
  sphere->setName(name);
  return sphere;
}

void insertPath(mrpt::opengl::COpenGLScene& scene, const path::LiftedPath& path, double resolution)
{
  constexpr mrpt::img::TColor kPath{220, 20, 60}, kStart{255, 255, 255};
  auto lines = mrpt::opengl::CSetOfLines::Create();
  lines->setColor_u8(kPath);
  lines->setLineWidth(4);
  lines->setName("path");
  // Most drivers draw lines one pixel wide: a bundle of them is seen better.
  const double apart = 0.1 * resolution;
  for (const mrpt::math::TPoint3D& offset : {mrpt::math::TPoint3D(0, 0, 0),
                                             {apart, 0, 0},
                                             {-apart, 0, 0},
                                             {0, apart, 0},
                                             {0, -apart, 0},
                                             {0, 0, apart},
                                             {0, 0, -apart}})
    for (std::size_t i = 1; i < path.points.size(); ++i)
      lines->appendLine(path.points[i - 1].position + offset, path.points[i].position + offset);
  scene.insert(lines);
  scene.insert(ball(path.points.front().position, 1.5 * resolution, kStart, "start"));
  scene.insert(ball(path.points.back().position, 1.5 * resolution, kPath, "goal"));
}
}  // namespace

void writePathScene(const std::string& file, const freespace::Layers& layers,
                    const grid::StyledLayer& occupancy, const octomap::AbstractOcTree* octree,
                    const path::LiftedPath& path)
{
  double highest = path.points.front().position.z;
  for (const auto& point : path.points) highest = std::max(highest, point.position.z);
  mrpt::opengl::COpenGLScene scene;
  if (const auto* tree = dynamic_cast<const octomap::OcTree*>(octree))
  {
    constexpr double kShownAbovePath = 1.0;
    scene.insert(occupiedVoxels(*tree, highest + kShownAbovePath));
  }
  else
  {
    auto objects = mrpt::opengl::CSetOfObjects::Create();
    const bool ground = occupancy.freeFor != nullptr;  // of a layer for ground robots
    if (ground)
    {
      freespace::drawGround(layers, {}, occupancy, *objects);
      grid::drawLegend(occupancy, *scene.getViewport());
    }
    else
      freespace::drawFreeSpace(layers, {}, *objects);
    scene.insert(objects);
  }
  insertPath(scene, path, layers.frame().resolution);
  files::writeObject(file, scene);
}

}  // namespace mapconv
