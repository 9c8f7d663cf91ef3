#pragma once

#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/params/Fields.h>

namespace mrpt_mapconv::freespace
{
/** What drawLayers() shows. */
struct TLayerSceneOptions
{
  bool showFloor = true;
  bool showCeiling = false;
  bool colorBySlope = false;  //!< colour the floor by its slope instead of its height

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("showFloor", o.showFloor, "", "draw the floor as a surface");
    v("showCeiling", o.showCeiling, "", "draw the ceiling, too");
    v("colorBySlope", o.colorBySlope, "", "colour the floor by its slope instead of its height");
  }
};

/** Adds the floor (and the ceiling) to a 3D scene, as surfaces in the map frame [m] made of MRPT's
 * own objects, so that a scene file opens in SceneViewer3D without this library. */
void drawLayers(const freespace::Layers& layers, const TLayerSceneOptions& options,
                mrpt::opengl::CSetOfObjects& scene);

/** Adds an occupancy layer as MRPT draws a grid: a textured plane at height z [m], in which unknown
 * cells are transparent.
 * \param showFree false where a floor is drawn above: viewers cannot tell two sheets apart that lie
 * close together and far away */
void drawOccupancy(const grid::Layer<float>& occupancy, double z, bool showFree,
                   mrpt::opengl::CSetOfObjects& scene);

/** A voxel below the lowest floor [m], where the occupancy is drawn under the floor's surface. */
double heightBelow(const freespace::Layers& layers);

}  // namespace mrpt_mapconv::freespace
