#include <mrpt_mapconv/freespace/FreeSpaceScene.h>

#include <cmath>

namespace mrpt_mapconv::freespace
{
namespace
{
/** The support, or the floor where there is none. */
grid::Layer<float> groundOf(const Layers& layers)
{
  auto ground = layers.support;
  for (std::size_t i = 0; i < ground.cells().size(); ++i)
    if (std::isnan(ground.cells()[i])) ground.cells()[i] = layers.floor.cells()[i];
  return ground;
}

void draw(const Layers& layers, const TLayerSceneOptions& options, const grid::StyledLayer& floor,
          const grid::StyledLayer& colouredBy, mrpt::opengl::CSetOfObjects& scene)
{
  if (options.showFloor)
    grid::drawSurface(floor, options.colorBySlope ? layers.styled("slope") : colouredBy, scene);
  const auto ceiling = layers.styled("ceiling");
  if (options.showCeiling) grid::drawSurface(ceiling, ceiling, scene);
}
}  // namespace

void drawFreeSpace(const Layers& layers, const TLayerSceneOptions& options,
                   mrpt::opengl::CSetOfObjects& scene)
{
  const auto floor = layers.styled("floor");
  draw(layers, options, floor, floor, scene);
}

void drawGround(const Layers& layers, const TLayerSceneOptions& options,
                const grid::StyledLayer& occupancy, mrpt::opengl::CSetOfObjects& scene)
{
  const auto ground = groundOf(layers);
  auto floor = layers.styled("floor");
  floor.layer = &ground;
  draw(layers, options, floor, occupancy, scene);
}

}  // namespace mrpt_mapconv::freespace
