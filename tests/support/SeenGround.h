#pragma once

#include <mrpt_mapconv/freespace/Evidence.h>
#include <mrpt_mapconv/freespace/Layers.h>

#include <cmath>

namespace mrpt_mapconv::test
{
/** Layers made by hand, of which the ground is the floor and was seen wherever there is one. */
inline freespace::Layers withSeenGround(freespace::Layers layers)
{
  layers.support = layers.floor;
  for (std::size_t cell = 0; cell < layers.floor.cells().size(); ++cell)
    if (!std::isnan(layers.floor.cells()[cell]))
      layers.evidence.cells()[cell] = freespace::evidence::kSeen;
  return layers;
}

}  // namespace mrpt_mapconv::test
