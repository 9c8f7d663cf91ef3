#pragma once

#include <mrpt/opengl/COpenGLViewport.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <vector>

// Layers in a 3D scene, in the map frame [m], made of MRPT's own objects: a scene file opens in
// SceneViewer3D without this library.

namespace mrpt_mapconv::grid
{
/** Adds a height as a surface through the cells' centres, named like the layer; cells without a
 * height leave a hole. Nothing if it has less than 2 x 2 cells.
 * \param colouredBy on the same frame, with the colours of its picture; may be the height itself.
 * With occupancy, free cells have the colours of heights, and lighter ones where their ground is
 * inferred. */
void drawSurface(const StyledLayer& height, const StyledLayer& colouredBy,
                 mrpt::opengl::CSetOfObjects& scene);

/** Adds an occupancy layer as MRPT draws a grid: a textured plane at height z [m], in which unknown
 * cells are transparent.
 * \param showFree false where a floor is drawn above: viewers cannot tell two sheets apart that lie
 * close together and far away */
void drawOccupancy(const Layer<float>& occupancy, double z, bool showFree,
                   mrpt::opengl::CSetOfObjects& scene);

/** A cell's side below the lowest value of a height [m], or below 0 if it has none: where the
 * occupancy is drawn under the height's surface. */
double heightBelow(const Layer<float>& height);

/** Writes over a view what the colours mean that a surface has from an occupancy layer, each that
 * there is in a line of its colour. */
void drawLegend(const StyledLayer& occupancy, mrpt::opengl::COpenGLViewport& view);

/** Adds an occupancy layer and, above it, the surfaces of all heights among the layers. */
void drawLayers(const std::vector<StyledLayer>& layers, const Layer<float>& occupancy,
                mrpt::opengl::CSetOfObjects& scene);

}  // namespace mrpt_mapconv::grid
