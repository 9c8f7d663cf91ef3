#pragma once

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <string>

namespace mapconv
{
/** A scene with these objects, a reference grid below them and a camera that has all in view.
 * \param z where the map's lowest objects lie [m] */
mrpt::opengl::COpenGLScene sceneWith(const mrpt::opengl::CSetOfObjects::Ptr& objects,
                                     const mrpt_mapconv::grid::GridFrame& frame, double z);

/** Writes a `.3Dscene`: the ground as a surface, coloured by where a ground robot may go, its
 * occupancy below, a legend and a reference grid. Made of MRPT's own objects, so SceneViewer3D
 * opens it without this library. \exception std::runtime_error naming the file and the reason if it
 * cannot be written */
void writeScene(const std::string& path, const mrpt_mapconv::freespace::Layers& layers,
                const mrpt_mapconv::freespace::ConversionParams& params);

}  // namespace mapconv
