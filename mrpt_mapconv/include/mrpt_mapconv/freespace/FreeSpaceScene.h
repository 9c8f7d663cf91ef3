#pragma once

#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt_mapconv/freespace/Layers.h>
#include <mrpt_mapconv/grid/LayerScene.h>
#include <mrpt_mapconv/params/Fields.h>

namespace mrpt_mapconv::freespace
{
/** What drawFreeSpace() shows. */
struct TLayerSceneOptions
{
  bool showFloor = true;
  bool showCeiling = false;
  bool colorBySlope = false;  //!< colour the floor by the slope of the ground

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("showFloor", o.showFloor, "", "draw the floor as a surface");
    v("showCeiling", o.showCeiling, "", "draw the ceiling, too");
    v("colorBySlope", o.colorBySlope, "",
      "colour the floor by the slope of the ground instead of its height");
  }
};

/** Adds the floor (and the ceiling) to a 3D scene, as surfaces in the map frame [m] made of MRPT's
 * own objects, so that a scene file opens in SceneViewer3D without this library. */
void drawFreeSpace(const Layers& layers, const TLayerSceneOptions& options,
                   mrpt::opengl::CSetOfObjects& scene);

/** The same for a ground robot: the floor lies on the support where there is one.
 * \param occupancy the ground layer with its drop edges (see Layers::styled()): where it is not
 * free, or the ground is inferred, its colours stand instead of the height's */
void drawGround(const Layers& layers, const TLayerSceneOptions& options,
                const grid::StyledLayer& occupancy, mrpt::opengl::CSetOfObjects& scene);

}  // namespace mrpt_mapconv::freespace
