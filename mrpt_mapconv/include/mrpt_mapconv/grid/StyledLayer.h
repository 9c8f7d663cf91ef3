#pragma once

#include <mrpt_mapconv/grid/Layer.h>

#include <string>
#include <vector>

namespace mrpt_mapconv::grid
{
/** What the values of a layer mean, and so how they are coloured and exported. */
enum class LayerKind
{
  Height,     //!< heights; NaN: not known
  Slope,      //!< what counts from 0 up: slopes, deviations, numbers of points; NaN: not known
  Occupancy,  //!< 0 free, (0, 1] occupied, else unknown
  Evidence,   //!< 0 none, 1 seen, 2 inferred, 3 open, 4 wall, of what is known of the ground
  Plane,      //!< index of the plane that a cell lies in, from 0 on; NaN: none
};

/** The value of LayerKind::Evidence for inferred ground. */
constexpr float kInferredGround = 2;

/** A cell of which nothing is known. */
float unknownCell(LayerKind kind);
/** "height", "slope", "occupancy", "evidence" or "plane". */
const char* nameOf(LayerKind kind);

/** A layer and all that files, pictures and views say about it. It does not own the layer. */
struct StyledLayer
{
  std::string name;  //!< of its band in a file, of its own files and of its object in a 3D scene
  const Layer<float>* layer = nullptr;
  std::string title = {};  //!< over its picture
  std::string unit = {};   //!< of its values, e.g. "m"; occupancy has none
  LayerKind kind = LayerKind::Height;
  /** Only for Occupancy, on the same frame: a picture shows occupied cells that are free in this
   * layer as "too steep or too high a step (free for a flying robot)". */
  const Layer<float>* freeFor = nullptr;
  /** Only beside freeFor, on the same frame: of LayerKind::Evidence. A picture tints free cells
   * whose ground is inferred, and shows unknown ones that are free in freeFor as frontier. */
  const Layer<float>* evidence = nullptr;
  /** Only beside freeFor, on the same frame: cells that are not 0 are shown as drop edges. */
  const Layer<float>* drops = nullptr;
  /** Only for Plane, on the same frame: heights [m], NaN: not known. A picture shades cells without
   * a plane by them. */
  const Layer<float>* shade = nullptr;
  /** Only for Plane, on the same frame: side [m] of the square of 2^k cells that a cell lies in,
   * whose lower corner has keys that are divisible by 2^k; NaN: none. A picture outlines them. */
  const Layer<float>* squares = nullptr;
  /** Only for Height: a picture shows relief, as lit from the north-west. */
  bool hillShaded = false;
};

/** The layer of that name.
 * \exception std::invalid_argument if there is none */
const StyledLayer& findLayer(const std::vector<StyledLayer>& layers, const std::string& name);

}  // namespace mrpt_mapconv::grid
