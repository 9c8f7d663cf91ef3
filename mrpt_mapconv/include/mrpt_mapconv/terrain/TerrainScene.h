#pragma once

#include <mrpt/opengl/COpenGLViewport.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt_mapconv/terrain/TerrainMap.h>
#include <mrpt_mapconv/terrain/TerrainOptions.h>

namespace mrpt_mapconv::terrain
{
/** Adds the leaves of a map to a 3D scene, in the map frame [m], made of MRPT's own objects, so
 * that a scene file opens in SceneViewer3D without this library: "planes", the leaves that lie in
 * planes, tilted like them and with the colours of the leaves' picture; "outlines", their edges;
 * and "cells", those without a plane, level and grey. \param planes the map's layer of that name */
void drawLeaves(const TerrainMap& map, const grid::Layer<float>& planes,
                const TTerrainSceneOptions& options, mrpt::opengl::CSetOfObjects& scene);

/** Writes over a view what the colours mean. */
void drawLegend(const TerrainMap& map, mrpt::opengl::COpenGLViewport& view);

}  // namespace mrpt_mapconv::terrain
