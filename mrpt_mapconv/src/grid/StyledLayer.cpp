#include <mrpt_mapconv/grid/OccupancyCell.h>
#include <mrpt_mapconv/grid/StyledLayer.h>

#include <limits>
#include <stdexcept>

namespace mrpt_mapconv::grid
{
float unknownCell(LayerKind kind)
{
  if (kind == LayerKind::Evidence) return 0;
  return kind == LayerKind::Occupancy ? kUnknown : std::numeric_limits<float>::quiet_NaN();
}

const char* nameOf(LayerKind kind)
{
  switch (kind)
  {
    case LayerKind::Slope:
      return "slope";
    case LayerKind::Occupancy:
      return "occupancy";
    case LayerKind::Evidence:
      return "evidence";
    case LayerKind::Plane:
      return "plane";
    case LayerKind::Height:
      break;
  }
  return "height";
}

const StyledLayer& findLayer(const std::vector<StyledLayer>& layers, const std::string& name)
{
  const auto found = std::find_if(layers.begin(), layers.end(),
                                  [&](const StyledLayer& layer) { return layer.name == name; });
  if (found == layers.end()) throw std::invalid_argument("there is no layer '" + name + "'");
  return *found;
}

}  // namespace mrpt_mapconv::grid
