#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/LayerPicture.h>

#include <stdexcept>
#include <vector>

namespace mrpt_mapconv::freespace
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

/** The text of a parameter in a file's metadata; nothing if it came later than the file.
 * \exception std::runtime_error if it should be there */
const std::string* itemOf(const grid::Metadata& items, const std::string& name,
                          const params::About& about, const std::string& path)
{
  const auto item = items.find(name);
  if (item != items.end()) return &item->second;
  if (about.sinceVersion > 0) return nullptr;
  throw std::runtime_error("cannot read '" + path + "': it does not say " + name +
                           ", so it was not made by mapconv convert");
}

ConversionParams readParams(const std::string& path)
{
  const grid::Metadata items = grid::readGeoTiffMetadata(path);
  ConversionParams params;
  ConversionParams::visit(
      params,
      [&](const char* name, auto& value, const char*, const char*, params::About about = {})
      {
        const std::string* text = itemOf(items, name, about, path);
        if (text && !params::readWhole(*text, value))
          throw std::runtime_error("cannot read '" + path + "': its " + name + " = '" + *text +
                                   "' is no number");
      });
  try
  {
    params.check();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("cannot read '" + path + "': its " + error.what());
  }
  return params;
}
}  // namespace

void writeLayersTiff(const std::string& path, const freespace::Layers& layers,
                     const freespace::ConversionParams& params)
{
  std::vector<grid::NamedLayer> bands;
  for (const auto& [name, layer] : layers.named()) bands.push_back({name, layer});
  grid::Metadata items;
  params::forEachText(
      params, [&items](const char* name, const std::string& text) { items.emplace(name, text); });
  grid::writeGeoTiff(path, bands, items);
}

LayersFile readLayersTiff(const std::string& path)
{
  LayersFile file;
  file.params = readParams(path);
  auto& layers = file.layers;
  layers.floor = grid::readGeoTiffBand(path, "floor");
  layers.ceiling = grid::readGeoTiffBand(path, "ceiling");
  layers.slope = grid::readGeoTiffBand(path, "slope");
  layers.aerial = grid::readGeoTiffBand(path, "aerial");
  layers.ground = grid::readGeoTiffBand(path, "ground");
  return file;
}

void writeLayerPicture(const std::string& path, const freespace::Layers& layers,
                       const std::string& name)
{
  const auto style = styleOf(name);
  for (const auto& [layerName, layer] : layers.named())
    if (layerName == name)
      grid::writeLayerPng(path, *layer, style, name == "ground" ? &layers.aerial : nullptr);
}

}  // namespace mrpt_mapconv::freespace
