#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/maps/LayerFiles.h>

#include <stdexcept>

namespace mrpt_mapconv::maps
{
namespace
{
grid::PictureStyle styleOf(const std::string& name)
{
  using Kind = grid::PictureKind;
  if (name == "floor") return {"Floor: bottom of the lowest free range", "m", Kind::Height};
  if (name == "ceiling") return {"Ceiling: top of the highest free range", "m", Kind::Height};
  if (name == "slope") return {"Slope of the floor", "m/m", Kind::Slope};
  if (name == "aerial") return {"Occupancy for an aerial robot", "", Kind::Occupancy};
  if (name == "ground") return {"Occupancy for a ground robot", "", Kind::Occupancy};
  throw std::invalid_argument("there is no layer '" + name + "'");
}
}  // namespace

void writeLayersTiff(const std::string& path, const freespace::Layers& layers)
{
  std::vector<grid::NamedLayer> bands;
  for (const auto& [name, layer] : layers.named()) bands.push_back({name, layer});
  grid::writeGeoTiff(path, bands);
}

void writeLayerPicture(const std::string& path, const freespace::Layers& layers,
                       const std::string& name)
{
  const auto style = styleOf(name);
  for (const auto& [layerName, layer] : layers.named())
    if (layerName == name)
      grid::writeLayerPng(path, *layer, style, name == "ground" ? &layers.aerial : nullptr);
}

}  // namespace mrpt_mapconv::maps
