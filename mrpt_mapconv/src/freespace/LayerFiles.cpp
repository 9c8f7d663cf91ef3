#include <mrpt_mapconv/freespace/LayerFiles.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/grid/LayerPicture.h>

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>
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

/** The shortest text that reads back as the same number. */
template <class Number>
std::string textOf(Number value)
{
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/** The parameters in a file's metadata. */
class ParamsReader
{
 public:
  explicit ParamsReader(std::string path)
      : m_path(std::move(path)), m_items(grid::readGeoTiffMetadata(m_path))
  {
  }

  template <class Number>
  void read(const std::string& name, Number& value) const
  {
    const auto item = m_items.find(name);
    if (item == m_items.end())
      throw std::runtime_error("cannot read '" + m_path + "': it does not say " + name +
                               ", so it was not made by mapconv convert");
    const std::string& text = item->second;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      throw std::runtime_error("cannot read '" + m_path + "': its " + name + " = '" + text +
                               "' is no number");
  }

 private:
  std::string m_path;
  grid::Metadata m_items;
};
}  // namespace

void writeLayersTiff(const std::string& path, const freespace::Layers& layers,
                     const freespace::ConversionParams& params)
{
  std::vector<grid::NamedLayer> bands;
  for (const auto& [name, layer] : layers.named()) bands.push_back({name, layer});
  grid::writeGeoTiff(path, bands,
                     {{"minClearance", textOf(params.minClearance)},
                      {"minOccupancy", textOf(params.minOccupancy)},
                      {"slopeWindow", textOf(params.slopeWindow)},
                      {"maxSlope", textOf(params.maxSlope)},
                      {"maxStep", textOf(params.maxStep)}});
}

LayersFile readLayersTiff(const std::string& path)
{
  LayersFile file;
  ParamsReader params(path);
  params.read("minClearance", file.params.minClearance);
  params.read("minOccupancy", file.params.minOccupancy);
  params.read("slopeWindow", file.params.slopeWindow);
  params.read("maxSlope", file.params.maxSlope);
  params.read("maxStep", file.params.maxStep);
  try
  {
    file.params.check();
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error("cannot read '" + path + "': its " + error.what());
  }
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
