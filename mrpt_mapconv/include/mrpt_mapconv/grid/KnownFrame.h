#pragma once

#include <mrpt_mapconv/grid/StyledLayer.h>

#include <vector>

namespace mrpt_mapconv::grid
{
/** The smallest frame that holds all cells of which anything is known; without cells if there are
 * none. */
GridFrame knownFrame(const Layer<float>& layer, LayerKind kind);

/** What pictures show of layers: all that is known in any of them and a margin of a twentieth of
 * its long side, at least 2 cells, as far as the layers reach; all of them if nothing is known.
 * \param layers on one frame; at least one */
GridFrame shownFrame(const std::vector<StyledLayer>& layers);

}  // namespace mrpt_mapconv::grid
