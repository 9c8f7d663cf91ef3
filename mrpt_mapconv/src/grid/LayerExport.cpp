#include <mrpt_mapconv/grid/GridMap.h>
#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/grid/RosMap.h>

namespace mrpt_mapconv::grid
{
void exportLayers(files::OutputDir& out, const std::vector<StyledLayer>& layers,
                  const ExportFormats& formats, const std::function<void(double)>& progress)
{
  std::vector<std::function<void()>> jobs;
  const GridFrame shown = formats.pictures && !layers.empty() ? shownFrame(layers) : GridFrame();
  if (!formats.tiff.empty())
    jobs.emplace_back(
        [&] { writeGeoTiff(out.path(formats.tiff), layers, formats.metadata, formats.reference); });
  for (const StyledLayer& layer : layers)
  {
    const std::string name = formats.prefix + layer.name;
    if (formats.pictures)
      jobs.emplace_back([=, &out] { writeLayerPng(out.path(name + ".png"), layer, {}, shown); });
    if (layer.kind != LayerKind::Occupancy) continue;
    if (formats.gridMaps)
      jobs.emplace_back([=, &out] { writeGridMap(out.path(name + ".gridmap"), *layer.layer); });
    if (formats.rosMaps)
      jobs.emplace_back(
          [=, &out, &formats]
          {
            writeRosMap(out.path(name + ".pgm"), out.path(name + ".yaml"), name + ".pgm",
                        *layer.layer, formats.reference);
          });
  }
  for (std::size_t i = 0; i < jobs.size(); ++i)
  {
    jobs[i]();
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(jobs.size()));
  }
}

}  // namespace mrpt_mapconv::grid
