#include <mrpt_mapconv/freespace/LayerFiles.h>

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace mrpt_mapconv::freespace
{
namespace
{
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

grid::Metadata metadataOf(const freespace::ConversionParams& params)
{
  return {{"minClearance", textOf(params.minClearance)},
          {"minOccupancy", textOf(params.minOccupancy)},
          {"slopeWindow", textOf(params.slopeWindow)},
          {"maxSlope", textOf(params.maxSlope)},
          {"maxStep", textOf(params.maxStep)}};
}

void writeLayersTiff(const std::string& path, const freespace::Layers& layers,
                     const freespace::ConversionParams& params)
{
  grid::writeGeoTiff(path, layers.styled(), metadataOf(params));
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
  for (const auto& entry : Layers::list())
    file.layers.*entry.member = grid::readGeoTiffBand(path, entry.name);
  return file;
}

}  // namespace mrpt_mapconv::freespace
