#include <mrpt_mapconv/freespace/FreeSpaceScene.h>

namespace mrpt_mapconv::freespace
{
void drawFreeSpace(const freespace::Layers& layers, const TLayerSceneOptions& options,
                   mrpt::opengl::CSetOfObjects& scene)
{
  const auto floor = layers.styled("floor"), ceiling = layers.styled("ceiling");
  if (options.showFloor)
    grid::drawSurface(floor, options.colorBySlope ? layers.styled("slope") : floor, scene);
  if (options.showCeiling) grid::drawSurface(ceiling, ceiling, scene);
}

}  // namespace mrpt_mapconv::freespace
