#include <mrpt_mapconv/freespace/LayerFiles.h>

#include <stdexcept>

namespace mrpt_mapconv::freespace
{
namespace
{
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

ConversionParams paramsFrom(const grid::Metadata& items, const std::string& path)
{
  ConversionParams params = ConversionParams::ofOlderFiles();
  ConversionParams::visit(
      params,
      [&](const char* name, auto&& value, const char*, const char*, params::About about = {})
      {
        const std::string* text = itemOf(items, name, about, path);
        if (text && !params::setFromText(*text, value))
          throw std::runtime_error("cannot read '" + path + "': its " + name + " = '" + *text +
                                   "' is not valid: it must be " + params::rightTextOf(value));
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
/** What the files of versions that knew no evidence mean. */
void takeFloorForGround(Layers& layers)
{
  layers.support = layers.floor;
  layers.evidence = {layers.frame(), grid::unknownCell(grid::LayerKind::Evidence)};
}
}  // namespace

grid::Metadata metadataOf(const freespace::ConversionParams& params)
{
  return grid::metadataOf(params);
}

void writeLayersTiff(const std::string& path, const freespace::Layers& layers,
                     const freespace::ConversionParams& params)
{
  grid::writeGeoTiff(path, layers.styled(), metadataOf(params));
}

LayersFile readLayersTiff(const std::string& path)
{
  LayersFile file;
  const grid::Metadata items = grid::readGeoTiffMetadata(path);
  file.params = paramsFrom(items, path);
  file.reference = grid::readGeoReference(path);
  const bool hasGround = items.count("floorFrom") != 0;
  for (const auto& entry : Layers::list())
    if (hasGround || !entry.isOfGround())
      file.layers.*entry.member = grid::readGeoTiffBand(path, entry.name);
  if (!hasGround) takeFloorForGround(file.layers);
  return file;
}

}  // namespace mrpt_mapconv::freespace
